// Coefficients by the pseudo-inverse of G.
#include "nodes/wedged/relaxation/mean_motion.hpp"

#include <Eigen/QR>

namespace kusabi::wedged {

MeanMotion::MeanMotion(const problems::WedgedProblem& problem) {
  const auto m = static_cast<Eigen::Index>(problem.contact_names.size());
  mean_ =
      problem.modes.matrix.cols() == 0
          ? Eigen::MatrixXd(0, problem.compliance.matrix.rows())
          : Eigen::MatrixXd(problem.modes.matrix.completeOrthogonalDecomposition().pseudoInverse());
  Eigen::MatrixXd normals(problem.compliance.matrix.rows(), m);
  for (Eigen::Index i = 0; i < m; ++i)
    normals.col(i) = problem.compliance.matrix.col(problem.dimension * i);
  mean_of_y_ = mean_ * normals;
}

std::vector<double> MeanMotion::with_multipliers(const Eigen::VectorXd& multipliers,
                                                 double unit) const {
  const Eigen::VectorXd y = multipliers.head(mean_of_y_.cols());
  std::vector<double> numbers(y.begin(), y.end());
  const Eigen::VectorXd mean = mean_of_y_ * y + unit * multipliers.segment(y.size(), count());
  numbers.insert(numbers.end(), mean.begin(), mean.end());
  return numbers;
}

}  // namespace kusabi::wedged
