// Dense linear algebra for expectations, compiled once: Eigen's decompositions take seconds to
// compile in each test that calls them.
#pragma once

#include <Eigen/Core>

namespace kusabi::dense {

/// @return X with A X = B, by LU decomposition with full pivoting. @pre A is regular
Eigen::MatrixXd solve(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b);

/// @pre A is regular
Eigen::MatrixXd inverse(const Eigen::MatrixXd& a);

Eigen::Index rank(const Eigen::MatrixXd& a);

/// @return columns that span the x with A x = 0
/// @param threshold pivots below this share of the largest count as zero
Eigen::MatrixXd kernel(const Eigen::MatrixXd& a, double threshold);

/// @return X of least norm among those that minimise |A X - B|
/// @param threshold as of kernel()
Eigen::MatrixXd least_squares(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b, double threshold);

/// @return orthonormal columns, the first k of which span the first k columns of A, for each k
/// @pre A is square and regular
Eigen::MatrixXd orthonormal(const Eigen::MatrixXd& a);

/// @return eigenvalues of a symmetric matrix, in ascending order
Eigen::VectorXd eigenvalues(const Eigen::MatrixXd& symmetric);

/// @return eigenvalues of A x = lambda B x, in ascending order
/// @pre A symmetric, B positive definite
Eigen::VectorXd eigenvalues(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b);

}  // namespace kusabi::dense
