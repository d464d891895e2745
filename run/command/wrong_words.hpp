// What is said of a word of a call that is no subcommand, no option, or too many: one line with the
// name that was probably meant.
#pragma once

#include <string>
#include <string_view>

#include "run/command/command_list.hpp"

namespace kusabi::run {

/// @param group in which it was looked for; empty: `kusabi` itself
std::string no_such_subcommand(const CommandList& list, std::string_view group,
                               std::string_view word);

/// A group without what should follow it.
std::string subcommand_missing(const CommandList& list, std::string_view group);

/// @param word "--frction", "--frction=0.5"
std::string no_such_option(const CommandList& list, const CommandList::Entry& entry,
                           std::string_view word);

/// An option before the subcommand, which is no option of `kusabi` itself.
std::string no_option_of_all(const CommandList& list, std::string_view word);

/// A word that is no option, after all files that the subcommand takes.
std::string one_word_too_many(const CommandList::Entry& entry, std::string_view word);

}  // namespace kusabi::run
