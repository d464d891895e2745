// The one error a wrong input raises: a single line that says where, what is wrong, what was
// expected. The command prints it as it is and ends with exit code 2.
#pragma once

#include <stdexcept>
#include <string>
#include <string_view>

namespace kusabi::support {

/// Where an entry stands in its file, counted from 1 in characters. Line 0: not from a file.
struct SourcePosition {
  int line = 0;
  int column = 0;
  int file = 0;  ///< 0: the file that is read; from 1 on: those that it names
};

/// The input is wrong. `what()` is `FILE:LINE:COLUMN: what is wrong; expected ...`, or
/// `FILE: ...` for a fault that no single line holds.
class InputError : public std::runtime_error {
 public:
  /// @param file name of the file as the user wrote it, or the name of the structure if there is
  ///        no file
  InputError(std::string_view file, SourcePosition position, std::string_view message);
};

/// `text` in double quotes, fit for one line of an error: control characters, quotes and
/// backslashes are escaped, and what is longer than 40 bytes is cut and ends in "...".
std::string in_quotes(std::string_view text);

}  // namespace kusabi::support
