// Least-squares rigid-body part of a displacement of unconstrained bodies. Certificates use it,
// since it does not depend on the grounding springs of F.
#pragma once

#include <vector>

#include <Eigen/Core>

#include "problems/wedged/wedged_problem.hpp"

namespace kusabi::wedged {

class MeanMotion {
 public:
  /// @param problem of a block
  explicit MeanMotion(const problems::WedgedProblem& problem);

  /// The number p of rigid-body modes.
  [[nodiscard]] Eigen::Index count() const { return mean_.rows(); }

  /// m.
  [[nodiscard]] Eigen::Index candidates() const { return mean_of_y_.cols(); }

  /// (G'G)^-1 G'u. @param displacements u, dm
  [[nodiscard]] Eigen::VectorXd of(const Eigen::VectorXd& displacements) const {
    return mean_ * displacements;
  }

  /// The same for w = F y + unit G beta, appended to y.
  /// @param multipliers y at the normals, m, and beta, p
  [[nodiscard]] std::vector<double> with_multipliers(const Eigen::VectorXd& multipliers,
                                                     double unit) const;

 private:
  Eigen::MatrixXd mean_;       // p x dm
  Eigen::MatrixXd mean_of_y_;  // p x m: of F y
};

}  // namespace kusabi::wedged
