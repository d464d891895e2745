// Extremal rays of the plane wedged problem by the tree of sign patterns.
//
// Every complementary ray lies in the cone D(Y) of some sign pattern Y, and D(Y) is a face of C_r;
// the rays of the feasible patterns' small cones, of dimension about |U|, are therefore the rays of
// Algorithm 4.2. The tree is that of Algorithm 5.1, each leaf of which is processed by one rank: no
// rank stores more than the rays of one pattern. These are found by a walk along the edges of D(Y)
// or, if they are not simple, by double description.
//
// A ray that is inactive at some candidates lies in the cones of several leaves. It is reported by
// the leaf whose U is the set of candidates with a reaction; a leaf closed as a flat cone stands
// for all leaves below it. docs/theory/rays.md proves completeness.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

#include <boost/serialization/vector.hpp>

#include "engine/expansion.hpp"
#include "engine/path.hpp"
#include "engine/search_declaration.hpp"
#include "nodes/wedged/tree/node_interruption.hpp"
#include "nodes/wedged/tree/sign_pattern_tree.hpp"
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

/// Statistics of a rank.
struct RayTally {
  SignPatternTally patterns;
  rays::Cost cost;  ///< over all cones; the peak is the maximum
  rays::Health health;

  RayTally& operator+=(const RayTally& other);

  template <class Archive>
  void serialize(Archive& archive, unsigned /*version*/) {
    archive& patterns& cost& health;
  }
};

/// Receives the rays found on a rank, with their numbers. A run that resumes may find one again.
using RayRecorder = std::function<void(const rays::ZeroSet&, const rays::Ray&)>;

/// Reports the rays of a node together, or one by one for a recorder, so that the search counts
/// them.
template <class Tree>
void report(PatternRays&& own, bool one_by_one, engine::Expansion<Tree>& out) {
  if (!one_by_one) {
    if (!own.rays.empty()) out.solution(std::move(own));
    return;
  }
  constexpr std::size_t between_polls = 64;  // a recorder takes a millisecond for them
  for (std::size_t at = 0; at < own.rays.size(); ++at) {
    if (at % between_polls == 0) out.poll();
    out.solution({{own.rays[at]}});
  }
}

/// The rays with a reaction at each of `contact`, at none of `separated`, and at least one
/// reaction: of the parts of a tree that contain a ray exactly one reports it.
std::vector<rays::ZeroSet> own_rays(const std::vector<rays::ZeroSet>& rays,
                                    rays::Candidates contact, rays::Candidates separated,
                                    rays::Candidates all);

/// A leaf that may report rays.
struct RayLeaf {
  SignPattern pattern;          ///< of the node; it stands for all leaves with the undecided signs
  rays::Candidates in_contact;  ///< in contact throughout the cone D(Y)

  /// @param decision of a node that is a leaf
  static RayLeaf of(const PatternNode& node, const SignPatternTree::NodeResult& decision);

  /// The rays of D(Y) that this leaf reports, and no other leaf.
  [[nodiscard]] std::vector<rays::ZeroSet> own(const std::vector<rays::ZeroSet>& rays,
                                               rays::Candidates all) const {
    return own_rays(rays, pattern.contact.word(0), pattern.separated.word(0), all);
  }

  template <class Archive>
  void serialize(Archive& archive, unsigned /*version*/) {
    archive& pattern& in_contact;
  }
};

/// Problem type of engine::search.
class RayTree {
 public:
  using Node = PatternNode;
  using Solution = PatternRays;
  using Tally = RayTally;

  /// @param tree  of a plane problem, taken as one block
  /// @param cone  of the same problem and friction
  RayTree(SignPatternTree tree, rays::ReactionCone cone);

  /// Passes all rays to a recorder; they are then counted, but are not in the outcome.
  void keep_found(RayRecorder recorder) { keep_ = std::move(recorder); }

  Node root() const { return tree_.root(); }
  void expand(Node&& node, engine::Expansion<RayTree>& out);
  bool emit(const engine::Path& path, Solution& own);
  Tally tally() const;

 private:
  // Result of a node.
  struct Opened {
    SignPatternTree::NodeResult decision;
    PatternRays own;  // of its leaf
  };

  // @throws support::Stopped soon after the run is to stop
  Opened open(const Node& node);

  // All rays of the cone D(Y) of a leaf. @throws support::Stopped
  std::vector<rays::ZeroSet> rays_of(const Configuration& leaf, rays::Candidates in_contact);

  SignPatternTree tree_;
  rays::ReactionCone cone_;
  RayRecorder keep_;
  RayTally tally_;
  NodeInterruption interruption_;
  std::optional<SignPatternTally> patterns_before_;  // of an interrupted node, which is not counted
};

}  // namespace kusabi::wedged

extern template kusabi::engine::OutcomeOf<kusabi::wedged::RayTree> kusabi::engine::search(
    kusabi::wedged::RayTree&, kusabi::engine::Transport&, const kusabi::engine::Options&);
