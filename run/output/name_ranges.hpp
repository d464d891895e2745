// Lists of names with ranges: the 60 nodes of a face in one word.
#pragma once

#include <string>
#include <vector>

namespace kusabi::run {

constexpr bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

/// Names in order, separated by blanks; "-" if there are none. Three or more consecutive names that
/// differ in one number, which increases by one, are written as a range: "b.1,0 b.2,0 b.3,0" is
/// "b.1…3,0".
std::string with_ranges(const std::vector<std::string>& names);

/// Number of characters that a terminal shows for UTF-8 text.
std::size_t shown_width(const std::string& text);

}  // namespace kusabi::run
