// Mixed 0-1 program (29) of the limit paper from a model of limit analysis.
#pragma once

#include <Eigen/Core>

#include "problems/limit/limit_analysis.hpp"
#include "solvers/linear/linear_program.hpp"

namespace kusabi::problems {

/// Minimise -alpha sum_j weight_j gamma_j - f_D'u + q^y'z over (27) with tau in {0, 1}. Columns: u
/// (n^d), z (n^m), gamma (m), tau (m); gamma_j is |d_j'u| for column j of T, weight_j d_j. Rows:
/// f_R'u = 1; z_i -+ b_i'u >= 0 for each member; gamma_j - d_j'u + M_j tau_j <= M_j and gamma_j +
/// d_j'u - M_j tau_j <= 0 for each column.
/// @param alpha scaled
/// @param big_m M, m, scaled: at least twice the largest |d_j'u| of an optimum
/// @param max_motion bound of |u|, n^d; may be infinite
/// @param max_elongation bound of z, n^m; may be infinite
linear::MixedProgram worst_case_program(const LimitModel& model, double alpha,
                                        const Eigen::VectorXd& big_m,
                                        const Eigen::VectorXd& max_motion,
                                        const Eigen::VectorXd& max_elongation);

/// The point of a motion in worst_case_program(): z = |B'u|, gamma = |d_j'u|, tau its sign.
std::vector<double> worst_case_point(const LimitModel& model, const Eigen::VectorXd& motion);

}  // namespace kusabi::problems
