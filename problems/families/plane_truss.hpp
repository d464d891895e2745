// Plane trusses of any size that lean against an obstacle, for measurements of the enumeration of
// rays. The family contains examples/plane-truss.toml and the trusses of the wedged paper's section
// 7.2.
#pragma once

#include "problems/structure/model/structure.hpp"

namespace kusabi::problems {

/// Columns of nodes with bars between rows. All cells have both diagonals.
enum class Verticals {
  none,   ///< none
  inner,  ///< columns between the wall and the obstacle
  all,    ///< these and the column on the obstacle
};

/// Size parameters. Columns of nodes, one more than bays, run from the wall to the obstacle.
struct PlaneTrussSize {
  int rows = 5;      ///< along y, 1 m apart; also the number of contact candidates
  int bays = 2;      ///< along x
  double width = 5;  ///< of the lowest row, m
  /// Angle of the obstacle's surface to the vertical, degrees, away from the wall.
  double lean = 30;
  Verticals verticals = Verticals::inner;
};

/// The truss with EA = 1 kN for all bars; the first column is fixed, the last one touches the
/// surface. Candidates are numbered from below. Node r<i>c<j> is in row i = 1, ... and column j =
/// 0, ...
/// @throws std::invalid_argument if there are fewer than 2 rows or 1 bay, more than
///         `max_contact_candidates` or `max_bays`, a width that is not positive, or a lean that
///         is not from 0 to 80 degrees
Structure plane_truss(const PlaneTrussSize& size);

/// The truss of the wedged paper's section 7.2 with N rows, as in the paper's computations: one bay
/// of 5 m at the lowest row, a surface inclined by 30 degrees, both diagonals and bars along the
/// surface. It differs from the paper's text in two points: all bars have the same EA/L = 1 kN/m
/// instead of the same EA, and the normal is that of the mirrored surface.
/// @throws std::invalid_argument if there are fewer than 2 rows or more than
///         `max_contact_candidates`
Structure paper_plane_truss(int rows);

/// Maximum number of bays.
inline constexpr int max_bays = 1000;

}  // namespace kusabi::problems
