// From the words of a call to the subcommand that it asks for, or to the text that it asks for.
#pragma once

#include <stdexcept>
#include <string>

#include "run/command/command_list.hpp"

namespace kusabi::run {

/// The call is wrong; one line.
class WrongCall : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// What a call asks for: a subcommand, whose options have been taken, or a text to print.
struct Asked {
  CommandList::Entry* entry = nullptr;
  std::string text;
  bool wrong = false;  ///< whether the text is shown for want of a question (exit code 2)
};

/// Takes the options of the call into the variables of the list's tables.
///
/// Whether all are there that must be is `check_whole`'s to say: defaults may add some.
/// @throws WrongCall
Asked parse(CommandList& list, int argc, const char* const* argv);

/// @throws WrongCall if an option is missing that is required, or that another one needs
void check_whole(const CommandList::Entry& entry);

}  // namespace kusabi::run
