// Points that satisfy a mixed zero-one program, found without a tree: by rounding, and by diving,
// that is going down from a node without coming back. They give the search something to prune with.
#pragma once

#include <optional>
#include <vector>

#include <boost/serialization/vector.hpp>

#include "nodes/zero_one/relaxation.hpp"

namespace kusabi::zero_one {

/// A point of the program; its binaries are 0 or 1 exactly, its columns are within their bounds,
/// and rows hold to 1e-12 of their terms.
struct ZeroOnePoint {
  double objective = 0;  ///< constant + c'x, correct to its last digits
  std::vector<double> values;

  template <class Archive>
  void serialize(Archive& archive, unsigned /*version*/) {
    archive& objective& values;
  }
};

/// The best point with all binaries held as `fixings` say, which leave none free; none if there is
/// none, or it cannot be had to so many digits. What was found is in the relaxation.
std::optional<ZeroOnePoint> point_at(Relaxation& relaxation, const Fixings& fixings,
                                     const linear::Basis& basis);

/// The fixings, and every free binary at the nearer of 0 and 1 in the last solve.
Fixings rounded_fixings(const Relaxation& relaxation, Fixings fixings);

/// Dives from the relaxation's optimum under `fixings` (with its basis): fixes the binaries that
/// are at 0 or 1 and the one that is nearest to it, solves again, and so on; if that is infeasible,
/// the nearest one is fixed at its other value. Some dozens of linear programs at most.
std::optional<ZeroOnePoint> dive(Relaxation& relaxation, const Fixings& fixings,
                                 const linear::Basis& basis);

}  // namespace kusabi::zero_one
