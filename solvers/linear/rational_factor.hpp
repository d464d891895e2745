// Sparse factors of a square matrix of rational numbers, for the basis of a linear program.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include <gmpxx.h>

#include "support/stop.hpp"

namespace kusabi::linear {

using Rationals = std::vector<mpq_class>;

class RationalFactor {
 public:
  using Row = std::map<std::size_t, mpq_class>;  // column to entry, none zero

  /// Gaussian elimination with Markowitz pivots. Nothing if the matrix is singular, the work
  /// exceeds its limit, or a stop is requested.
  /// @param too_much set to true if the work exceeds its limit
  static std::optional<RationalFactor> of(std::vector<Row> rows, const support::Stop& stop,
                                          bool& too_much);

  /// x with A x = b.
  [[nodiscard]] Rationals solve(Rationals b) const;
  /// y with A'y = c.
  [[nodiscard]] Rationals solve_transposed(Rationals c) const;

 private:
  struct Step {
    std::size_t row;
    std::size_t from;
    mpq_class factor;  // row -= factor * from
  };

  std::vector<Row> rows_;                                    // after all steps
  std::vector<Step> steps_;                                  // in their order
  std::vector<std::pair<std::size_t, std::size_t>> pivots_;  // row and column
};

}  // namespace kusabi::linear
