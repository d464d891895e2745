// Factors of the actions of a combination by EN 1990 under one of its loads.
#pragma once

#include <string>
#include <vector>

#include <Eigen/Core>

#include "problems/limit/limit_problem.hpp"
#include "problems/structure/model/structure.hpp"

namespace kusabi::problems {

struct ActionFactor {
  std::string action;
  double factor;
  bool reference;  ///< the load factor multiplies it further
};

/// The factors of all actions, in the order of the load case; none if it is no combination.
/// @param truss of one load case  @param shares zeta_j / h_j of each uncertain load, m
/// @throws std::logic_error if an action with a range of factors is none of the uncertain loads
std::vector<ActionFactor> action_factors(const Structure& truss, const LimitProblem& problem,
                                         const Eigen::VectorXd& shares);

}  // namespace kusabi::problems
