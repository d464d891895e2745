// PivotedModes: rigid-body modes of unconstrained bodies in the cone of reactions: u = F r + G
// alpha and G'r = 0 (docs/theory/rays.md, "Unconstrained bodies").
//
// Modes that separate or press in a candidate are unknowns. They are combined such that each has a
// candidate of its own, its *pivot*, which later modes do not displace. Modes that slide along all
// surfaces add equations of equilibrium only.
#pragma once

#include <vector>

#include "solvers/rays/null_vector.hpp"

namespace kusabi::rays {

/// Threshold of the normal part, relative to the largest component, below which a mode slides
/// along all surfaces, and so at each candidate: directions are written with sixteen digits.
inline constexpr double sliding = 1e-12;

struct PivotedModes {
  LongMatrix moves;         ///< G combined, 2m x p; modes with a normal part come first
  std::vector<int> pivots;  ///< a candidate for each mode with a normal part

  [[nodiscard]] Eigen::Index lifting() const { return static_cast<Eigen::Index>(pivots.size()); }
};

/// Combines modes by elimination with complete pivoting in the normal rows.
/// @param motions G, 2m x p, of rank p
PivotedModes combined(LongMatrix motions);

}  // namespace kusabi::rays
