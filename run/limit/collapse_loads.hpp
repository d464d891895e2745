// Nodal forces on a truss at collapse: loads and support reactions.
#pragma once

#include <Eigen/Core>

#include "nodes/limit/root/limit_answer.hpp"
#include "problems/limit/limit_problem.hpp"
#include "problems/structure/model/structure.hpp"

namespace kusabi::run {

/// f_D + lambda f_R at all nodes, d x nodes, force, including loads on supports.
/// @param dead f_D over the free displacements, n^d
Eigen::MatrixXd load_at_collapse(const problems::Structure& truss,
                                 const problems::LimitProblem& problem,
                                 const limit::LimitCollapse& collapse, const Eigen::VectorXd& dead);

/// Support reactions: the sum of load and member forces along fixed axes, with opposite sign; zero
/// elsewhere. d x nodes, force.
/// @param load as above
/// @param forces q of the members, positive in tension
Eigen::MatrixXd support_reactions(const problems::Structure& truss, const Eigen::MatrixXd& load,
                                  const Eigen::VectorXd& forces);

}  // namespace kusabi::run
