// Linear program of all static cuts: member forces and the load factor as affine functions of the
// uncertain loads. With P_j = alpha w_j y_j and kappa_j = alpha w_j k_j of a static cut (y_j, k_j)
// for each column j of T, forces q_0 and a factor lambda_0, it is
//
//   max lambda_0 - sum_j |kappa_j|
//   s.t. A [q_0 P; lambda_0 kappa] = [f_D  alpha T],   A = [B, -f_R],
//        |q_0,i - (q^t_i - q^c_i) / 2| + sum_j |P_ij| <= (q^t_i + q^c_i) / 2   for each member i.
//
// Here q_0 is shifted by (q^t - q^c) / 2, so that each row is an l1 ball.
#pragma once

#include <utility>
#include <vector>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include "problems/limit/limit_analysis.hpp"

namespace kusabi::limit::splitting {

/// A load: displacements and numbers.
using SparseLoad = std::vector<std::pair<int, double>>;

struct AffineProgram {
  Eigen::SparseMatrix<double> equilibrium;  ///< A, n^d x (n^m + 1)
  Eigen::VectorXd capacity;                 ///< (q^t + q^c) / 2, n^m
  Eigen::VectorXd shift;                    ///< (q^t - q^c) / 2, n^m
  Eigen::VectorXd dead;                     ///< f_D - B shift, n^d
  std::vector<SparseLoad> loads;            ///< alpha t_j, m
  std::vector<SparseLoad> columns;          ///< right-hand sides: `dead`, then the loads

  [[nodiscard]] int members() const { return static_cast<int>(capacity.size()); }
  /// Rows of the unknown: one for each member, and that of the factor.
  [[nodiscard]] int rows() const { return members() + 1; }
  [[nodiscard]] int displacements() const { return static_cast<int>(dead.size()); }
};

/// @param alpha scaled, > 0
AffineProgram affine_program(const problems::LimitModel& model, double alpha);

}  // namespace kusabi::limit::splitting
