// Patterns that differ in few candidates, said together: hundreds of patterns are often a handful
// of ways to stick, each with some candidates that may touch or not.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "nodes/wedged/tree/sign_pattern.hpp"

namespace kusabi::run {

struct PatternGroup {
  std::vector<std::size_t> members;  ///< places in the list, from 0, in its order
  std::size_t firmest = 0;           ///< of these the one with the largest margin
  support::IndexSet contact;         ///< in contact in all of them
  support::IndexSet varying;         ///< in contact in some, but not in all
};

/// Groups by single linkage: two patterns of a block whose contact sets differ in at most so many
/// candidates are in one group, and so are those that a chain of such steps joins. So the groups
/// depend on no order. The firmest groups come first.
/// @param most_apart candidates by which neighbours may differ
std::vector<PatternGroup> pattern_groups(const std::vector<wedged::Configuration>& patterns,
                                         int most_apart);

/// Groups around their firmest: the firmest pattern of all takes those of its block whose contact
/// sets differ from its own in at most so many candidates, then the firmest of the rest takes its
/// own, and so on. Of equally firm ones the first in the list.
/// @param most_groups where it gives up
/// @return nothing if there would be more
std::optional<std::vector<PatternGroup>> groups_around_firmest(
    const std::vector<wedged::Configuration>& patterns, int most_apart, std::size_t most_groups);

}  // namespace kusabi::run
