// Where displacements have gone on the whole, of bodies that nothing holds: what a certificate says
// of rigid motions, so that it does not hang on the temporary springs that F was computed with.
#pragma once

#include <vector>

#include <Eigen/Core>

#include "problems/wedged/wedged_problem.hpp"

namespace kusabi::wedged {

class MeanMotion {
 public:
  /// @param problem of a block
  explicit MeanMotion(const problems::WedgedProblem& problem);

  /// How many motions there are: p.
  [[nodiscard]] Eigen::Index count() const { return mean_.rows(); }

  /// (G'G)^-1 G'u. @param displacements u, dm
  [[nodiscard]] Eigen::VectorXd of(const Eigen::VectorXd& displacements) const {
    return mean_ * displacements;
  }

  /// The same of w = F y + unit G beta, behind y.
  /// @param multipliers y at the normals, m, and beta, p
  [[nodiscard]] std::vector<double> with_multipliers(const Eigen::VectorXd& multipliers,
                                                     double unit) const;

 private:
  Eigen::MatrixXd mean_;       // p x dm
  Eigen::MatrixXd mean_of_y_;  // p x m: of F y
};

}  // namespace kusabi::wedged
