// A cut as a candidate, so that programs without cuts can check programs with cuts.
//
// A separated candidate has a gap row, u_n >= t, only. A cut, divided by its level, is therefore
// the gap row of one further such candidate, with the cut's numbers in its row of F, and a diagonal
// entry large enough that F stays definite.
#pragma once

#include <Eigen/Core>

#include "dense.hpp"
#include "solvers/conic/cut.hpp"

namespace kusabi::conic::testing {

/// F with that candidate after all others.
/// @param cones number of rows of F of the original candidates, D each
template <int D>
Eigen::MatrixXd with_candidate_for(const Cut& cut, const Eigen::MatrixXd& compliance,
                                   Eigen::Index cones) {
  const Eigen::Index size = compliance.rows();
  const Eigen::Index own = Eigen::Index{D} * cut.candidate;
  Eigen::VectorXd row = -cut.displacement * compliance.col(own);
  for (Eigen::Index k = 0; k < cones; k += D) row[k] += cut.share;
  row[own] -= cut.reaction;
  row /= cut.level;
  Eigen::MatrixXd whole = Eigen::MatrixXd::Identity(size + D, size + D);
  whole.topLeftCorner(size, size) = compliance;
  whole.col(size).head(size) = row;
  whole.row(size).head(size) = row.transpose();
  whole(size, size) = 1 + 2 * row.dot(dense::solve(compliance, row).col(0));
  return whole;
}

}  // namespace kusabi::conic::testing
