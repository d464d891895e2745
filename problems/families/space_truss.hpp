// Space trusses of any size like that of the wedged paper's section 7.3, for measurements of the
// searches. (The paper's own truss is known only from its figure.) examples/space-truss.toml has
// the default sizes below.
#pragma once

#include "problems/structure/model/structure.hpp"

namespace kusabi::problems {

/// Size parameters. Columns of nodes, one more than bays, run from the wall to the obstacle.
struct SpaceTrussSize {
  int rows = 5;   ///< along y, 2.5 m apart
  int depth = 2;  ///< planes along z, 4 m apart
  int bays = 3;   ///< along x, 10 m together in the lowest plane
};

/// The truss with EA = 1 kN for all bars; the first column is fixed, the last one touches a surface
/// inclined by 30 degrees to the vertical. Its rows x depth contact candidates are numbered row by
/// row, in each row from the lower planes on.
/// @throws std::invalid_argument if there are fewer than 2 rows, 2 planes or 1 bay, more than
///         `max_contact_candidates`, or more bays than rows (which would be a mechanism)
Structure space_truss(const SpaceTrussSize& size);

}  // namespace kusabi::problems
