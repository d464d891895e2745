// The family of plane grid trusses that limit analysis is measured on: n x n bays, braced
// crosswise, under vertical dead loads and a horizontal reference load. Its member with 4 bays is
// the truss of the limit paper's section 6.2, which is examples/paper/limit-4x4.toml, too.
#pragma once

#include "problems/structure/model/structure.hpp"

namespace kusabi::problems {

/// Most bays along each axis: the nodes are then some ten thousand, far beyond what is solved.
inline constexpr int most_grid_bays = 100;

/// W = 0.35 m, H = 0.50 m; node (i, j), column i, row j from below, is called "i,j" and numbered
/// row by row. All base nodes supported, no base beams. Reference load along x at the nodes (0, j),
/// j = 2 ... n, falling linearly from 52 kN to 28 kN; dead load -800 kN along y at the nodes (i,
/// n), i = 2 ... n; yield force 800 kN; the uncertain components are those that a file without
/// [[uncertainty]] has.
/// @throws std::invalid_argument unless 2 <= bays <= most_grid_bays
Structure grid_truss(int bays);

}  // namespace kusabi::problems
