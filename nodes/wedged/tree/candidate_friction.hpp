// Friction of the candidates at one coefficient of a search.
#pragma once

#include <vector>

#include "problems/wedged/wedged_problem.hpp"

namespace kusabi::wedged {

/// mu_i = coefficient x phi_i of each contact candidate; functions that take friction by candidate
/// check the range.
inline std::vector<double> candidate_friction(const problems::WedgedProblem& problem,
                                              double coefficient) {
  std::vector<double> friction = problem.friction;
  for (double& each : friction) each *= coefficient;
  return friction;
}

}  // namespace kusabi::wedged
