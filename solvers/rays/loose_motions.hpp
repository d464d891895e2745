// The motions of bodies that nothing holds, as the cone of reactions takes them: u = F r + G alpha
// and G'r = 0 (docs/theory/rays.md, "Loose bodies").
//
// Those that lift some candidate, or press it in, are unknowns. They are combined such that each
// has a candidate of its own, its *pivot*, which the later ones leave alone. Those that slide along
// all surfaces only ask for equilibrium.
#pragma once

#include <vector>

#include "solvers/rays/null_vector.hpp"

namespace kusabi::rays {

/// A motion that moves no candidate along its normal by more than this part of the largest slides
/// along all of them, and so at each candidate by itself: directions are written with sixteen
/// digits.
inline constexpr double sliding = 1e-12;

struct LooseMotions {
  PreciseMatrix moves;      ///< G combined, 2m x p; those that lift come first
  std::vector<int> pivots;  ///< a candidate for each that lifts

  [[nodiscard]] Eigen::Index lifting() const { return static_cast<Eigen::Index>(pivots.size()); }
};

/// By elimination with complete pivoting in the normal rows.
/// @param motions G, 2m x p, of rank p
LooseMotions combined(PreciseMatrix motions);

}  // namespace kusabi::rays
