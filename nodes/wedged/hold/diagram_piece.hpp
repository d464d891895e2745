// Piece of a diagram: the pairs of factors of two reference loads that one sign pattern holds.
#pragma once

#include <Eigen/Core>

#include "nodes/wedged/hold/half_planes.hpp"
#include "nodes/wedged/hold/hold_tree.hpp"
#include "nodes/wedged/hold/load_program.hpp"

namespace kusabi::wedged {

/// The factors of one sign pattern.
struct DiagramPiece {
  LoadedPattern pattern;        ///< of the candidates of the whole problem
  Polygon hull{};               ///< each vertex has a state, proved
  bool is_whole_plane = false;  ///< every pair of factors
  bool fine = true;             ///< the hull is the whole piece, up to 1e-5 of its distances
};

/// Distance, relative to that from a point inside, up to which a vertex is known.
inline constexpr double diagram_width = 1e-7;

/// The piece of a pattern of one block, on this rank, in units of the loads.
/// @param unit of both factors  @param from a point with a state
DiagramPiece piece_around(const LoadedProblem& block, double mu, Precision precision,
                          const LoadedPattern& pattern, const Eigen::Vector2d& unit,
                          const Eigen::Vector2d& from);

}  // namespace kusabi::wedged
