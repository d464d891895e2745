// `against` of [[contact]] and `to` of [[ties]]: the place of another body that each node of a list
// touches or is tied to (docs/problem-files.md, "Two bodies").
#pragma once

#include <string_view>
#include <vector>

#include "problems/files/sections/problem_draft.hpp"

namespace kusabi::problems {

/// Nodes farther than this from the place they touch gape, relative to the size of the face, or,
/// for node on node, to the size of the structure; unless `gap` says how far they may be.
inline constexpr double gaping = 1e-6;

/// The places for `nodes`, one each, from what stands under `key`: the name of an edge or group,
/// whose nearest face each touches; a list of nodes, one of which is where each is; or a list of
/// { nodes, weights }, one for each, as they are.
/// @throws InputError where a node gapes, with the distance
std::vector<std::vector<Share>> places_of_others(const ProblemDraft& draft, const TomlTable& group,
                                                 std::string_view key,
                                                 const std::vector<ListedNode>& nodes);

}  // namespace kusabi::problems
