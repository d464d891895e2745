// Cholesky factor in double precision of B W B' over some members of a truss, for approximate
// solutions.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "verify/arithmetic/cholesky.hpp"
#include "verify/limit/limit_truss.hpp"

namespace kusabi::verify {

class Gram {
 public:
  /// @param columns B, by member
  /// @param members the members of the sum
  /// @param weight W, by member, for `members`
  /// @param displacements all displacements of these members
  /// @param count of all displacements of the truss
  /// @param shift of the diagonal, relative to each entry
  Gram(const std::vector<Sparse>& columns, const std::vector<std::size_t>& members,
       const std::vector<double>& weight, const std::vector<std::size_t>& displacements,
       std::size_t count, double shift = 0);

  /// True if there is a factor: no pivot is zero or negative, and memory suffices.
  [[nodiscard]] bool definite() const { return factor_.has_value(); }

  /// Index of a displacement in `diagonal` and `solve`.
  [[nodiscard]] std::size_t place(std::size_t displacement) const { return place_[displacement]; }

  /// Diagonal of B W B', by place.
  [[nodiscard]] const std::vector<double>& diagonal() const { return diagonal_; }

  /// Solves in place. @pre definite()
  void solve(std::span<double> right) const { factor_->solve(right); }

 private:
  std::vector<std::size_t> place_;
  std::vector<double> diagonal_;
  std::optional<Cholesky> factor_;
};

}  // namespace kusabi::verify
