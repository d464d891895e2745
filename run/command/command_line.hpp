// All subcommands on one command line: from the words of a call to the subcommand that it asks for,
// and from the tables of options to help and the manual page.
#pragma once

#include <deque>
#include <memory>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "run/command/option_table.hpp"
#include "run/command/subcommand.hpp"

namespace kusabi::run {

/// The call is wrong; one line.
class WrongCall : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

class CommandLine {
 public:
  /// A group of subcommands, called by its name and theirs.
  struct Group {
    std::string_view name;
    std::string_view purpose;
  };

  CommandLine(std::vector<std::unique_ptr<Subcommand>> subcommands, std::vector<Group> groups);

  /// A subcommand with its options.
  struct Entry {
    std::unique_ptr<Subcommand> subcommand;
    OptionTable table;
  };

  /// What a call asks for: a subcommand, whose options have been taken, or a text to print.
  struct Asked {
    Entry* entry = nullptr;
    std::string text;
  };

  /// @throws WrongCall
  Asked parse(int argc, const char* const* argv);

  /// The manual page, in the language of man(7).
  [[nodiscard]] std::string manual() const;

 private:
  [[nodiscard]] std::string names() const;

  std::deque<Entry> entries_;
  std::vector<Group> groups_;
};

}  // namespace kusabi::run
