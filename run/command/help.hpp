// Text of `kusabi help`, generated from the option tables, within 80 columns.
#pragma once

#include <string>
#include <vector>

#include "run/command/command_list.hpp"

namespace kusabi::run {

/// All subcommands, by purpose.
std::string overview(const CommandList& list);

/// One subcommand: description, example, options.
std::string help(const CommandList::Entry& entry);

/// The subcommands of one group.
std::string help(const CommandList& list, const CommandList::Group& group);

/// Permitted values and default of an option, in sentences: "A number above 0. Default: 1e-12."
std::string option_rules(const OptionRow& row);

/// Synopsis after the name of the subcommand: " file --mu NUMBER [options]".
std::string usage(const OptionTable& table);

/// All spellings of an option; the placeholder of a positional argument: "FILE".
std::vector<std::string> shown_names(const OptionRow& row);

/// Placeholder of the value of an option: "NUMBER", "FILE", "WORD"; empty: a switch.
std::string value_name(const OptionRow& row);

}  // namespace kusabi::run
