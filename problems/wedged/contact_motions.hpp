// The motions of loose bodies as the contact candidates see them: G of docs/theory/wedged.md,
// "Loose bodies".
#pragma once

#include <span>

#include "problems/structure/bodies/rigid_motions.hpp"
#include "problems/structure/model/structure.hpp"
#include "support/numbers/precise.hpp"

namespace kusabi::problems {

struct ContactMotions {
  /// G, dm x p, ordered as in WedgedProblem: independent columns, orthogonal to each other, the
  /// largest entry of each between 1/2 and 1. What no candidate sees is left out.
  numbers::PreciseMatrix matrix;
  double error = 0;  ///< what an entry may be off by
};

/// @param bodies those of the structure
/// @throws InputError if it can't be told whether candidates see a motion, or if a body has none
ContactMotions contact_motions(const Structure& structure, std::span<const LooseBody> bodies);

/// The same without any combination: a column for each motion of each body, dm x sum of p, zero
/// where no candidate sees it.
numbers::PreciseMatrix seen_motions(const Structure& structure, std::span<const LooseBody> bodies);

}  // namespace kusabi::problems
