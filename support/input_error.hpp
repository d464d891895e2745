// InputError: the exception for wrong input, with a one-line message: position, fault, expected
// value. The command prints it unchanged and exits with code 2.
#pragma once

#include <stdexcept>
#include <string>
#include <string_view>

namespace kusabi::support {

/// Position of an entry in its file; line and column count from 1, in characters. Line 0: not from
/// a file.
struct SourcePosition {
  int line = 0;
  int column = 0;
  int file = 0;  ///< 0: the main file; from 1 on: files that it includes, in order
};

/// A fault in the input. `what()` is `FILE:LINE:COLUMN: fault; expected ...`, or `FILE: ...` for a
/// fault that no single line contains.
class InputError : public std::runtime_error {
 public:
  /// @param file name of the file as given by the user, or name of the structure if there is no
  ///        file
  InputError(std::string_view file, SourcePosition position, std::string_view message);
};

/// `text` in double quotes for a one-line message: control characters, quotes and backslashes are
/// escaped; text longer than 40 bytes is cut and ends in "...".
std::string in_quotes(std::string_view text);

}  // namespace kusabi::support
