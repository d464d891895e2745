// Whether the tree of sign patterns would find the rays with less work than double description,
// found out by searching it, on one rank and for a bounded share of what double description costs.
//
// The work is counted in pairs of rays looked at, so that the answer does not depend on clocks or
// ranks. It is done in the order that shows soonest that it is too much: first the nodes alone,
// which tell how many leaves there are; then the cones D(Y) of the leaves, in depth-first order, of
// which the first has the most candidates in contact and mostly the most work.
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
  /// @param stop asked now and then whether to end: then the trial has not succeeded; empty: never
  RayTrial(std::function<SignPatternTree()> tree, const rays::ReactionCone& cone,
           std::function<bool()> stop)
      : plant_(std::move(tree)), cone_(cone), stop_(std::move(stop)) {}

  /// Goes on with the tree for as much work as is right by now.
  /// @param pairs that double description has looked at in all; called after each of its steps
  /// @return whether the tree has come to its end
  bool succeeds(std::uint64_t pairs);

  bool has_succeeded() const { return found_.tree && done_ == leaves_.size(); }

  /// What the tree has found. @pre it has come to its end
  RayFindings found() &&;

 private:
  /// Before double description has looked at so many pairs, which takes it ten milliseconds, there
  /// is nothing to be saved.
  static constexpr std::uint64_t first_search = 100'000;

  void look_for_leaves(std::uint64_t pairs);
  bool enumerates(std::uint64_t worth);

  std::function<SignPatternTree()> plant_;
  const rays::ReactionCone& cone_;
  std::function<bool()> stop_;
  std::uint64_t seen_ = 0;                    // pairs of double description
  std::uint64_t next_search_ = first_search;  // when the nodes are searched again, in these pairs
  RayFindings found_;            // its tree is empty until all leaves are known, and these
  std::vector<RayLeaf> leaves_;  // are not all done
  std::size_t done_ = 0;         // leaves
  rays::Effort effort_;          // for these, and for the next one
  std::optional<rays::PatternRaysByTurns> turns_;
};

}  // namespace kusabi::wedged
