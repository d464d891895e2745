// Lists of names in a call, which may contain the characters that separate them.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace kusabi::run {

/// Names of a list, as positions among the known ones.
struct ListedNames {
  std::vector<std::size_t> found{};
  std::string_view unknown{};  ///< the first part that is no known name; empty: there is none
};

/// A text of names that are separated by blanks or commas. At each place the longest known name that
/// the text begins with is taken, so that names may contain blanks and commas.
ListedNames names_in_list(std::string_view text, std::span<const std::string> known);

}  // namespace kusabi::run
