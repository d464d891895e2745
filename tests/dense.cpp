// Instances of Eigen's decompositions.
#include "dense.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <Eigen/QR>

namespace kusabi::dense {

Eigen::MatrixXd solve(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b) {
  return Eigen::FullPivLU<Eigen::MatrixXd>(a).solve(b);
}

Eigen::MatrixXd inverse(const Eigen::MatrixXd& a) {
  return a.inverse();
}

Eigen::Index rank(const Eigen::MatrixXd& a) {
  return Eigen::FullPivLU<Eigen::MatrixXd>(a).rank();
}

Eigen::MatrixXd kernel(const Eigen::MatrixXd& a, double threshold) {
  Eigen::FullPivLU<Eigen::MatrixXd> factorised(a);
  factorised.setThreshold(threshold);
  // Eigen's kernel of a regular matrix is a column of zeros.
  return factorised.kernel().leftCols(factorised.dimensionOfKernel());
}

Eigen::MatrixXd least_squares(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b,
                              double threshold) {
  Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> factorised(a.rows(), a.cols());
  factorised.setThreshold(threshold);
  return factorised.compute(a).solve(b);
}

Eigen::MatrixXd orthonormal(const Eigen::MatrixXd& a) {
  return Eigen::HouseholderQR<Eigen::MatrixXd>(a).householderQ();
}

Eigen::VectorXd eigenvalues(const Eigen::MatrixXd& symmetric) {
  return Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(symmetric, Eigen::EigenvaluesOnly)
      .eigenvalues();
}

Eigen::VectorXd eigenvalues(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b) {
  return Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd>(a, b, Eigen::EigenvaluesOnly)
      .eigenvalues();
}

}  // namespace kusabi::dense
