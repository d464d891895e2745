// Names that count up, said as a range: the 60 nodes of a face in one word.
#pragma once

#include <string>
#include <vector>

namespace kusabi::run {

/// Names in their order, apart by a space, "-" if there are none. From three on, names one after
/// another that differ in one number, which counts up by one, are one range: "b.1,0 b.2,0 b.3,0" is
/// "b.1…3,0".
std::string with_ranges(const std::vector<std::string>& names);

/// How many characters a terminal shows of UTF-8 text.
std::size_t shown_width(const std::string& text);

}  // namespace kusabi::run
