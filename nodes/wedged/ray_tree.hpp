// Pattern first: the extremal rays of the plane wedged problem, by the tree of sign patterns.
//
// Every complementary ray lies in the cone D(Y) of some sign pattern Y, and D(Y) is a face of C_r;
// so the rays of the living patterns' own small cones, of dimension |U| or so, are the rays of
// Algorithm 4.2. The tree is that of Algorithm 5.1, each leaf of which is a job for one rank: no
// rank ever holds more than the rays of one pattern.
//
// A ray that neither touches with a reaction nor separates at some candidates lies in the cones of
// several leaves. It is reported by one of them, the one whose U is where the ray has a reaction;
// what closes a tie as a flat cone stands for all leaves below it. docs/theory/rays.md shows that
// this misses none.
#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <vector>

#include <boost/serialization/vector.hpp>

#include "nodes/wedged/sign_pattern.hpp"
#include "solvers/rays/double_description.hpp"
#include "solvers/rays/reaction_cone.hpp"

namespace kusabi::wedged {

/// The rays that one leaf reports.
struct PatternRays {
  std::vector<rays::ZeroSet> rays;

  template <class Archive>
  void serialize(Archive& archive, unsigned /*version*/) {
    archive& rays;
  }
};

/// What a rank did.
struct RayTally {
  SignPatternTally patterns;
  rays::Effort effort;  ///< over all small cones; the peak is that of the largest
  rays::Health health;

  RayTally& operator+=(const RayTally& other);

  template <class Archive>
  void serialize(Archive& archive, unsigned /*version*/) {
    archive& patterns& effort& health;
  }
};

/// What a tree on trial may cost; a tree that is searched for good may cost what it will.
struct RayTreeBudget {
  std::uint64_t nodes = std::numeric_limits<std::uint64_t>::max();
  std::uint64_t pairs = std::numeric_limits<std::uint64_t>::max();  ///< of Effort
  std::function<bool()> stop = {};  ///< asked at each node whether to end; empty: never
};

/// The problem type that engine::search searches.
class RayTree {
 public:
  using Node = PatternNode;
  using Solution = PatternRays;
  using Tally = RayTally;

  /// @param tree  of a plane problem, taken as one block
  /// @param cone  of the same problem and friction
  /// @param budget of this object: beyond it nodes are dropped unopened
  RayTree(SignPatternTree tree, rays::ReactionCone cone, RayTreeBudget budget = {});

  Node root() const { return tree_.root(); }
  void expand(Node&& node, engine::Expansion<RayTree>& out);
  Tally tally() const;

  /// Whether nodes were dropped, so that rays may be missing.
  bool gave_up() const { return gave_up_; }

 private:
  SignPatternTree tree_;
  rays::ReactionCone cone_;
  RayTreeBudget budget_;
  RayTally tally_;
  std::uint64_t opened_ = 0;
  bool gave_up_ = false;
};

}  // namespace kusabi::wedged
