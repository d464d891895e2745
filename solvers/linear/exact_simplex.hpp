// Linear programs whose answer is proved in rational numbers. GLPK's exact simplex method finds the
// basis; the basis itself is then solved and checked here, since the method is an answer of a
// simplex like any other. A program that is too large for rational numbers stays open.
#pragma once

#include <vector>

#include "solvers/linear/basis.hpp"
#include "solvers/linear/linear_program.hpp"
#include "solvers/linear/rounded.hpp"
#include "solvers/linear/simplex.hpp"
#include "support/stop.hpp"

namespace kusabi::linear {

/// Numbers of the exact solution, rounded to the nearest double unless stated otherwise.
struct ExactSolution {
  /// Proved: `optimal`, `infeasible` or `unbounded` (there is a point, and a direction without
  /// end). Otherwise `failed`, if the work exceeds its limit, or `interrupted`.
  LinearStatus status = LinearStatus::failed;
  std::vector<double> values = {};  ///< of the columns at the optimum
  /// Of the rows, with the signs of Simplex::dual(); if `infeasible`, multipliers that prove it.
  std::vector<double> duals = {};
  std::vector<Interval> reduced = {};  ///< c - A'dual at the optimum, enclosed
  double objective = 0;
  double bound = -infinity;  ///< the optimum, rounded down
  Basis basis = {};
};

/// Solves the program from `start`, a basis of it or of its first rows; empty: from slacks. The
/// result depends on the arguments alone.
ExactSolution solve_exactly(const LinearProgram& program, const Basis& start,
                            const support::Stop& stop = {});

}  // namespace kusabi::linear
