// Algorithm 4.2, divided: the tree whose nodes are lists of rays.
//
// Double description goes on with a list until it is long. Then the list is divided at a candidate
// that has been cut by, into the rays with u_n = 0 there and those with r = 0. Each part is the
// list of a face, with which double description goes on by itself, on any rank. Nothing is done
// twice but what comes of the rays idle at that candidate, which are in both parts; each ray is
// reported by one. docs/theory/rays.md shows that none is missing.
#pragma once

#include <cstdint>

#include "nodes/wedged/rays/ray_tree.hpp"
#include "nodes/wedged/tree/sign_pattern.hpp"
#include "solvers/rays/double_description.hpp"
#include "solvers/rays/reaction_cone.hpp"

namespace kusabi::wedged {

/// A list that is longer is divided. Shorter ones make more pairs, since idle rays are in both
/// parts; longer ones leave fewer parts to share (bench/README.md).
inline constexpr std::uint64_t longest_list = 98'304;

/// About how many bytes lists take on each rank, however many rays there are in the end: a step
/// makes a list longer, on trusses up to twice as long.
/// Of few candidates there are no more rays than ways to combine the five states of each.
std::uint64_t memory_of_lists(int candidates);

/// The problem type that engine::search searches.
class DividedRays {
 public:
  using Node = rays::RayList;
  using Solution = PatternRays;  ///< of one part that has come to its end
  using Tally = RayTally;

  /// @param tree  of a plane problem, taken as one block: tells which parts have no ray
  /// @param cone  of the same problem and friction
  /// @param list  to go on with
  DividedRays(SignPatternTree tree, rays::ReactionCone cone, rays::RayList list,
              std::uint64_t longest = longest_list);

  Node root() const { return list_; }
  void expand(Node&& node, engine::Expansion<DividedRays>& out);
  Tally tally() const;

 private:
  /// Whether there may be a ray that this part reports.
  bool may_have_own(const Node& list);

  SignPatternTree tree_;
  rays::ReactionCone cone_;
  rays::RayList list_;
  std::uint64_t longest_;
  RayTally tally_;
};

}  // namespace kusabi::wedged
