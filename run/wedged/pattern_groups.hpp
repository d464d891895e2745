// PatternGroup: patterns that differ in few candidates. Hundreds of patterns are often a few ways
// to stick, each with some candidates that may or may not touch.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "nodes/wedged/relaxation/sign_pattern.hpp"

namespace kusabi::run {

struct PatternGroup {
  std::vector<std::size_t> members;  ///< indices in the list, in its order
  std::size_t largest_margin = 0;    ///< index of the member with the largest margin
  support::IndexSet contact;         ///< candidates in contact in all members
  support::IndexSet varying;         ///< candidates in contact in some members, but not in all
};

/// Groups by single linkage: patterns of a block whose contact sets differ in at most
/// `max_differences` candidates are in one group, as are those connected by a chain of such pairs.
/// Groups therefore do not depend on the order. The group with the largest margin comes first.
/// @param max_differences number of candidates
std::vector<PatternGroup> pattern_groups(const std::vector<wedged::Configuration>& patterns,
                                         int max_differences);

/// Groups around patterns of largest margin: the pattern with the largest margin takes the patterns
/// of its block whose contact sets differ from its own in at most `max_differences` candidates,
/// then the pattern with the largest margin of the rest, and so on. Of equal margins the first in
/// the list comes first.
/// @param max_groups maximum number of groups
/// @return nothing if there would be more
std::optional<std::vector<PatternGroup>> groups_around_largest_margin(
    const std::vector<wedged::Configuration>& patterns, int max_differences,
    std::size_t max_groups);

}  // namespace kusabi::run
