// Comparison of the tree of sign patterns with double description by a search on one rank with a
// bounded share of the costs of double description.
//
// Costs are counted in pairs of rays, so the answer does not depend on clocks or ranks. The order
// is chosen such that a large tree is detected early: first the nodes alone, which determine the
// number of leaves; then the cones D(Y) of the leaves in depth-first order, of which the first has
// the most candidates in contact and mostly the highest costs.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

#include "nodes/wedged/rays/ray_search.hpp"
#include "nodes/wedged/rays/ray_tree.hpp"
#include "solvers/rays/double_description.hpp"
#include "solvers/rays/reaction_cone.hpp"

namespace kusabi::wedged {

class RayTrial {
 public:
  /// @param tree makes the tree, from its root  @param cone of the same problem; outlives this
  /// @param stop polled for the end of the run, in which case the trial fails; empty: never
  RayTrial(std::function<SignPatternTree()> tree, const rays::ReactionCone& cone,
           std::function<bool()> stop)
      : make_tree_(std::move(tree)), cone_(cone), stop_(std::move(stop)) {}

  /// Continues the tree with the work allowed so far.
  /// @param pairs processed by double description in all; called after each of its steps
  /// @return true: the tree is complete
  bool succeeds(std::uint64_t pairs);

  /// Searches the nodes of the tree, unless they are known or cost a multiple of the pairs.
  /// @param pairs as of succeeds()
  /// @return true: the tree takes less than double description with divided lists
  bool is_worth_searching(std::uint64_t pairs);

  bool has_succeeded() const { return found_.tree && done_ == leaves_.size(); }

  /// The result of the tree. @pre it is complete
  RayFindings found() &&;

 private:
  /// Number of pairs before the first search: double description takes ten milliseconds for them,
  /// so nothing would be saved before.
  static constexpr std::uint64_t first_search = 100'000;

  void look_for_leaves(std::uint64_t worth);
  bool enumerates(std::uint64_t worth);

  std::function<SignPatternTree()> make_tree_;
  const rays::ReactionCone& cone_;
  std::function<bool()> stop_;
  std::uint64_t seen_ = 0;                    // pairs of double description
  std::uint64_t next_search_ = first_search;  // pairs at which the nodes are searched again
  RayFindings found_;                         // its tree is empty until all leaves are known
  std::vector<RayLeaf> leaves_;               // leaves not yet processed
  std::size_t done_ = 0;                      // leaves
  rays::Cost cost_;                           // for these, and for the next one
  std::optional<rays::PatternRaysByTurns> turns_;
};

}  // namespace kusabi::wedged
