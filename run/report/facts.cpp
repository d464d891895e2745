// All keys of an object are shown, since the file may be of another version.
#include "run/report/facts.hpp"

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "support/exact_count.hpp"
#include "support/rounded_bounds.hpp"

namespace kusabi::run {
namespace {

using pictures::Markup;

constexpr std::string_view nothing = "–";
constexpr std::size_t longest_list = 8;

std::string with_spaces(std::string text) {
  for (char& c : text) {
    if (c == '_') c = ' ';
  }
  return text;
}

std::string text_of(const ResultJson& number, int digits, Rounding rounding) {
  if (!number.is_number_float() || digits == all_digits) return number.dump();
  const auto value = number.get<double>();
  switch (rounding) {
    case Rounding::down:
      return support::rounded_down(value, digits);
    case Rounding::up:
      return support::rounded_up(value, digits);
    case Rounding::nearest:
      break;
  }
  return fmt::format("{:.{}g}", value, digits);
}

void add_value(Markup& page, const ResultJson& value, Rounding rounding = Rounding::nearest) {
  if (value.is_number()) {
    add_number(page, &value, many_digits, rounding);
  } else if (value.is_string()) {
    page.words(value.get<std::string>());
  } else if (value.is_boolean()) {
    page.words(value.get<bool>() ? "yes" : "no");
  } else if (value.is_array() &&
             (value.size() > longest_list ||
              std::ranges::any_of(value, [](const auto& each) { return each.is_structured(); }))) {
    page.words(fmt::format("{} in the result file", value.size()));
  } else if (value.is_array() && !value.empty()) {
    for (std::size_t i = 0; i < value.size(); ++i) {
      if (i > 0) page.words(", ");
      add_value(page, value[i]);
    }
  } else {
    page.words(nothing);
  }
}

void add_rows(Markup& page, const std::string& before, const ResultJson& object) {
  for (const auto& [key, value] : object.items()) {
    const auto name = before + with_spaces(key);
    if (value.is_object() && !value.empty()) {
      add_rows(page, name + ", ", value);
      continue;
    }
    page.open("tr").element("th", name, {{"scope", "row"}}).open("td");
    add_value(page, value, rounding_of(key));
    page.close().close();
  }
}

}  // namespace

Rounding rounding_of(std::string_view key) {
  constexpr std::array down{"lower", "margin", "high", "first_bound", "last_bound", "carried_at"};
  constexpr std::array up{"upper", "margin_upper", "low", "not_carried_at", "error"};
  if (std::ranges::find(down, key) != down.end()) return Rounding::down;
  return std::ranges::find(up, key) != up.end() ? Rounding::up : Rounding::nearest;
}

void add_number(Markup& page, const ResultJson* value, int digits, Rounding rounding) {
  if (value == nullptr || !value->is_number()) {
    page.words(nothing);
    return;
  }
  page.element("data", text_of(*value, digits, rounding), {{"value", value->dump()}});
}

void add_bound(Markup& page, const ResultReader& reader, const ResultJson* bracket, const char* key,
               int digits) {
  add_number(page, bracket == nullptr ? nullptr : reader.bound_value(*bracket, key), digits,
             rounding_of(key));
}

std::string standing_of(const ResultReader& reader, const ResultJson* bracket, const char* key) {
  const auto* const bound = bracket == nullptr ? nullptr : ResultReader::find(*bracket, key);
  return bound == nullptr ? std::string(nothing) : reader.text(*bound, "standing");
}

void add_count(Markup& page, const ResultJson* value) {
  if (value == nullptr || !value->is_string()) return add_number(page, value);
  const auto& digits = value->get_ref<const std::string&>();
  const auto count = support::ExactCount::read(digits);
  page.element("data", count ? count->text() : digits, {{"value", digits}});
}

void begin_facts(Markup& page, std::string_view caption) {
  open_table(page, caption);
  page.open("tbody");
}

void add_fact(Markup& page, std::string_view name, std::string_view words) {
  if (words.empty()) return;
  page.open("tr").element("th", name, {{"scope", "row"}}).element("td", words).close();
}

void add_bound_fact(Markup& page, const ResultReader& reader, std::string_view name,
                    const ResultJson& bracket, const char* key) {
  if (ResultReader::find(bracket, key) == nullptr) return;
  page.open("tr").element("th", fmt::format("{} ({})", name, standing_of(reader, &bracket, key)),
                          {{"scope", "row"}});
  page.open("td");
  add_bound(page, reader, &bracket, key);
  page.close().close();
}

std::string joined(const std::vector<std::string>& names) {
  std::string text;
  for (const auto& name : names) text += (text.empty() ? "" : ", ") + name;
  return text.empty() ? std::string(nothing) : text;
}

void open_table(Markup& page, std::string_view caption) {
  page.open("div", {{"class", "scroll"},
                    {"role", "region"},
                    {"aria-label", std::string(caption)},
                    {"tabindex", "0"}});
  page.open("table").element("caption", caption);
}

void begin_table(Markup& page, std::string_view caption, const std::vector<std::string>& columns) {
  open_table(page, caption);
  page.open("thead").open("tr");
  for (const auto& column : columns) page.element("th", column, {{"scope", "col"}});
  page.close().close().open("tbody");
}

void end_table(Markup& page) {
  page.close().close().close();
}

void add_facts(Markup& page, std::string_view caption, const ResultJson& object) {
  if (!object.is_object() || object.empty()) return;
  open_table(page, caption);
  page.open("tbody");
  add_rows(page, "", object);
  page.close().close().close();
}

void add_origin(Markup& page, const ResultReader& reader) {
  const auto& all = reader.all();
  auto call = ResultJson::object();
  for (const char* const key : {"command", "version", "status"}) call[key] = reader.at(all, key);
  for (const char* const key : {"certificate", "digest"}) {
    if (const auto* const value = ResultReader::find(all, key)) call[key] = *value;
  }
  const auto& problem = reader.at(all, "problem");
  call["file"] = reader.text(problem, "file");
  if (const auto* const mark = ResultReader::find(problem, "fingerprint"))
    call["fingerprint of the problem"] = *mark;
  add_facts(page, "Call", call);
  if (const auto* const options = ResultReader::find(all, "options"))
    add_facts(page, "Options", *options);
  const auto& result = reader.at(all, "result");
  for (const char* const key : {"tree", "programs", "zero_one"}) {
    if (const auto* const value = ResultReader::find(result, key))
      add_facts(page, key == std::string_view("tree") ? "The search tree" : with_spaces(key),
                *value);
  }
  if (const auto* const statistics = ResultReader::find(all, "statistics")) {
    // The page of a result does not depend on the speed of the machine.
    auto counts = *statistics;
    counts.erase("seconds");
    const auto* const ranks = ResultReader::find(counts, "ranks");
    if (ranks != nullptr && ranks->is_array()) counts["ranks"] = ranks->size();
    add_facts(page, "Run statistics", counts);
  }
}

}  // namespace kusabi::run
