// Classification of lines.
#include "problems/files/abaqus/abaqus_text.hpp"

#include <algorithm>
#include <cctype>

#include <fmt/format.h>

#include "problems/files/abaqus/abaqus_keywords.hpp"
#include "support/input_error.hpp"

namespace kusabi::problems {
namespace {

bool is_comment(std::string_view line) {
  const auto text = trimmed(line);
  return text.empty() || text.starts_with("**");
}

bool is_keyword(std::string_view line) {
  return trimmed(line).starts_with('*');
}

/// Adds the fields of the line from `first` on as parameters.
void add_parameters(const MeshText& line, std::size_t first, AbaqusCard& card) {
  for (std::size_t i = first; i < line.fields(); ++i) {
    const auto field = line.field(i);
    const auto sign = field.find('=');
    const bool has_value = sign != std::string_view::npos;
    auto value = has_value ? trimmed(field.substr(sign + 1)) : std::string_view();
    if (value.size() > 1 && value.starts_with('"') && value.ends_with('"')) {
      value = value.substr(1, value.size() - 2);
    }
    card.parameters.emplace_back(capitals(trimmed(field.substr(0, sign))), value);
  }
}

/// The keyword of a line: *SOLID SECTION for "*Solid  section".
std::string keyword_in(const MeshText& line) {
  return canonical_keyword(line.field(0));
}

const std::string& included_name(const MeshText& line, const AbaqusCard& card) {
  const auto* name = card.find("INPUT");
  if (name == nullptr || name->empty()) {
    line.fail("*INCLUDE without a file; expected *INCLUDE, INPUT=FILE");
  }
  return *name;
}

}  // namespace

std::string capitals(std::string_view text) {
  std::string result(text);
  for (char& character : result) {
    character = static_cast<char>(std::toupper(static_cast<unsigned char>(character)));
  }
  return result;
}

const std::string* AbaqusCard::find(std::string_view name) const {
  const auto found =
      std::ranges::find_if(parameters, [&](const auto& own) { return own.first == name; });
  return found == parameters.end() ? nullptr : &found->second;
}

AbaqusText::AbaqusText(const MeshTexts& texts, const std::string& place) : texts_(texts) {
  open(place);
}

void AbaqusText::open(const std::string& place) {
  const std::string* text = texts_.text(place);
  const std::string name = texts_.name(place);
  if (text == nullptr) {
    throw support::InputError(name, {}, "the file was not read along with the problem file");
  }
  const auto known = std::ranges::find(files_, name);
  const auto file = static_cast<int>(known - files_.begin());
  if (known == files_.end()) files_.push_back(name);
  open_.push_back({place, file, std::make_unique<MeshText>(*text, name, ",")});
}

bool AbaqusText::next_line() {
  if (put_back_) {
    put_back_ = false;
    return true;
  }
  while (true) {
    if (!open_.back().text->next_line()) {
      if (open_.size() == 1) return false;
      open_.pop_back();
    } else if (!is_comment(line().line())) {
      if (!is_keyword(line().line()) || keyword_in(line()) != "*INCLUDE") return true;
      include();
    }
  }
}

void AbaqusText::include() {
  const AbaqusCard own = card();
  const auto place = MeshTexts::place(open_.back().place, included_name(line(), own));
  const bool itself =
      std::ranges::any_of(open_, [&](const Open& one) { return one.place == place; });
  if (itself || open_.size() >= max_nested_files || ++included_ > max_included_files) {
    line().fail(
        fmt::format("{} includes itself, or too many files; expected at most {} that "
                    "include each other, and {} in all",
                    support::in_quotes(place), max_nested_files, max_included_files));
  }
  open(place);
}

// A line that ends in a comma is continued in the next one.
AbaqusCard AbaqusText::card() {
  AbaqusCard result{keyword_in(line()), {}, here()};
  add_parameters(line(), 1, result);
  while (trimmed(line().line()).ends_with(',')) {
    if (!open_.back().text->next_line() || is_keyword(line().line())) {
      line().fail("a keyword line that ends in a comma; expected more parameters on the next");
    }
    add_parameters(line(), 0, result);
  }
  return result;
}

bool AbaqusText::next_card(AbaqusCard& result) {
  if (!next_line()) return false;
  if (!is_keyword(line().line())) {
    line().fail(0, "a data line without a keyword; expected a line *KEYWORD before it");
  }
  result = card();
  return true;
}

bool AbaqusText::next_data() {
  if (!next_line()) return false;
  put_back_ = is_keyword(line().line());
  return !put_back_;
}

void AbaqusText::warn(const std::string& what, MeshPlace at) {
  const auto known = std::ranges::find(warnings_, what, &Warning::what);
  if (known == warnings_.end()) {
    warnings_.push_back({what, at});
  } else {
    ++known->count;
  }
}

std::vector<std::string> AbaqusText::warnings() const {
  std::vector<std::string> result;
  for (const Warning& warning : warnings_) {
    result.push_back(fmt::format(
        "{}:{}: {}{}", files_[static_cast<std::size_t>(warning.at.file)], warning.at.line,
        warning.what, warning.count == 1 ? "" : fmt::format(" ({} times)", warning.count)));
  }
  return result;
}

std::vector<std::pair<std::string, int>> abaqus_includes(std::string_view text,
                                                         const std::string& file) {
  std::vector<std::pair<std::string, int>> names;
  MeshText lines(text, file, ",");
  while (lines.next_line()) {
    if (is_comment(lines.line()) || !is_keyword(lines.line())) continue;
    AbaqusCard card{keyword_in(lines), {}, {}};
    if (card.keyword != "*INCLUDE") continue;
    add_parameters(lines, 1, card);
    if (trimmed(lines.line()).ends_with(',') && lines.next_line()) add_parameters(lines, 0, card);
    names.emplace_back(included_name(lines, card), lines.number());
  }
  return names;
}

}  // namespace kusabi::problems
