// Load factors of a truss by a route of its own: B, T and the loads straight from the structure,
// (5) of the limit paper in the units of the structure, by GLPK with nothing of ours between.
#pragma once

#include <optional>

#include <Eigen/Core>

#include "problems/structure/model/structure.hpp"

namespace kusabi::limit::test {

/// T, free displacements x parameters, and all else that (5) is made of.
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
  /// The least over all corners of the box; nothing if a corner is carried at no factor.
  [[nodiscard]] std::optional<double> least_of_all_corners(double alpha) const;
};

}  // namespace kusabi::limit::test
