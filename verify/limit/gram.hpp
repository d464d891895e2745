// B W B' of some members of a truss, factorised in plain double precision: to guess with.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "verify/arithmetic/cholesky.hpp"
#include "verify/limit/limit_certificate.hpp"

namespace kusabi::verify {

class Gram {
 public:
  /// @param columns B, by member
  /// @param members those that count
  /// @param weight W, by member, of those that count
  /// @param displacements all that those members touch
  /// @param count of all displacements of the truss
  /// @param shift of the diagonal, relative to each entry
  Gram(const std::vector<Sparse>& columns, const std::vector<std::size_t>& members,
       const std::vector<double>& weight, const std::vector<std::size_t>& displacements,
       std::size_t count, double shift = 0);

  /// Whether there is a factor: not if a pivot is not positive, or it would take too much memory.
  [[nodiscard]] bool definite() const { return factor_.has_value(); }

  /// Where a displacement is in `diagonal` and `solve`.
  [[nodiscard]] std::size_t place(std::size_t displacement) const { return place_[displacement]; }

  /// Of B W B', by place.
  [[nodiscard]] const std::vector<double>& diagonal() const { return diagonal_; }

  /// The solution in the place of the right-hand side. @pre definite()
  void solve(std::span<double> right) const { factor_->solve(right); }

 private:
  std::vector<std::size_t> place_;
  std::vector<double> diagonal_;
  std::optional<Cholesky> factor_;
};

}  // namespace kusabi::verify
