// A conic program as plain data, and the program of a node of the tree of sign patterns in it: as
// it is derived (node_program.hpp), before it is brought into the standard form that is solved
// here, so that other solvers can be asked the same.
#pragma once

#include <span>
#include <vector>

#include <Eigen/Core>

#include "support/index_set.hpp"

namespace kusabi::conic {

/// What some numbers in a row must be together.
struct ConePart {
  enum class Kind {
    free,          ///< anything
    zero,          ///< all zero
    nonnegative,   ///< none below zero
    second_order,  ///< the first at least the norm of the others
  };
  Kind kind;
  int size;

  friend bool operator==(const ConePart&, const ConePart&) = default;
};

/// Maximise costs'x, where x is in the cones `columns` and matrix x + constants in the cones
/// `rows`, one after another.
struct ConeProgram {
  std::vector<ConePart> columns;
  std::vector<ConePart> rows;
  Eigen::VectorXd costs;      ///< one a column
  Eigen::MatrixXd matrix;     ///< rows x columns
  Eigen::VectorXd constants;  ///< one a row
};

/// The program of the node (U, R), the form of (23) of the wedged paper:
///
///   max t  s.t.  sum_i r_ni = 1,  (F r)_ni = 0 (i in U),  (F r)_nj - t >= 0 (j not in U),
///                (mu_i r_ni - t, r_ti) in the second-order cone (i not in R),  r_i = 0 (i in R);
///
/// without friction r_ti = 0 and r_ni - t >= 0. Columns: r, Dm numbers ordered as F, then t. Rows
/// in the order above, candidate by candidate.
/// @param compliance F, Dm x Dm
/// @param friction mu, m numbers
/// @param contact U, and @param separated R
/// @throws std::invalid_argument if the sizes do not fit, or the sets overlap or name a candidate
///   that does not exist
ConeProgram node_cone_program(const Eigen::MatrixXd& compliance, std::span<const double> friction,
                              const support::IndexSet& contact, const support::IndexSet& separated);

}  // namespace kusabi::conic
