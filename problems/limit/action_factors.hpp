// Factors of the actions of a combination by EN 1990 under one of its loads.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "problems/limit/limit_problem.hpp"
#include "problems/structure/model/structure.hpp"

namespace kusabi::problems {

struct ActionFactor {
  std::string action;
  /// Nothing: the action acts on supported displacements only, and any of its factors will do.
  std::optional<double> factor;
  bool reference;  ///< the load factor multiplies it further
};

/// The factors of all actions, in the order of the load case; none if it is no combination.
/// @param truss of one load case  @param shares zeta_j / h_j of each uncertain load, m
std::vector<ActionFactor> action_factors(const Structure& truss, const LimitProblem& problem,
                                         const Eigen::VectorXd& shares);

}  // namespace kusabi::problems
