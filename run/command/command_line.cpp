// Parsing of the command line: CLI11 splits the call, option_table gives meanings; words that are
// not understood have error messages here.
#include "run/command/command_line.hpp"

#include <algorithm>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "run/command/command_list.hpp"
#include "run/command/help.hpp"
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
    if (!row.named() || support::nearest(word, words_of(row.help)).empty()) continue;
    if (found == nullptr || row.help.size() < found->help.size()) found = &row;
  }
  return found;
}

std::vector<std::string_view> names_of(const OptionTable& table) {
  std::vector<std::string_view> names{"help"};
  for (const auto& row : table.rows()) {
    if (row.named()) names.push_back(without_dashes(row.name));
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

// @param group the group of the subcommand; empty: `kusabi` itself
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

// A group without a subcommand.
std::string subcommand_missing(const CommandList& list, std::string_view group) {
  return fmt::format("{} has no subcommand; expected one of {}", called(group),
                     fmt::join(list.words_after(group), ", "));
}

// A word that is not an option, after all files of the subcommand.
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

// @param word "--frction", "--frction=0.5"
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

// An option before the subcommand that is not an option of `kusabi` itself.
std::string no_option_of_all(const CommandList& list, std::string_view word) {
  const auto option = word.substr(0, word.find('='));
  const auto what = fmt::format("kusabi itself has no option {}", option);
  if (!owners(list, option).empty())
    return what + "; options of a subcommand follow it: kusabi SUBCOMMAND " + std::string(word);
  if (const auto meant = meant_by(without_dashes(word), names_of(list.own())); !meant.empty())
    return fmt::format("{}; did you mean --{}?", what, meant);
  return what + " (try kusabi --help)";
}

void add(CLI::App& command, OptionRow& row) {
  const auto names = fmt::format("{}", fmt::join(row.names(), ","));
  if (row.value.empty()) {
    command.add_flag_callback(names, [&row] { row.store(*(row.given = "")); })
        ->disable_flag_override();
    return;
  }
  command
      .add_option_function<std::string>(names,
                                        [&row](const std::string& text) { row.given = text; })
      ->check([&row](const std::string& text) { return row.store(text); }, "");
}

void add_options(CLI::App& command, OptionTable& table) {
  command.allow_extras();  // the message on wrong words is our own
  for (auto& row : table.rows()) add(command, row);
}

// The call as CLI11 reads it.
struct Parser {
  CLI::App app{"", "kusabi"};
  std::map<std::string_view, CLI::App*> groups;
  std::map<CommandList::Entry*, CLI::App*> commands;

  explicit Parser(CommandList& list) {
    app.require_subcommand(0, 1);
    add_options(app, list.own());
    for (const auto& group : list.groups()) {
      auto& added = *app.add_subcommand(std::string(group.name));
      added.require_subcommand(0, 1)->allow_extras();
      groups[group.name] = &added;
    }
    for (auto& entry : list.entries()) {
      const auto group = group_of(entry.name());
      auto& above = group.empty() ? app : *groups.at(group);
      auto& command = *above.add_subcommand(std::string(last_word(entry.name())));
      add_options(command, entry.table);
      commands[&entry] = &command;
    }
  }

  [[nodiscard]] CommandList::Entry* asked() const {
    for (const auto& [entry, command] : commands) {
      if (command->parsed()) return entry;
    }
    return nullptr;
  }

  [[nodiscard]] std::string_view asked_group() const {
    for (const auto& [name, group] : groups) {
      if (group->parsed()) return name;
    }
    return {};
  }
};

// The first word that CLI11 cannot place; empty: none. Options come first, since a file may be
// superfluous only because it was the value of an unknown option.
std::string left_over(const CLI::App& command) {
  auto words = command.remaining();
  std::erase(words, "--");
  const auto option =
      std::ranges::find_if(words, [](const auto& word) { return word.starts_with('-'); });
  if (option != words.end()) return *option;
  return words.empty() ? std::string{} : words.front();
}

// Message for an option with too few or too many values.
std::string wrong_count(std::string_view said, const CommandList::Entry* entry) {
  const auto name = said.substr(0, said.find_first_of(": "));
  const auto* row = entry == nullptr ? nullptr : entry->table.find(name);
  if (row == nullptr && entry != nullptr) row = entry->table.find(fmt::format("--{}", name));
  if (row == nullptr) return std::string(said);
  if (row->value.empty()) return fmt::format("{} takes no value", row->name);
  if (said.find("received") != std::string_view::npos)
    return fmt::format("{} is given more than once", row->name);
  return fmt::format("{} has no value; expected {}", row->name, row->expected);
}

// The first word of the call that CLI11 returns to `kusabi` itself; empty: none.
std::string left_over_of_all(const CLI::App& app) {
  auto words = app.remaining();
  std::erase(words, "--");
  return words.empty() ? std::string{} : words.front();
}

bool given(const CommandList& list, std::string_view option) {
  return list.own().find(option)->given.has_value();
}

// @param files arguments after "--"
void check_words(const CommandList& list, const Parser& parser,
                 const std::vector<std::string>& files) {
  if (const auto word = left_over_of_all(parser.app); !word.empty()) {
    // Arguments after "--" that the subcommand does not take return to `kusabi`.
    const auto* const taker = parser.asked();
    if (taker != nullptr && std::ranges::find(files, word) != files.end())
      throw WrongCall(one_word_too_many(*taker, word));
    throw WrongCall(word.starts_with('-') ? no_option_of_all(list, word)
                                          : no_such_subcommand(list, {}, word));
  }
  const auto group = parser.asked_group();
  if (!group.empty()) {
    if (const auto word = left_over(*parser.groups.at(group)); !word.empty())
      throw WrongCall(no_such_subcommand(list, group, word));
    if (parser.asked() == nullptr && !given(list, "--manual"))
      throw WrongCall(subcommand_missing(list, group));
  }
  auto* const entry = parser.asked();
  if (entry == nullptr) return;
  if (const auto word = left_over(*parser.commands.at(entry)); !word.empty()) {
    throw WrongCall(word.starts_with('-') ? no_such_option(list, *entry, word)
                                          : one_word_too_many(*entry, word));
  }
}

// `kusabi help` and its argument.
std::string help_on(const CommandList& list, const std::vector<std::string>& words) {
  std::string name;
  for (const auto& word : words) {
    if (!word.starts_with('-')) name += name.empty() ? word : ' ' + word;
  }
  if (name.empty() || name == "help") return overview(list);
  if (const auto* const entry = list.find(name)) return help(*entry);
  if (const auto* const group = list.group(name)) return help(list, *group);
  const auto group = group_of(name);
  if (list.group(group) == nullptr || group.empty())
    throw WrongCall(no_such_subcommand(list, {}, name));
  throw WrongCall(no_such_subcommand(list, group, name.substr(group.size() + 1)));
}

std::string manual_of(const CommandList& list, const Parser& parser) {
  if (const auto* const entry = parser.asked()) return manual(list, *entry);
  const auto* const group = list.group(parser.asked_group());
  return group != nullptr ? manual(list, *group) : manual(list);
}

}  // namespace

ParsedCall parse(CommandList& list, int argc, const char* const* argv) {
  const std::vector<std::string> words(argv + 1, argv + std::max(argc, 1));
  if (words.empty()) return {nullptr, overview(list), true};
  if (words.front() == "help") return {nullptr, help_on(list, {words.begin() + 1, words.end()})};
  Parser parser(list);
  auto& app = parser.app;
  try {
    app.parse(argc, argv);
  } catch (const CLI::CallForHelp&) {
    const auto* const entry = parser.asked();
    return {nullptr,
            help_on(list, {std::string(entry != nullptr ? entry->name() : parser.asked_group())})};
  } catch (const CLI::ArgumentMismatch& error) {
    throw WrongCall(fmt::format("{} (try --help)", wrong_count(error.what(), parser.asked())));
  } catch (const CLI::ParseError& error) {
    throw WrongCall(fmt::format("{} (try --help)", error.what()));
  }
  check_words(list, parser, {std::ranges::find(words, "--"), words.end()});
  auto* const entry = parser.asked();
  if (given(list, "--version")) return {nullptr, version()};
  if (const auto& shell = list.own().find("--completion")->given)
    return {nullptr, completion(list, *shell)};
  if (given(list, "--manual")) return {nullptr, manual_of(list, parser)};
  if (entry == nullptr) return {nullptr, overview(list), true};
  return {entry, {}};
}

void require_options(const CommandList::Entry& entry) {
  for (const auto& row : entry.table.rows()) {
    if (row.required && !row.given) {
      throw WrongCall(fmt::format("{} is required: {}{} (try kusabi {} --help)", row.name, row.help,
                                  row.role == Role::plain ? ", " + row.expected : "",
                                  entry.name()));
    }
    if (row.given && !row.needs.empty() && !row.is_met_by(entry.table.find(row.needs)->given))
      throw WrongCall(fmt::format("{} requires {} (try --help)", row.name, row.requirement()));
  }
}

}  // namespace kusabi::run
