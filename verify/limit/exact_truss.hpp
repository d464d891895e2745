// Truss in rational numbers. The force of a member is its force density times its length: direction
// cosines are roots, but equilibrium of force densities has the coordinates as coefficients.
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include <gmpxx.h>

#include "verify/limit/limit_truss.hpp"
#include "verify/structure/freedom.hpp"
#include "verify/structure/structure.hpp"

namespace kusabi::verify {

/// Indices and rational numbers; all others are zero.
using SparseRational = std::vector<std::pair<std::size_t, mpq_class>>;

struct ExactTruss {
  std::size_t displacements = 0;
  std::vector<SparseRational> columns;      ///< by member: B times the length of the member
  std::vector<mpq_class> square_lengths;    ///< by member
  std::vector<mpq_class> tension;           ///< q^t
  std::vector<mpq_class> compression;       ///< q^c
  std::vector<mpq_class> dead;              ///< f_D
  std::vector<mpq_class> reference;         ///< f_R
  std::vector<SparseRational> uncertain{};  ///< alpha_j t_j

  [[nodiscard]] std::size_t members() const { return columns.size(); }
};

/// Sum of nodal forces by free displacement.
template <class Number>
std::vector<Number> sum_of(const std::vector<Force>& forces, const Structure& structure,
                           const Freedom& freedom) {
  std::vector<Number> sum(freedom.count);
  for (const auto& force : forces) {
    for (std::size_t axis = 0; axis < structure.dimension; ++axis) {
      const auto number = freedom.number[force.node][axis];
      if (number != Freedom::none) sum[number] = sum[number] + Number(force.components[axis]);
    }
  }
  return sum;
}

/// The columns of T by free displacement. Without uncertain loads in the structure, one for each
/// displacement whose loads have the sum zero in double precision.
std::vector<Sparse> uncertain_columns(const Structure& structure, const Freedom& freedom);

/// The truss, with its uncertain loads if the structure has them.
/// @param sudden dynamic factor of a loss, which divides the yield forces
/// @pre a truss without ties and inclined supports
ExactTruss exact_truss(const Structure& structure, double sudden = 1);

}  // namespace kusabi::verify
