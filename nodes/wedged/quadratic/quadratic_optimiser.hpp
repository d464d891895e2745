// The largest friction coefficient up to which a quadratic form proves that nothing is wedged, and
// its multipliers: -log det(-form) - w log f is minimised over multipliers and coefficient f by
// L-BFGS, with a weight w that grows from round to round.
#pragma once

#include <vector>

#include "problems/wedged/wedged_problem.hpp"
#include "support/stop.hpp"

namespace kusabi::wedged {

struct QuadraticBound {
  double factor = 0;            ///< nothing is wedged at this coefficient or below
  std::vector<double> numbers;  ///< QuadraticMultipliers::numbers()
  int evaluations = 0;          ///< of the potential

  template <class Archive>
  void serialize(Archive& archive, unsigned /*version*/) {
    archive& factor& numbers& evaluations;
  }
};

/// Rounds of the optimisation, each with a larger weight; it usually ends before.
inline constexpr int max_form_rounds = 22;

struct QuadraticParameters {
  double enough = 0;             ///< smaller bounds are of no interest
  double maximum = 0;            ///< larger bounds are of no interest
  int rounds = max_form_rounds;  ///< 0: the first multipliers only
  support::Stop stop{};
};

/// The bound, found in doubles and held by form_proves_infeasible(); 0: none.
/// @param block a problem of one block
QuadraticBound quadratic_bound(const problems::WedgedProblem& block,
                               const QuadraticParameters& parameters);

}  // namespace kusabi::wedged
