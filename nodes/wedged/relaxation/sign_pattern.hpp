// Sign patterns of the contact candidates: nodes and leaves of trees, and configurations.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include <boost/serialization/vector.hpp>

#include "support/index_set.hpp"

namespace kusabi::wedged {

/// State of each candidate.
struct SignPattern {
  support::IndexSet contact;    ///< U: u_n = 0
  support::IndexSet separated;  ///< R: r = 0
  support::IndexSet inactive;   ///< both, throughout a flat cone; empty at the nodes of a tree

  friend bool operator==(const SignPattern&, const SignPattern&) = default;

  template <class Archive>
  void serialize(Archive& archive, unsigned /*version*/) {
    archive& contact& separated& inactive;
  }
};

/// A node of a tree of sign patterns.
struct PatternNode {
  /// The root of a structure with several blocks, whose children are the roots of these.
  static constexpr std::uint32_t all_blocks = UINT32_MAX;

  std::uint32_t block = 0;
  SignPattern pattern;  ///< of the block's own candidates, from 0 on

  friend bool operator==(const PatternNode&, const PatternNode&) = default;

  template <class Archive>
  void serialize(Archive& archive, unsigned /*version*/) {
    archive& block& pattern;
  }
};

/// State of a leaf that is not infeasible.
enum class LeafState {
  feasible,   ///< t* is above the tolerance: a solid cone
  flat,       ///< t* = 0 with known zeros: a flat cone
  marginal,   ///< |t*| is within the tolerance, and the zeros are numerically undecided
  undecided,  ///< neither feasibility nor infeasibility is proved
};

/// A leaf of the tree that is not infeasible, with a configuration.
struct Configuration {
  std::uint32_t block = 0;
  SignPattern pattern;  ///< of the whole problem's candidates
  LeafState state = LeafState::feasible;
  double lower = 0;                  ///< lower <= t* <= upper, in scaled units (see ContactSolver);
  double upper = 0;                  ///< `lower` is the value of the configuration below
  std::vector<double> reaction;      ///< r of the block, force; sum of its normal parts 1
  std::vector<double> displacement;  ///< u = K^-1 r of the block, length

  /// True if it is a solid or a flat cone.
  [[nodiscard]] bool is_cone() const {
    return state == LeafState::feasible || state == LeafState::flat;
  }

  template <class Archive>
  void serialize(Archive& archive, unsigned /*version*/) {
    archive& block& pattern& state& lower& upper& reaction& displacement;
  }
};

/// True if the margin of the first is larger; among equals, if it comes first in the order of the
/// patterns.
bool has_larger_margin(const Configuration& first, const Configuration& second);

/// Receives the feasible leaves found on a rank. A run that resumes may find one again.
using LeafRecorder = std::function<void(const Configuration&)>;

/// The leaf of the block's own tree that contains the configuration; inactive candidates may count
/// as separated.
/// @param block its candidates, as the whole problem numbers them
SignPattern own_leaf(const Configuration& found, const support::IndexSet& block);

/// The same with its block. @param blocks candidates of each
PatternNode own_node(const Configuration& found, const std::vector<support::IndexSet>& blocks);

/// A leaf feasible with polyhedral friction cones: one of Y_1, ..., Y_k of Algorithm 5.8, with the
/// result of its step 2.
struct PolyhedralLeaf {
  std::uint32_t block = 0;
  SignPattern pattern;    ///< of the whole problem's candidates
  double polyhedral = 0;  ///< t of their program, of which only the sign is used
  double lower = 0;       ///< lower <= t* <= upper of (23); minus infinity if only the sign
  double upper = 0;       ///< of t* was requested

  /// t* < 0: no configuration of (WP) has this pattern.
  [[nodiscard]] bool discarded() const { return upper < 0; }

  template <class Archive>
  void serialize(Archive& archive, unsigned /*version*/) {
    archive& block& pattern& polyhedral& lower& upper;
  }
};

}  // namespace kusabi::wedged
