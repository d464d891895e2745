// Parameters of the interior-point iterations, and their differences by precision.
#pragma once

#include <algorithm>
#include <type_traits>

#include "support/numbers/precise.hpp"

namespace kusabi::conic {

/// True for the precision levels above doubles. These are for the few nodes that doubles leave
/// undecided: they examine each bound, and treat the degenerate nodes of unconstrained bodies.
template <class Real>
inline constexpr bool extended = !std::is_same_v<Real, double>;

/// Extended precision takes more iterations than Tolerances::iterations.
inline constexpr int max_extended_iterations = 150;

/// Programs with fewer rows take microseconds an iteration in doubles.
inline constexpr int rows_that_take_long = 64;

/// Shift of the diagonal of A W^2 A', relative to the size of each row before cancellation (A has b
/// in it): of the order of its rounding. A candidate in contact whose normal and tangents are
/// decoupled has a zero row in A, and u_n = 0 then has no solution; with the shift, y grows along
/// that row and proves the node infeasible.
inline constexpr double diagonal_shift = 1e-15;

/// The same for any precision; extended ones take the bound of rounding in a linearly dependent row
/// (Higham, theorem 10.3).
template <class Real>
constexpr double shift_of_diagonal(int rows) {
  return extended<Real> ? 4 * rows * numbers::unit_roundoff<Real> : diagonal_shift;
}

/// The dual start keeps at least this share of the distance of each z_i from the boundary at y = 0.
inline constexpr double start_share = 0.5;

/// Upper limit of the initial multipliers: where the rows with a slack move z into the cone,
/// nothing else bounds them.
inline constexpr double start_limit = 1;

/// Primal start x = start_point e, v = start_slack, times the magnitude 1 / |C| of a reaction with
/// sum one. The best of the measured starts: the sign is proved half an iteration earlier than from
/// the identity.
inline constexpr double start_point = 1;
inline constexpr double start_slack = 0.5;

/// Share of the ordinary start in one from an iterate in shorter numbers: their rounding leaves points
/// on the boundary of the cones.
inline constexpr double start_towards_centre = 1e-9;

/// Share of the distance to the boundary that a step covers; the rest keeps the next scaling
/// computable.
inline constexpr double boundary_fraction = 0.99;

/// Length of the step that covers `share` of the distance to the boundary, at most 1.
/// @param inverse of the largest length inside
template <class Real>
Real step_length(double share, const Real& inverse) {
  return share / std::max(Real(share), inverse);
}

/// Shorter steps no longer change the bracket.
inline constexpr double min_step_length = 1e-6;

/// At the rounding level a step may move the new z across the boundary. The step is halved at most
/// this often; after that the digits are used up.
inline constexpr int max_halvings = 8;

/// Share of the distance to the boundary for steps towards the centre. Six steps mostly suffice; an
/// inexact centre only changes the order of the candidates slightly.
inline constexpr double centring_fraction = 0.9;
inline constexpr int max_centring_steps = 8;

/// The centre of a relaxation is computed where t is about this many times its bound below the
/// bound, where all inequalities have room. Near the maximum of t the central path bends towards a
/// vertex.
inline constexpr double centring_depth = 10;

}  // namespace kusabi::conic
