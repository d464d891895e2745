// The reference frame of a contact candidate: the outward normal n of the obstacle and one or two
// tangents. In it u_i = (u_ni, u_ti) and r_i = (r_ni, r_ti), section 2 of the paper.
#pragma once

#include <Eigen/Core>

#include "problems/structure/model/structure.hpp"
#include "support/numbers/precise.hpp"

namespace kusabi::problems {

/// The orthonormal frame of a candidate: d x d, columns n, t1 and, in space, t2 = n x t1.
///
/// t1 is the wished tangent less its part along n. Without a wish it is, in the plane, n turned
/// clockwise by a quarter, and in space the projection of the axis that is farthest from n (of
/// equals the first): a rule without a choice, so the same file gives the same numbers.
/// @pre the candidate passes `check_structure`
Eigen::MatrixXd contact_frame(const ContactCandidate& candidate);

/// The same with 104 bits, from the doubles of the candidate meant exactly: n has their direction.
numbers::PreciseMatrix precise_contact_frame(const ContactCandidate& candidate);

/// Sine of the angle between a unit `normal` and a `tangent` of any length (both d); NaN if the
/// tangent is zero.
double tangent_sine(const Eigen::VectorXd& normal, const Eigen::VectorXd& tangent);

}  // namespace kusabi::problems
