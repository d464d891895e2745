// Reference frame of a contact candidate: the outward normal n of the obstacle and one or two
// tangents. In this frame u_i = (u_ni, u_ti) and r_i = (r_ni, r_ti), section 2 of the wedged paper.
#pragma once

#include <Eigen/Core>

#include "problems/structure/model/structure.hpp"
#include "support/numbers/precise.hpp"

namespace kusabi::problems {

/// The orthonormal frame of a candidate: d x d, columns n, t1 and, in space, t2 = n x t1.
///
/// t1 is the given tangent minus its component along n. Without a given tangent it is, in the
/// plane, n turned clockwise by 90 degrees and, in space, the projection of the axis with the
/// smallest component of n (the first of equal ones).
/// @pre the candidate passes `check_structure`
Eigen::MatrixXd contact_frame(const ContactCandidate& candidate);

/// The same in 104 bits. The doubles of the candidate are taken as exact; n is normalised.
numbers::PreciseMatrix precise_contact_frame(const ContactCandidate& candidate);

/// Sine of the angle between a unit `normal` and a `tangent` of any length; NaN if the tangent is
/// zero.
double tangent_sine(const Eigen::VectorXd& normal, const Eigen::VectorXd& tangent);

}  // namespace kusabi::problems
