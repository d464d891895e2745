// A linear program to more digits than a double has. GLPK's tolerance of 1e-9 times a penalty of
// 1e12 is not a small number: rows are made to hold, and duals to fit, to about 1e-25 of their
// terms.
//
// The basis that GLPK ends with is solved in 104 bits, with its factorisation as the guess of each
// step. If that shows a row, a bound or a reduced cost on the wrong side, the program that is left
// of it is scaled up until GLPK can see it, and solved again from there: A. M. Gleixner,
// D. E. Steffy, K. Wolter, Iterative refinement for linear programming, INFORMS J. Comput. 28
// (2016) 449-464.
#pragma once

#include <vector>

#include "solvers/linear/basis.hpp"
#include "solvers/linear/linear_program.hpp"
#include "solvers/linear/simplex.hpp"
#include "support/numbers/precise.hpp"
#include "support/stop.hpp"

namespace kusabi::linear {

struct PreciseSolution {
  /// `optimal`, `infeasible` and `unbounded` as GLPK says of the program scaled up; otherwise
  /// `failed` (the digits do not come, or the basis does not settle) or `interrupted`.
  LinearStatus status = LinearStatus::failed;
  std::vector<numbers::Precise> values;  ///< of the columns, within their bounds, if `optimal`
  /// Of the rows, if `optimal`; if `infeasible`, what Simplex::farkas() gives.
  std::vector<numbers::Precise> duals;
  numbers::Precise objective = 0.0;
  Basis basis;
};

/// Solves the program from `start`, a basis of GLPK's for it or for one near to it; empty: from
/// slacks. The result depends on the arguments alone.
PreciseSolution solve_precisely(const LinearProgram& program, const Basis& start,
                                const support::Stop& stop = {});

}  // namespace kusabi::linear
