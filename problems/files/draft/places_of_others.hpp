// The keys `against` of [[contact]] and `to` of [[ties]]: the place on another body that each node
// of a list touches or is constrained to (docs/problem-files.md, "Two bodies").
#pragma once

#include <string_view>
#include <vector>

#include "problems/files/draft/problem_draft.hpp"

namespace kusabi::problems {

/// The places of `nodes`, one each, from the value of `key`: the name of an edge or group with the
/// nearest face for each node; a list of nodes, one of which coincides with each; or a list of {
/// nodes, weights }, one for each.
/// @throws InputError where a node has a gap, with the distance
std::vector<std::vector<WeightedNode>> places_of_others(const ProblemDraft& draft,
                                                        const TomlTable& group,
                                                        std::string_view key,
                                                        const std::vector<ListedNode>& nodes);

}  // namespace kusabi::problems
