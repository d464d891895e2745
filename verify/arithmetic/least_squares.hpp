// Linear least squares in double precision, for approximate solutions.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace kusabi::verify {

/// Orthogonal columns of a matrix A, for any number of right-hand sides.
class LeastSquares {
 public:
  /// @param matrix A, by rows
  LeastSquares(std::span<const double> matrix, std::size_t rows);

  /// x that minimises |A x - b|. Nothing if a column vanishes beside those before it, if there are
  /// more of them than rows, or for a b of another size.
  [[nodiscard]] std::optional<std::vector<double>> solve(std::span<const double> right) const;

 private:
  /// A unit vector, which is zero outside of `first` to `end`.
  struct Unit {
    std::vector<double> values;
    std::size_t first = 0, end = 0;

    /// Subtracts the component along it from a column. @return that component
    double take_out(std::vector<double>& from) const;
  };

  bool independent_ = true;
  std::vector<Unit> units_;
  std::vector<std::vector<double>> parts_;  // [i][j]: component of column i along unit vector j
};

}  // namespace kusabi::verify
