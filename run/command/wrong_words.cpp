// Names are searched first, then the words of their descriptions.
#include "run/command/wrong_words.hpp"

#include <algorithm>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "support/input_error.hpp"
#include "support/nearest.hpp"

namespace kusabi::run {
namespace {

// A word that is the beginning of a name, or nearly a name; empty: none.
std::string_view meant_by(std::string_view word, const std::vector<std::string_view>& names) {
  constexpr std::size_t fewest_letters = 3;
  const auto begins = [&](std::string_view name) { return name.starts_with(word); };
  if (word.size() >= fewest_letters && std::ranges::count_if(names, begins) == 1)
    return *std::ranges::find_if(names, begins);
  return support::nearest(word, names);
}

std::string_view without_dashes(std::string_view word) {
  const auto dashes = std::min(word.find_first_not_of('-'), word.size());
  return word.substr(dashes, word.find('=') - dashes);
}

std::string as_typed(std::string_view word) {
  const auto text = support::in_quotes(word);
  return '\'' + text.substr(1, text.size() - 2) + '\'';
}

// The words of a text, letters only.
std::vector<std::string_view> words_of(std::string_view text) {
  const auto is_letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); };
  std::vector<std::string_view> words;
  for (auto at = text.begin(); at != text.end();) {
    const auto begin = std::find_if(at, text.end(), is_letter);
    at = std::find_if_not(begin, text.end(), is_letter);
    constexpr int explains = 5;  // shorter words, such as "the" or "from", explain nothing
    if (at - begin >= explains) words.emplace_back(&*begin, static_cast<std::size_t>(at - begin));
  }
  return words;
}

// The option whose description has such a word and is the shortest, since longer ones only mention
// it; null: none.
const OptionRow* explained_by(const OptionTable& table, std::string_view word) {
  const OptionRow* found = nullptr;
  for (const auto& row : table.rows()) {
    if (!row.named() || !row.shown() || support::nearest(word, words_of(row.help)).empty())
      continue;
    if (found == nullptr || row.help.size() < found->help.size()) found = &row;
  }
  return found;
}

std::vector<std::string_view> names_of(const OptionTable& table) {
  std::vector<std::string_view> names{"help"};
  for (const auto& row : table.rows()) {
    if (row.named() && row.shown()) names.push_back(without_dashes(row.name));
  }
  return names;
}

// Subcommands that have the option.
std::vector<std::string_view> owners(const CommandList& list, std::string_view option) {
  std::vector<std::string_view> names;
  for (const auto& entry : list.entries()) {
    if (entry.table.find(option) != nullptr) names.push_back(entry.name());
  }
  return names;
}

// "; it is an option of kusabi itself: kusabi --manual patterns"; empty: it is none.
std::string own_option(const CommandList& list, std::string_view option, std::string_view name) {
  if (!option.starts_with('-') || list.own().find(option) == nullptr) return {};
  return fmt::format("; it is an option of kusabi itself: kusabi {} {}", option, name);
}

std::string called(std::string_view group) {
  return group.empty() ? "kusabi" : fmt::format("kusabi {}", group);
}

}  // namespace

std::string no_such_subcommand(const CommandList& list, std::string_view group,
                               std::string_view word) {
  auto names = list.words_after(group);
  const auto choices = fmt::format("{}", fmt::join(names, ", "));
  names.emplace_back("help");
  const auto what = fmt::format("{}no subcommand {}", group.empty() ? "" : called(group) + " has ",
                                as_typed(word));
  if (const auto own = own_option(list, word, group); !own.empty()) return what + own;
  if (const auto meant = meant_by(word, names); !meant.empty())
    return fmt::format("{}; did you mean {}?", what, meant);
  for (const auto& entry : list.entries()) {
    const auto name = entry.name();
    if (group.empty() && last_word(name) == meant_by(word, {last_word(name)}))
      return fmt::format("{}; did you mean {}?", what, name);
  }
  if (word.find_first_of("./") != std::string_view::npos)
    return fmt::format("a subcommand must precede {}; expected one of {}", as_typed(word), choices);
  return fmt::format("{}; expected one of {}", what, choices);
}

std::string subcommand_missing(const CommandList& list, std::string_view group) {
  return fmt::format("{} has no subcommand; expected one of {}", called(group),
                     fmt::join(list.words_after(group), ", "));
}

std::string no_such_option(const CommandList& list, const CommandList::Entry& entry,
                           std::string_view word) {
  const auto option = word.substr(0, word.find('='));
  if (entry.table.find(option) != nullptr) return one_word_too_many(entry, word);  // after --
  const auto what = fmt::format("{} has no option {}", entry.name(), option);
  if (const auto others = owners(list, option); !others.empty())
    return fmt::format("{}; it is one of {}", what, fmt::join(others, ", "));
  if (const auto own = own_option(list, option, entry.name()); !own.empty()) return what + own;
  const auto bare = without_dashes(word);
  if (const auto meant = meant_by(bare, names_of(entry.table)); !meant.empty())
    return fmt::format("{}; did you mean --{}?", what, meant);
  if (const auto* row = explained_by(entry.table, bare))
    return fmt::format("{}; did you mean {} ({})?", what, row->name, row->help);
  return fmt::format("{} (try kusabi {} --help)", what, entry.name());
}

std::string no_option_of_all(const CommandList& list, std::string_view word) {
  const auto option = word.substr(0, word.find('='));
  const auto what = fmt::format("kusabi itself has no option {}", option);
  if (!owners(list, option).empty())
    return what + "; options of a subcommand follow it: kusabi SUBCOMMAND " + std::string(word);
  if (const auto meant = meant_by(without_dashes(word), names_of(list.own())); !meant.empty())
    return fmt::format("{}; did you mean --{}?", what, meant);
  return what + " (try kusabi --help)";
}

std::string one_word_too_many(const CommandList::Entry& entry, std::string_view word) {
  std::vector<std::string_view> files;
  for (const auto& row : entry.table.rows()) {
    if (!row.named()) files.push_back(row.name);
  }
  if (files.empty())
    return fmt::format("{} is superfluous; {} takes options only", as_typed(word), entry.name());
  return fmt::format("{} is superfluous; {} takes one {}", as_typed(word), entry.name(),
                     fmt::join(files, ", one "));
}

}  // namespace kusabi::run
