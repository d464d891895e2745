// Face of the certificates that are consistent with a collapse under a critical load, if it is the
// worst case.
//
// With the motion u and the signs s of the load, W_j = s_j P_j, K_j = s_j kappa_j, and the state
// under that load, a = q_0 + sum_j W_j, virtual work implies
//   a_i = e_i q_i where e_i = sign(b_i'u) is not zero,  e_i W_ij >= 0 there,  K_j <= 0,
//   W_ij = 0 there and K_j = 0 for loads without work on u,
// and then lambda_0 - sum_j |kappa_j| is the factor of the collapse. What remains is
//   sum_j |W_ij| <= q_i where e_i is not zero,
//   2 sum_j [W_ij]_+ <= q_i + a_i,  2 sum_j [W_ij]_- <= q_i - a_i elsewhere,
// without the nearly redundant constraints. (Yield forces are shifted as in affine_program.hpp.)
#pragma once

#include <vector>

#include <Eigen/Core>

#include "nodes/limit/splitting/affine_program.hpp"

namespace kusabi::limit::splitting {

struct Face {
  double factor = 0;                ///< lambda*
  std::vector<int> signs;           ///< s, m
  std::vector<int> stretches;       ///< e, n^m
  std::vector<bool> works;          ///< true if load j does work on u, m
  std::vector<SparseLoad> columns;  ///< right-hand sides: none for column 0, then s_j alpha t_j
  Eigen::VectorXd critical;         ///< the dead load with the critical one, n^d
};

/// @param motion u with f_R'u = 1, n^d @param signs of the critical load, m
Face face_of(const AffineProgram& program, double factor, const Eigen::VectorXd& motion,
             std::vector<int> signs);

}  // namespace kusabi::limit::splitting
