// Instances of Eigen's decompositions.
#include "dense.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>

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

Eigen::VectorXd eigenvalues(const Eigen::MatrixXd& symmetric) {
  return Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(symmetric, Eigen::EigenvaluesOnly)
      .eigenvalues();
}

Eigen::VectorXd eigenvalues(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b) {
  return Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd>(a, b, Eigen::EigenvaluesOnly)
      .eigenvalues();
}

}  // namespace kusabi::dense
