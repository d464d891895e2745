// Texts generated from the option tables: `kusabi help` within 80 columns, manual pages, completion
// scripts; and the version.
#pragma once

#include <string>
#include <string_view>
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

/// kusabi.1: all subcommands in a line each, options of `kusabi` itself, examples, files.
std::string manual(const CommandList& list);

/// The page of one subcommand: kusabi-patterns.1.
std::string manual(const CommandList& list, const CommandList::Entry& entry);

/// The page of a group, which lists its subcommands: kusabi-bench.1.
std::string manual(const CommandList& list, const CommandList::Group& group);

/// @param shell "bash", "zsh" or "fish" @throws WrongCall for any other
std::string completion(const CommandList& list, std::string_view shell);

/// The first line is "kusabi VERSION"; commit, MPI library, compiler and libraries follow, one per
/// line.
std::string version();

/// Date of this version in CITATION.cff: "2026-11-25".
std::string_view release_date();

}  // namespace kusabi::run
