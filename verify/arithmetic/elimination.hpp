// Linear equations with few unknowns in rational numbers, such that linear dependence is decided
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
  explicit Elimination(std::vector<Rationals> columns) : left_(std::move(columns)) {}

  /// Products of a row with the basis of the solution space; all are zero if row'x = 0 follows from
  /// the equations.
  [[nodiscard]] Rationals products(const Rationals& row) const;

  /// Adds the equation row'x = 0. @return true if the dimension of the solution space decreases by
  /// one
  bool demand(const Rationals& row);

  /// Adds all these equations, each time the one with the largest product with a basis vector. No
  /// removed vector is then nearly a combination of the others, even if scales differ widely.
  void demand_largest_first(const std::vector<Rationals>& rows);

  /// A basis of the solution space.
  [[nodiscard]] const std::vector<Rationals>& left() const { return left_; }

  /// For each equation that decreased the dimension, the basis vector that was removed. Together
  /// with `left` they are a basis of the initial space.
  [[nodiscard]] const std::vector<Rationals>& taken() const { return taken_; }

 private:
  // Removes a vector by the products of a row, and its part from the products of other rows.
  void take(std::size_t at, Rationals pivots, std::vector<Rationals>& products);

  std::vector<Rationals> left_;
  std::vector<Rationals> taken_;
};

/// A solution x of row'x = right for all rows. @return nothing if there is none
std::optional<Rationals> solution(std::vector<Rationals> rows, Rationals right);

}  // namespace kusabi::verify
