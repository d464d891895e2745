// Load factors of a truss by independent code: B, T and the loads directly from the structure, (5)
// of the limit paper in the units of the structure, by GLPK.
#pragma once

#include <optional>

#include <Eigen/Core>

#include "problems/structure/model/structure.hpp"

namespace kusabi::limit::test {

/// T, free displacements x parameters, and all other data of (5).
struct PlainTruss {
  Eigen::MatrixXd equilibrium;
  Eigen::MatrixXd uncertain;
  Eigen::VectorXd dead;
  Eigen::VectorXd reference;
  Eigen::VectorXd tension;
  Eigen::VectorXd compression;

  explicit PlainTruss(const problems::Structure& truss);

  /// max { lambda : B q = f_D + T zeta + lambda f_R, -q^c <= q <= q^t }; nothing if there is no q.
  [[nodiscard]] std::optional<double> factor(const Eigen::VectorXd& zeta) const;
  /// The least over all vertices of the box; nothing if a vertex has no factor.
  [[nodiscard]] std::optional<double> min_over_corners(double alpha) const;
};

}  // namespace kusabi::limit::test
