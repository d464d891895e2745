// What `kusabi help` prints, from the tables: within 80 columns.
#pragma once

#include <string>

#include "run/command/command_list.hpp"

namespace kusabi::run {

/// All subcommands, by the question that each answers.
std::string overview(const CommandList& list);

/// One subcommand: what it does, an example, its options.
std::string help(const CommandList::Entry& entry);

/// Those of one group.
std::string help(const CommandList& list, const CommandList::Group& group);

/// What an option takes and what it is unless given, in sentences: "A number above 0. Unless given:
/// 1e-12."
std::string option_rules(const OptionRow& row);

/// What follows the name of the subcommand: " file --mu NUMBER [options]".
std::string usage(const OptionTable& table);

/// What an option takes, in a word: "NUMBER", "FILE", "WORD"; empty: nothing.
std::string value_name(const OptionRow& row);

}  // namespace kusabi::run
