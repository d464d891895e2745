// Simplex solution of a linear program to extended precision. GLPK's tolerance of 1e-9 times a
// penalty of 1e12 is large; here rows and duals are accurate to about 1e-25 of their terms.
//
// The final basis of GLPK is solved in 104 bits, with its factorisation as approximate inverse. If
// a row, a bound or a reduced cost is violated, the residual program is scaled up to GLPK's range
// and solved again from there: A. M. Gleixner, D. E. Steffy, K. Wolter, Iterative refinement for
// linear programming, INFORMS J. Comput. 28 (2016) 449-464.
#pragma once

#include <vector>

#include "solvers/linear/basis.hpp"
#include "solvers/linear/linear_program.hpp"
#include "solvers/linear/simplex.hpp"
#include "support/numbers/precise.hpp"
#include "support/stop.hpp"

namespace kusabi::linear {

struct PreciseSolution {
  /// `optimal`, `infeasible` and `unbounded` as GLPK states for the scaled program; otherwise
  /// `failed` (the refinement does not converge, or the basis does not settle) or `interrupted`.
  LinearStatus status = LinearStatus::failed;
  std::vector<numbers::Precise> values;  ///< of the columns, within their bounds, if `optimal`
  /// Of the rows, if `optimal`; if `infeasible`, the multipliers of Simplex::farkas().
  std::vector<numbers::Precise> duals;
  numbers::Precise objective = 0.0;
  Basis basis;
};

/// Solves the program from `start`, a basis of GLPK's for it or for a similar one; empty: from
/// slacks. The result depends on the arguments alone.
PreciseSolution solve_precisely(const LinearProgram& program, const Basis& start,
                                const support::Stop& stop = {});

}  // namespace kusabi::linear
