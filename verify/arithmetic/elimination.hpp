// Linear equations with few unknowns, in rational numbers: whether they depend on each other is
// known, not guessed.
#pragma once

#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include <gmpxx.h>

namespace kusabi::verify {

using Rationals = std::vector<mpq_class>;

/// The sum of products. @pre of one size
mpq_class dot(const Rationals& a, const Rationals& b);

/// The vectors that a growing set of equations leaves.
class Elimination {
 public:
  /// All vectors of a size.
  explicit Elimination(std::size_t unknowns);
  /// All combinations of some vectors, which are independent.
  explicit Elimination(std::vector<Rationals> columns) : left_(std::move(columns)) {}

  /// Products of a row with the vectors that are left: all zero if they satisfy row'x = 0.
  [[nodiscard]] Rationals products(const Rationals& row) const;

  /// From here on row'x = 0. @return whether that was not so before: a vector less is left
  bool demand(const Rationals& row);

  /// The same of all rows, each time of the one in which a vector that is left is largest: no
  /// vector that is taken is then nearly a combination of the others, however far scales are apart.
  void demand_largest_first(const std::vector<Rationals>& rows);

  /// A basis of what is left.
  [[nodiscard]] const std::vector<Rationals>& left() const { return left_; }

  /// Of each row that made a difference, a vector that it took away: with those that are left, a
  /// basis of all.
  [[nodiscard]] const std::vector<Rationals>& taken() const { return taken_; }

 private:
  // Takes a vector away by the products of a row, and out of the products of others.
  void take(std::size_t at, const Rationals& pivots, std::vector<Rationals>& products);

  std::vector<Rationals> left_;
  std::vector<Rationals> taken_;
};

/// One solution x of row'x = right for all rows. @return nothing if there is none
std::optional<Rationals> solution(std::vector<Rationals> rows, Rationals right);

}  // namespace kusabi::verify
