// Messages for words of a call that are unknown or superfluous: one line with the name that was
// probably intended.
#pragma once

#include <string>
#include <string_view>

#include "run/command/command_list.hpp"

namespace kusabi::run {

/// @param group the group of the subcommand; empty: `kusabi` itself
std::string no_such_subcommand(const CommandList& list, std::string_view group,
                               std::string_view word);

/// A group without a subcommand.
std::string subcommand_missing(const CommandList& list, std::string_view group);

/// @param word "--frction", "--frction=0.5"
std::string no_such_option(const CommandList& list, const CommandList::Entry& entry,
                           std::string_view word);

/// An option before the subcommand that is not an option of `kusabi` itself.
std::string no_option_of_all(const CommandList& list, std::string_view word);

/// A word that is not an option, after all files of the subcommand.
std::string one_word_too_many(const CommandList::Entry& entry, std::string_view word);

}  // namespace kusabi::run
