// What becomes of a leaf of the tree of sign patterns as friction falls from where it was found.
//
// t* of a leaf does not fall when friction grows, and its solutions at one coefficient are
// solutions at all larger ones. So a leaf is dead up to its critical coefficient; from there on it
// may be a flat cone, whose candidates at rest come to life one after another; and solid in the
// end, if at all. Between two coefficients at which it is the same it does not change, which makes
// a bisection complete.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include <boost/serialization/vector.hpp>

#include "nodes/wedged/friction/critical_friction.hpp"
#include "nodes/wedged/tree/sign_pattern.hpp"

namespace kusabi::wedged {

/// A change between two points of the grid, both decided (x width).
struct LeafChange {
  std::int64_t before = 0, after = 0;
  LeafStage to;  ///< what it is at `after`

  template <class Archive>
  void serialize(Archive& archive, unsigned /*version*/) {
    archive& before& after& to;
  }
};

struct LeafHistory {
  static constexpr std::int64_t never = INT64_MAX;

  /// The first change to a stage; null: there is none.
  [[nodiscard]] const LeafChange* change_to(const LeafStage& stage) const;

  std::vector<LeafChange> changes;  ///< from dead on, as friction grows
  /// Above this point (x width) it cannot be told what the leaf is.
  std::int64_t open_above = never;

  template <class Archive>
  void serialize(Archive& archive, unsigned /*version*/) {
    archive& changes& open_above;
  }
};

/// @param leaf of the block's own candidates, each in contact or separated
/// @param last what it is at `most`, the largest coefficient (x width); not dead
LeafHistory leaf_history(CriticalFriction& critical, const SignPattern& leaf, const LeafStage& last,
                         std::int64_t most);

}  // namespace kusabi::wedged
