// CommandList: all subcommands with their option tables, from which command line, help, manual
// pages and completion are made.
#pragma once

#include <deque>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "run/command/option_table.hpp"
#include "run/command/subcommand.hpp"

namespace kusabi::run {

class CommandList {
 public:
  /// A group of subcommands, called as "GROUP NAME".
  struct Group {
    std::string_view name;
    std::string_view purpose;
  };

  /// A chapter of the list of all subcommands.
  struct Chapter {
    std::string_view title;
    std::vector<std::string_view> names;
  };

  /// A subcommand with its options.
  struct Entry {
    SubcommandText text;
    std::unique_ptr<Subcommand> subcommand;
    OptionTable table;
    ConfigChoice config;

    [[nodiscard]] std::string_view name() const { return text.name; }
  };

  /// Chapters are in the order of their first subcommands.
  CommandList(const std::vector<Registration>& subcommands, std::vector<Group> groups);

  [[nodiscard]] std::deque<Entry>& entries() { return entries_; }
  [[nodiscard]] const std::deque<Entry>& entries() const { return entries_; }
  [[nodiscard]] const std::vector<Group>& groups() const { return groups_; }
  [[nodiscard]] const std::vector<Chapter>& chapters() const { return chapters_; }
  /// Options of `kusabi` itself.
  [[nodiscard]] OptionTable& own() { return own_; }
  [[nodiscard]] const OptionTable& own() const { return own_; }

  /// The subcommand of that name ("patterns", "example grid"); null if there is none.
  [[nodiscard]] const Entry* find(std::string_view name) const;
  [[nodiscard]] const Group* group(std::string_view name) const;

  /// Words that may follow a group or, without one, `kusabi` itself: subcommands and groups, each
  /// once.
  [[nodiscard]] std::vector<std::string_view> words_after(std::string_view group) const;

 private:
  std::deque<Entry> entries_;
  std::vector<Group> groups_;
  std::vector<Chapter> chapters_;
  OptionTable own_;
  bool switched_ = false;
  std::string shell_;
};

/// The group of "example grid" is "example"; empty if there is none.
std::string_view group_of(std::string_view name);
/// "grid" for "example grid", and for "grid".
std::string_view last_word(std::string_view name);

/// A new list of all subcommands with their option tables, in the order of `kusabi help`.
CommandList command_list();

}  // namespace kusabi::run
