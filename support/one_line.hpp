// Names without control characters, for lines of text files and of messages.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace kusabi::support {

/// True for a control character of ASCII, and for the second byte of one of U+0080 to U+009F in
/// UTF-8.
bool is_control(std::string_view text, std::size_t place);

/// The text on one line: its control characters as \x0a.
std::string on_one_line(std::string_view text);

}  // namespace kusabi::support
