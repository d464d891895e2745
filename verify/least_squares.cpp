// By the normal equations: the columns are motions of bodies, far from parallel.
#include "verify/least_squares.hpp"

#include "verify/cholesky.hpp"

namespace kusabi::verify {

std::optional<std::vector<double>> least_squares(std::span<const double> matrix,
                                                 std::span<const double> right) {
  if (right.empty() || matrix.empty()) return std::vector<double>{};
  const auto columns = matrix.size() / right.size();
  const auto profile = Profile::full(columns);
  std::vector<double> products(profile.entries(), 0);
  std::vector<double> sums(columns, 0);
  for (std::size_t row = 0; row < right.size(); ++row) {
    const auto own = matrix.subspan(columns * row, columns);
    for (std::size_t i = 0; i < columns; ++i) {
      sums[i] += own[i] * right[row];
      for (std::size_t j = 0; j <= i; ++j) products[profile.at(i, j)] += own[i] * own[j];
    }
  }
  const auto factor = Cholesky::of(profile, products);
  if (!factor) return {};
  factor->solve(sums);
  return sums;
}

}  // namespace kusabi::verify
