// ConeProgram: a cone program as plain data, and the program of a node of the tree of sign patterns
// in this form: as derived (node_program.hpp), before its conversion to the standard form that is
// solved here, so that other solvers can be applied to it.
#pragma once

#include <span>
#include <vector>

#include <Eigen/Core>

#include "support/index_set.hpp"

namespace kusabi::conic {

/// Cone of some consecutive numbers.
struct ConePart {
  enum class Kind {
    free,          ///< any value
    zero,          ///< all zero
    nonnegative,   ///< non-negative
    second_order,  ///< the first is at least the norm of the others
  };
  Kind kind;
  int size;

  friend bool operator==(const ConePart&, const ConePart&) = default;
};

/// Maximise costs'x, where x is in the cones `columns`, in sequence, and matrix x + constants in
/// the cones `rows`.
struct ConeProgram {
  std::vector<ConePart> columns;
  std::vector<ConePart> rows;
  Eigen::VectorXd costs;      ///< one per column
  Eigen::MatrixXd matrix;     ///< rows x columns
  Eigen::VectorXd constants;  ///< one per row
};

/// Program of the node (U, R), the form of (23) of the wedged paper:
///
///   max t  s.t.  sum_i r_ni = 1,  (F r)_ni = 0 (i in U),  (F r)_nj - t >= 0 (j not in U),
///                (mu_i r_ni - t, r_ti) in the second-order cone (i not in R),  r_i = 0 (i in R);
///
/// without friction r_ti = 0 and r_ni - t >= 0. Columns: r, Dm numbers ordered as F, then t. Rows
/// in the order above, candidate by candidate.
/// @param compliance F, Dm x Dm
/// @param friction mu, m numbers
/// @param contact U  @param separated R
/// @throws std::invalid_argument if the sizes do not match, or the sets overlap or contain a
///   candidate that does not exist
ConeProgram node_cone_program(const Eigen::MatrixXd& compliance, std::span<const double> friction,
                              const support::IndexSet& contact, const support::IndexSet& separated);

}  // namespace kusabi::conic
