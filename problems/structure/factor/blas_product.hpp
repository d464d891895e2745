// Products of large dense matrices by the BLAS, on one thread.
#pragma once

#include <Eigen/Core>

namespace kusabi::problems {

/// Sets OpenBLAS and OpenMP to one thread: several ranks share the cores.
void use_one_thread();

/// A' B. The order of its sums depends on the BLAS and the processor.
/// @param a k x m  @param b k x n  @return m x n
Eigen::MatrixXd product_of_columns(const Eigen::Ref<const Eigen::MatrixXd>& a,
                                   const Eigen::Ref<const Eigen::MatrixXd>& b);

}  // namespace kusabi::problems
