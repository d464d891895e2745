// Rows of a superelement among the free displacements, in any precision.
#pragma once

#include <cstddef>
#include <vector>

#include "problems/structure/model/elongation.hpp"
#include "problems/structure/model/structure.hpp"
#include "problems/structure/model/truss.hpp"

namespace kusabi::problems {

/// The free displacements in each row of a superelement, with their weights; none where it is
/// fixed.
/// @param index of the superelement
template <class Scalar>
std::vector<StrainVector<Scalar>> superelement_parts(const Structure& structure,
                                                     const FreeDegrees& degrees,
                                                     std::size_t index) {
  const auto& rows = structure.superelements[index].rows;
  std::vector<StrainVector<Scalar>> parts;
  parts.reserve(rows.size());
  for (std::size_t row = 0; row < rows.size(); ++row) {
    if (rows[row].node >= 0) {
      parts.push_back(parts_of<Scalar>(degrees, rows[row].axis, rows[row].node));
    } else {
      parts.push_back({{degrees.internal_unknowns[index][row], Scalar(1.0)}});
    }
  }
  return parts;
}

/// Calls `use(number, number, value)` for all contributions of a nonzero entry K_ij of a
/// superelement: K_ij times the weights of a part of i and a part of j.
template <class Scalar, class Use>
void for_each_entry(const Structure& structure, const FreeDegrees& degrees, std::size_t index,
                    const Use& use) {
  const auto parts = superelement_parts<Scalar>(structure, degrees, index);
  const auto& matrix = structure.superelements[index].stiffness;
  for (int j = 0; j < static_cast<int>(matrix.outerSize()); ++j) {
    for (Eigen::SparseMatrix<double>::InnerIterator entry(matrix, j); entry; ++entry) {
      if (entry.value() == 0) continue;
      for (const auto& row : parts[static_cast<std::size_t>(entry.row())]) {
        for (const auto& column : parts[static_cast<std::size_t>(j)]) {
          // The product of the two weights is computed first, so that (i, j) and (j, i) have the
          // same rounding.
          use(row.number, column.number, entry.value() * (row.value * column.value));
        }
      }
    }
  }
}

/// The nodes of a superelement, without repetitions, in increasing order.
std::vector<int> nodes_of(const Superelement& superelement);

}  // namespace kusabi::problems
