// A family of space trusses of any size, of the kind of the wedged paper's section 7.3, whose own
// truss is lost with its figure: what the searches are measured on. examples/space-truss.toml is
// the member of it with the sizes below.
#pragma once

#include "problems/structure/model/structure.hpp"

namespace kusabi::problems {

/// How many of what. Columns of nodes, one more than bays, run from the wall to the obstacle.
struct SpaceTrussSize {
  int rows = 5;   ///< along y, 2.5 m apart
  int depth = 2;  ///< planes along z, 4 m apart
  int bays = 3;   ///< along x, 10 m together in the lowest plane
};

/// The truss: EA = 1 kN everywhere, the first column fixed, the last one against a surface inclined
/// by 30 degrees to the vertical. Its rows x depth contact candidates come row by row, in each row
/// the lower planes first.
/// @throws std::invalid_argument if there are fewer than 2 rows, 2 planes or 1 bay, more than
///         `most_contact_candidates`, or more bays than rows (which would be a mechanism)
Structure space_truss(const SpaceTrussSize& size);

}  // namespace kusabi::problems
