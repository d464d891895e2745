// Friction use of a candidate: the share of its friction that a reaction needs.
#pragma once

#include "pictures/svg/scales.hpp"
#include "pictures/svg/scene.hpp"

namespace kusabi::pictures {

/// |r_t| / (mu r_n): 1 where the candidate slips. 0 without a reaction, or without friction.
double friction_use(const DrawnCandidate& candidate);

/// True if the candidate is in contact, and its reaction, if any is known, is more than a hundredth
/// of the largest one.
bool is_loaded(const DrawnCandidate& candidate, const Scales& scales);

/// Number of the shades of friction cones.
inline constexpr int use_shades = 4;

/// Lower ends of the shades: below a half, three quarters, 95 % of the friction, and above.
inline constexpr double use_steps[use_shades] = {0, 0.5, 0.75, 0.95};

/// Index of the shade of a use.
int use_shade(double use);

}  // namespace kusabi::pictures
