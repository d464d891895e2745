// Parameters of the interior-point iteration shared by both solvers of node programs, the one in
// doubles and the one in extended precision.
#pragma once

namespace kusabi::conic {

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

/// Share of the distance to the boundary that a step covers; the rest keeps the next scaling
/// computable.
inline constexpr double boundary_fraction = 0.99;

/// Shorter steps no longer change the bracket.
inline constexpr double least_step_length = 1e-6;

/// At the rounding level a step may move the new z across the boundary. The step is halved at most
/// this often; after that the digits are used up.
inline constexpr int most_halvings = 8;

/// Share of the distance to the boundary for steps towards the centre. Six steps mostly suffice; an
/// inexact centre only changes the order of the candidates slightly.
inline constexpr double centring_fraction = 0.9;
inline constexpr int most_centring_steps = 8;

/// The centre of a relaxation is computed where t is about this many times its bound below the
/// bound, where all inequalities have room. Near the maximum of t the central path bends towards a
/// vertex.
inline constexpr double centring_depth = 10;

}  // namespace kusabi::conic
