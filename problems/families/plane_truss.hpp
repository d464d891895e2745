// Plane trusses that lean against an obstacle, of any size: what the enumeration of rays is
// measured on. A family with sizes of one's own, of which examples/plane-truss.toml is one, and the
// trusses of the wedged paper's section 7.2.
#pragma once

#include "problems/structure/model/structure.hpp"

namespace kusabi::problems {

/// Which columns of nodes have bars from row to row. All cells have both diagonals anyway.
enum class Verticals {
  none,   ///< none
  inner,  ///< those between the wall and the obstacle
  all,    ///< the one on the obstacle, too
};

/// How many of what, and where. Columns of nodes, one more than bays, run from the wall to the
/// obstacle.
struct PlaneTrussSize {
  int rows = 5;      ///< along y, 1 m apart: as many contact candidates
  int bays = 2;      ///< along x
  double width = 5;  ///< of the lowest row, m
  double lean = 30;  ///< of the obstacle's surface, degrees from the vertical, away from the wall
  Verticals verticals = Verticals::inner;
};

/// The truss: EA = 1 kN everywhere, the first column fixed, the last one against the surface. Its
/// candidates come from below. Node r<i>c<j> is in row i = 1, ... and column j = 0, ...
/// @throws std::invalid_argument if there are fewer than 2 rows or 1 bay, more than
///         `most_contact_candidates` or `most_bays`, a width that is not positive, or a lean that
///         is not from 0 to 80 degrees
Structure plane_truss(const PlaneTrussSize& size);

/// The truss of the wedged paper's section 7.2 with that many rows, N, as its computations have it,
/// by whose numbers it is known: one bay of 5 m at the lowest row, a face that leans by 30 degrees,
/// both diagonals and bars along the face. In two things they differ from the text: all bars have
/// the same EA/L = 1 kN/m, not the same EA; and the normal is that of the mirrored face.
/// @throws std::invalid_argument if there are fewer than 2 rows or more than
///         `most_contact_candidates`
Structure paper_plane_truss(int rows);

/// Most bays, far more than such a truss is ever given.
inline constexpr int most_bays = 1000;

}  // namespace kusabi::problems
