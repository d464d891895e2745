// The rules of the interior-point iteration that both solvers of node programs follow, the one in
// doubles and the one in more digits.
#pragma once

namespace kusabi::conic {

/// The dual start leaves each z_i at least this share of its distance from the boundary at y = 0.
inline constexpr double start_share = 0.5;

/// No multiplier starts above this: where the rows with a slack push z into the cone, nothing else
/// bounds them.
inline constexpr double start_limit = 1;

/// The primal start x = start_point e, v = start_slack, times the size 1 / |C| of a reaction that
/// sums to one. The better start of those we measured: the sign is proved half an iteration earlier
/// than from the identity.
inline constexpr double start_point = 1;
inline constexpr double start_slack = 0.5;

/// A step goes this share of the way to the boundary; the rest keeps the next scaling computable.
inline constexpr double boundary_fraction = 0.99;

/// Steps shorter than this no longer change the bracket.
inline constexpr double least_step_length = 1e-6;

/// A rounding-level step may put the new z on the wrong side of the boundary; halving this often
/// goes back far enough, or the digits are used up.
inline constexpr int most_halvings = 8;

/// A step towards the centre keeps farther from the boundary, and six are mostly enough; what is
/// left only orders the candidates a little differently.
inline constexpr double centring_fraction = 0.9;
inline constexpr int most_centring_steps = 8;

/// The centre of a relaxation is looked for where t is about this many times its bound below that:
/// where all inequalities have room. Much nearer to the best t the path bends towards a vertex.
inline constexpr double centring_depth = 10;

}  // namespace kusabi::conic
