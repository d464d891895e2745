// Two columns: names and their descriptions.
#include "run/command/help.hpp"

#include <algorithm>
#include <iterator>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "run/output/terminal_page.hpp"
#include "run/session/progress_text.hpp"

namespace kusabi::run {
namespace {

constexpr std::size_t width = 80;
constexpr std::size_t column = 26;  // of the descriptions

// "  --mu NUMBER             friction coefficient", in as many lines as needed.
std::string entry_of(const std::string& head, const std::string& meaning) {
  auto text = fmt::format("  {}", head);
  const auto lines = folded(meaning, width - column);
  text += text.size() + 2 > column ? fmt::format("\n{:{}}", "", column)
                                   : std::string(column - text.size(), ' ');
  for (const char c : lines) {
    text += c;
    if (c == '\n') text.append(column, ' ');
  }
  return text + '\n';
}

std::string head_of(const OptionRow& row, const std::string& name) {
  return row.named() && !row.value.empty() ? fmt::format("{} {}", name, value_name(row)) : name;
}

std::string entry_of(const OptionRow& row) {
  const auto rules = option_rules(row);
  const auto names = fmt::format("{}", fmt::join(shown_names(row), ", "));
  return entry_of(head_of(row, names), rules.empty() ? row.help : row.help + ". " + rules);
}

std::string line_of(std::string_view name, std::string_view purpose) {
  return fmt::format("  {:<21}{}\n", name, purpose);
}

// Position at which a head and its row, both too long, are broken: the end of a column in both.
std::size_t end_of_a_column(std::string_view head, std::string_view row) {
  const auto ends = [](std::string_view line, std::size_t at) {
    return line[at] == ' ' && line[at - 1] != ' ';
  };
  auto at = width;
  while (at > 1 && !(ends(head, at) && ends(row, at))) --at;
  return at > 1 ? at : width;
}

// A head and its row, both too long, broken in two, the second part below the first.
std::string cut_tables(const std::string& text) {
  std::string cut;
  std::string_view left = text;
  const auto next_line = [&] {
    const auto line = left.substr(0, left.find('\n'));
    left.remove_prefix(std::min(line.size() + 1, left.size()));
    return line;
  };
  while (!left.empty()) {
    const auto line = next_line();
    const auto after = left.substr(0, left.find('\n'));
    if (line.size() <= width || after.size() != line.size()) {
      cut += fmt::format("{}\n", line);
      continue;
    }
    const auto at = end_of_a_column(line, next_line());
    cut += fmt::format("{}\n{}\n{}\n{}\n", line.substr(0, at), after.substr(0, at), line.substr(at),
                       after.substr(at));
  }
  cut.pop_back();
  return cut;
}

char capital_letter(char c) {
  return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
}

std::string capitalised(std::string text) {
  if (!text.empty()) text[0] = capital_letter(text[0]);
  return text;
}

}  // namespace

std::string value_name(const OptionRow& row) {
  return row.words.empty() ? row.value : "WORD";
}

std::vector<std::string> shown_names(const OptionRow& row) {
  auto names = row.names();
  if (row.named()) return names;
  for (auto& name : names) std::ranges::transform(name, name.begin(), capital_letter);
  return names;
}

std::string option_rules(const OptionRow& row) {
  std::string text;
  const auto out = std::back_inserter(text);
  const bool says_what = !row.expected.empty() || !row.unit.empty();
  if (says_what && (!row.words.empty() || row.shows_range)) {
    fmt::format_to(out, "{}{}{}.", capitalised(row.expected), row.unit.empty() ? "" : ", ",
                   row.unit.starts_with("in ") || row.unit.empty() ? row.unit : "in " + row.unit);
  } else if (!row.unit.empty()) {
    fmt::format_to(out, "In {}.", row.unit.starts_with("in ") ? row.unit.substr(3) : row.unit);
  }
  if (!row.default_value.empty()) fmt::format_to(out, " Default: {}.", row.default_value);
  if (!row.needs.empty()) fmt::format_to(out, " Requires {}.", row.requirement());
  return text.substr(std::min(text.find_first_not_of(' '), text.size()));
}

std::string usage(const OptionTable& table) {
  std::string text;
  for (const auto& row : table.rows()) {
    if (!row.named()) text += ' ' + shown_names(row).front();
  }
  for (const auto& row : table.rows()) {
    if (row.named() && row.required) text += ' ' + head_of(row, row.name);
  }
  return text + " [options]";
}

std::string help(const CommandList::Entry& entry) {
  const auto& [name, chapter, purpose, description, example, progress] = entry.text;
  auto text = fmt::format("kusabi {}: {}\n", name, purpose);
  if (!description.empty()) text += fmt::format("\n{}\n", description);
  text = folded(text, width);
  text += fmt::format("\nUsage:   kusabi {}{}\nExample: kusabi {} {}\n", name, usage(entry.table),
                      name, example);
  std::string required;
  std::string optional;
  for (const auto& row : entry.table.rows()) {
    (row.required ? required : optional) += entry_of(row);
  }
  optional += entry_of("-h, --help", "print this help");
  if (!required.empty()) text += "\nRequired:\n" + required;
  text += "\nOptions:\n" + optional;
  if (progress != ProgressLines::none) {
    text += fmt::format(
        "\n{}\n", folded(cut_tables(progress_explained(progress == ProgressLines::bounds)), width));
  }
  return text;
}

std::string help(const CommandList& list, const CommandList::Group& group) {
  auto text = fmt::format("kusabi {}: {}\n\n", group.name, group.purpose);
  std::string_view first;
  for (const auto& entry : list.entries()) {
    if (group_of(entry.name()) != group.name) continue;
    text += line_of(entry.name(), entry.text.purpose);
    if (first.empty()) first = entry.name();
  }
  return text + fmt::format("\nOptions of a subcommand: kusabi help {}\n", first);
}

std::string overview(const CommandList& list) {
  std::string text =
      "Kusabi finds all wedged configurations of a structure with Coulomb friction, and\n"
      "worst-case limit loads of trusses, and can prove its answers.\n\n"
      "Usage:   kusabi SUBCOMMAND FILE [options]\n"
      "         mpirun -np RANKS kusabi SUBCOMMAND FILE [options]\n"
      "Example: kusabi patterns examples/space-truss.toml --mu 0.65\n";
  for (const auto& chapter : list.chapters()) {
    text += fmt::format("\n{}\n", chapter.title);
    for (const auto name : chapter.names) text += line_of(name, list.find(name)->text.purpose);
  }
  text += "\nOptions of kusabi itself\n";
  for (const auto& row : list.own().rows()) text += entry_of(row);
  text += entry_of("-h, --help", "print this help");
  return text +
         "\nOptions of a subcommand, with an example: kusabi help SUBCOMMAND\n"
         "Exit codes: 0 answered (\"none\" is an answer), 1 failed or refused, 2 invalid\n"
         "call or input, 3 stopped early or partly undecided.\n";
}

}  // namespace kusabi::run
