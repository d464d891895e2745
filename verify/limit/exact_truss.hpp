// Truss in rational numbers. The force of a member is its force density times its length: direction
// cosines are roots, but equilibrium of force densities has the coordinates as coefficients.
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include <gmpxx.h>

#include "verify/limit/limit_certificate.hpp"
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
      if (number != Freedom::none) sum[number] += Number(force.components[axis]);
    }
  }
  return sum;
}

/// The truss without uncertain loads. @pre a truss without ties and inclined supports
ExactTruss exact_truss(const Structure& structure);

/// Adds uncertain loads. @param columns of T @param alpha half-width of each
void add_uncertain(const std::vector<Sparse>& columns, const std::vector<double>& alpha,
                   ExactTruss& truss);

}  // namespace kusabi::verify
