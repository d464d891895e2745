// Algorithm 4.2 with divided lists: a tree whose nodes are lists of rays.
//
// Double description continues with a list until it is long. Then the list is divided at a
// processed candidate into the rays with u_n = 0 there and those with r = 0. Each part is the list
// of a face, with which double description continues on any rank. Only rays inactive at that
// candidate are in both parts; each ray is reported by one. docs/theory/rays.md proves
// completeness.
#pragma once

#include <cstdint>
#include <optional>

#include "engine/search_declaration.hpp"
#include "nodes/wedged/rays/ray_tree.hpp"
#include "nodes/wedged/tree/node_interruption.hpp"
#include "nodes/wedged/tree/sign_pattern_tree.hpp"
#include "solvers/rays/double_description.hpp"
#include "solvers/rays/reaction_cone.hpp"

namespace kusabi::wedged {

/// Maximum length of a list before it is divided. Shorter ones cause more pairs, since inactive
/// rays are in both parts; longer ones leave fewer parts for the ranks (bench/history.md).
inline constexpr std::uint64_t longest_list = 98'304;

/// The same if a recorder takes the rays, for a third of the memory.
inline constexpr std::uint64_t longest_recorded_list = longest_list / 3;

/// Approximate memory in bytes for lists on each rank, for any number of rays: a step makes a list
/// longer, on trusses up to twice as long. For few candidates the number of combinations of five
/// states for each candidate bounds the number of rays.
/// @param longest maximum length of a list before it is divided
std::uint64_t memory_of_lists(int candidates, std::uint64_t longest);

/// Problem type of engine::search.
class RayListTree {
 public:
  using Node = rays::RayList;
  using Solution = PatternRays;  ///< of one completed part
  using Tally = RayTally;

  /// @param tree  of a plane problem as one block; decides which parts have no ray
  /// @param cone  of the same problem and friction
  /// @param list  initial list of rays
  RayListTree(SignPatternTree tree, rays::ReactionCone cone, rays::RayList list,
              std::uint64_t longest = longest_list);

  /// Passes all rays to a recorder; they are then counted, but are not in the outcome.
  void keep_found(RayRecorder recorder) { keep_ = std::move(recorder); }

  Node root() const { return list_; }
  void expand(Node&& node, engine::Expansion<RayListTree>& out);
  bool emit(const engine::Path& path, Solution& own);
  Tally tally() const;

 private:
  /// True if this part may report a ray.
  bool may_have_own(const Node& list);

  /// Continues double description. @throws support::Stopped soon after the run is to stop
  Node continued(const Node& list);

  SignPatternTree tree_;
  rays::ReactionCone cone_;
  rays::RayList list_;
  std::uint64_t longest_;
  RayRecorder keep_;
  RayTally tally_;
  NodeInterruption interruption_;
  std::optional<SignPatternTally> patterns_before_;  // of an interrupted node, which is not counted
};

}  // namespace kusabi::wedged

extern template kusabi::engine::OutcomeOf<kusabi::wedged::RayListTree> kusabi::engine::search(
    kusabi::wedged::RayListTree&, kusabi::engine::Transport&, const kusabi::engine::Options&);
