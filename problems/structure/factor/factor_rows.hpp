// Sums over the rows of a factor, from any way of visiting its entries.
#pragma once

#include <cmath>

#include <Eigen/Core>

#include "problems/structure/factor/sparse_factor.hpp"

namespace kusabi::problems {

/// @param for_all called with a function of row, column and entry, which it calls for each entry
template <class ForAll>
FactorRows rows_of_factor(Eigen::Index size, const ForAll& for_all) {
  Eigen::VectorXd columns = Eigen::VectorXd::Zero(size);  // |L'| times the vector of ones
  Eigen::VectorXi entries = Eigen::VectorXi::Zero(size);
  for_all([&](Eigen::Index row, Eigen::Index column, double entry) {
    columns(column) += std::abs(entry);
    ++entries(row);
  });
  Eigen::VectorXd sums = Eigen::VectorXd::Zero(size);
  for_all([&](Eigen::Index row, Eigen::Index column, double entry) {
    sums(row) += std::abs(entry) * columns(column);
  });
  if (size == 0) return {};
  return {.maximum_sum = sums.maxCoeff(), .maximum_entries = entries.maxCoeff()};
}

}  // namespace kusabi::problems
