// Row by row, as the books have it.
#include "verify/cholesky.hpp"

#include <cmath>

namespace kusabi::verify {

std::optional<Cholesky> Cholesky::of(std::span<const double> matrix, std::size_t size,
                                     double shift) {
  Cholesky factor;
  factor.size_ = size;
  factor.lower_.resize(size * size);
  auto& lower = factor.lower_;
  for (std::size_t i = 0; i < size; ++i) {
    for (std::size_t j = 0; j <= i; ++j) {
      double rest = matrix[size * i + j] - (i == j ? shift : 0);
      for (std::size_t k = 0; k < j; ++k) rest -= lower[size * i + k] * lower[size * j + k];
      if (i != j) {
        lower[size * i + j] = rest / lower[size * j + j];
      } else {
        if (!(rest > 0) || !std::isfinite(rest)) return {};
        lower[size * i + i] = std::sqrt(rest);
      }
    }
  }
  return factor;
}

void Cholesky::solve(std::span<double> right) const {
  for (std::size_t i = 0; i < size_; ++i) {
    for (std::size_t k = 0; k < i; ++k) right[i] -= lower_[size_ * i + k] * right[k];
    right[i] /= lower_[size_ * i + i];
  }
  for (std::size_t i = size_; i-- > 0;) {
    for (std::size_t k = i + 1; k < size_; ++k) right[i] -= lower_[size_ * k + i] * right[k];
    right[i] /= lower_[size_ * i + i];
  }
}

}  // namespace kusabi::verify
