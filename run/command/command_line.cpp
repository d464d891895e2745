// Parsing of the command line: CLI11 splits the call, option_table gives meanings and wrong_words
// the error messages.
#include "run/command/command_line.hpp"

#include <algorithm>
#include <map>
#include <utility>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "run/command/completion.hpp"
#include "run/command/help.hpp"
#include "run/command/manual.hpp"
#include "run/command/version.hpp"
#include "run/command/wrong_words.hpp"

namespace kusabi::run {
namespace {

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
  command.allow_extras();  // wrong_words has the message
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
  if (const auto wrong = entry->table.replace_former_names(); !wrong.empty())
    throw WrongCall(wrong);
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
