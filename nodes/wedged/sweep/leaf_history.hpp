// States of a leaf of the tree of sign patterns as friction decreases.
//
// t* of a leaf is nondecreasing in the coefficient, and its solutions at one coefficient are
// solutions at all larger ones. A leaf is infeasible below its critical coefficient; from there on
// it may be a flat cone, whose inactive candidates become active one after another, and finally
// solid. It does not change between two coefficients with equal states, so bisection finds all
// changes.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include <boost/serialization/vector.hpp>

#include "nodes/wedged/friction/critical_friction.hpp"
#include "nodes/wedged/relaxation/sign_pattern.hpp"

namespace kusabi::wedged {

/// A change between two decided grid points (x width).
struct LeafChange {
  std::int64_t before = 0, after = 0;
  LeafStage to;  ///< state at `after`

  template <class Archive>
  void serialize(Archive& archive, unsigned /*version*/) {
    archive& before& after& to;
  }
};

struct LeafHistory {
  static constexpr std::int64_t never = INT64_MAX;

  /// The first change to a state; null: there is none.
  [[nodiscard]] const LeafChange* change_to(const LeafStage& stage) const;

  std::vector<LeafChange> changes;  ///< from infeasible on, as friction grows
  /// Above this point (x width) the state is numerically undecided.
  std::int64_t open_above = never;

  template <class Archive>
  void serialize(Archive& archive, unsigned /*version*/) {
    archive& changes& open_above;
  }
};

/// @param leaf of the block's own candidates, each in contact or separated
/// @param last its state at `maximum`, the largest coefficient (x width); not infeasible
LeafHistory leaf_history(CriticalFriction& critical, const SignPattern& leaf, const LeafStage& last,
                         std::int64_t maximum);

}  // namespace kusabi::wedged
