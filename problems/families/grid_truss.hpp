// Plane grid trusses for measurements of limit analysis: n x n bays with crossed diagonals,
// vertical dead loads and a horizontal reference load. The truss with 4 bays is that of the limit
// paper's section 6.2 and examples/paper/limit-4x4.toml.
#pragma once

#include "problems/structure/model/structure.hpp"

namespace kusabi::problems {

/// Maximum number of bays along each axis: some ten thousand nodes, far more than can be solved.
inline constexpr int max_grid_bays = 100;

/// W = 0.35 m, H = 0.50 m. Node (i, j), column i and row j from below, has the name "i,j"; numbers
/// go row by row. All base nodes are supported; there are no base beams. The reference load acts
/// along x at the nodes (0, j), j = 2 ... n, decreasing linearly from 52 kN to 28 kN; the dead load
/// is -800 kN along y at the nodes (i, n), i = 2 ... n; yield forces are 800 kN. Uncertain
/// components are those of a file without [[uncertainty]].
/// @throws std::invalid_argument unless 2 <= bays <= max_grid_bays
Structure grid_truss(int bays);

}  // namespace kusabi::problems
