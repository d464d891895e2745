// Primal heuristics of a mixed zero-one program: points by rounding and by diving, that is
// descending from a node without backtracking. The search prunes with them.
#pragma once

#include <optional>
#include <vector>

#include <boost/serialization/vector.hpp>

#include "nodes/zero_one/relaxation.hpp"

namespace kusabi::zero_one {

/// A point of the program: its binaries are exactly 0 or 1, its columns are within their bounds,
/// and rows are satisfied to 1e-12 of their terms.
struct ZeroOnePoint {
  double objective = 0;  ///< constant + c'x; not proved: up to rounding
  std::vector<double> values;
  /// These are the rounded values of a point, in rational numbers, that satisfies all rows.
  bool proved = false;

  template <class Archive>
  void serialize(Archive& archive, unsigned /*version*/) {
    archive& objective& values& proved;
  }
};

/// The best point with all binaries fixed by `fixings`, which leave none free; none if there is
/// none, or not to the required accuracy. The solution is in the relaxation.
std::optional<ZeroOnePoint> point_at(Relaxation& relaxation, const Fixings& fixings,
                                     const linear::Basis& basis);

/// The fixings, and every free binary at the nearer of 0 and 1 in the last solve.
Fixings rounded_fixings(const Relaxation& relaxation, Fixings fixings);

/// Dives from the relaxation's optimum under `fixings` (with its basis): fixes the binaries that
/// are at 0 or 1 and the one that is nearest to it, solves again, and so on; if that is infeasible,
/// the nearest one is fixed at its other value. It takes some dozens of linear programs.
std::optional<ZeroOnePoint> dive(Relaxation& relaxation, const Fixings& fixings,
                                 const linear::Basis& basis);

}  // namespace kusabi::zero_one
