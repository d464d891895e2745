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
#include <vector>

#include <boost/serialization/vector.hpp>

#include "nodes/wedged/tree/sign_pattern.hpp"
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
  rays::Effort effort;  ///< over all cones; the peak is that of the largest
  rays::Health health;

  RayTally& operator+=(const RayTally& other);

  template <class Archive>
  void serialize(Archive& archive, unsigned /*version*/) {
    archive& patterns& effort& health;
  }
};

/// Those rays with a reaction at each of `contact`, at none of `separated`, and somewhere: of the
/// parts of a tree that share rays one alone has a ray among these.
std::vector<rays::ZeroSet> own_rays(const std::vector<rays::ZeroSet>& rays,
                                    rays::Candidates contact, rays::Candidates separated,
                                    rays::Candidates all);

/// A leaf that may report rays.
struct RayLeaf {
  SignPattern pattern;          ///< of the node; where it has no sign, all are stood for
  rays::Candidates in_contact;  ///< of the cone D(Y) that the rays are of

  /// @param fate of a node that is a leaf
  static RayLeaf of(const PatternNode& node, const SignPatternTree::Fate& fate);

  /// Those rays of D(Y) that this leaf reports, and no other.
  [[nodiscard]] std::vector<rays::ZeroSet> own(const std::vector<rays::ZeroSet>& rays,
                                               rays::Candidates all) const {
    return own_rays(rays, pattern.contact.word(0), pattern.separated.word(0), all);
  }

  template <class Archive>
  void serialize(Archive& archive, unsigned /*version*/) {
    archive& pattern& in_contact;
  }
};

/// The problem type that engine::search searches.
class RayTree {
 public:
  using Node = PatternNode;
  using Solution = PatternRays;
  using Tally = RayTally;

  /// @param tree  of a plane problem, taken as one block
  /// @param cone  of the same problem and friction
  RayTree(SignPatternTree tree, rays::ReactionCone cone);

  Node root() const { return tree_.root(); }
  void expand(Node&& node, engine::Expansion<RayTree>& out);
  Tally tally() const;

 private:
  SignPatternTree tree_;
  rays::ReactionCone cone_;
  RayTally tally_;
};

}  // namespace kusabi::wedged
