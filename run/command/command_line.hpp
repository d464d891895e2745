// Parsing of a call: the subcommand that it names, or the text that it requests.
#pragma once

#include <stdexcept>
#include <string>

#include "run/command/command_list.hpp"

namespace kusabi::run {

/// Error in the call; one line.
class WrongCall : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Request of a call: a subcommand with its options read, or a text to print.
struct ParsedCall {
  CommandList::Entry* entry = nullptr;
  std::string text;
  bool wrong = false;  ///< the text is shown because the call is empty (exit code 2)
};

/// Stores the options of the call in the variables of the tables. `require_options` checks for
/// missing ones, since defaults may add some.
/// @throws WrongCall
ParsedCall parse(CommandList& list, int argc, const char* const* argv);

/// @throws WrongCall if a required option is missing, or one that another option requires
void require_options(const CommandList::Entry& entry);

}  // namespace kusabi::run
