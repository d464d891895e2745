// Linear equations with few unknowns in rational numbers, so that linear dependence is decided
// exactly.
#pragma once

#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include <gmpxx.h>

namespace kusabi::verify {

using Rationals = std::vector<mpq_class>;

/// Dot product. @pre a.size() == b.size()
mpq_class dot(const Rationals& a, const Rationals& b);

/// The solution space of a growing set of homogeneous equations.
class Elimination {
 public:
  /// The space of all vectors of a size.
  explicit Elimination(std::size_t unknowns);
  /// The span of some independent vectors.
  explicit Elimination(std::vector<Rationals> columns) : basis_(std::move(columns)) {}

  /// Products of a row with the basis of the solution space; all are zero if row'x = 0 follows from
  /// the equations.
  [[nodiscard]] Rationals products(const Rationals& row) const;

  /// Adds the equation row'x = 0.
  /// @return true if the dimension of the solution space decreases by one
  bool add_equation(const Rationals& row);

  /// Adds all these equations, each time the one with the largest product with a basis vector. No
  /// removed vector is then nearly a combination of the others, even if scales differ widely.
  void add_equations_largest_first(const std::vector<Rationals>& rows);

  /// A basis of the solution space.
  [[nodiscard]] const std::vector<Rationals>& basis() const { return basis_; }

  /// For each equation that decreased the dimension, the basis vector that was removed. Together
  /// with `left` they are a basis of the initial space.
  [[nodiscard]] const std::vector<Rationals>& removed() const { return removed_; }

 private:
  // Removes a vector by the products of a row, and its part from the products of other rows.
  void take(std::size_t at, Rationals pivots, std::vector<Rationals>& products);

  std::vector<Rationals> basis_;
  std::vector<Rationals> removed_;
};

/// A solution x of row'x = right for all rows. @return nothing if there is none
std::optional<Rationals> solution(std::vector<Rationals> rows, const Rationals& right);

/// The columns of the inverse of a square matrix, given by its rows. @return nothing if it is
/// singular
std::optional<std::vector<Rationals>> inverse_columns(std::vector<Rationals> rows);

}  // namespace kusabi::verify
