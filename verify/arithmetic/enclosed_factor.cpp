// Row-oriented L D L' factorisation.
#include "verify/arithmetic/enclosed_factor.hpp"

#include <utility>

namespace kusabi::verify {

std::optional<EnclosedFactor> EnclosedFactor::of(std::size_t size, const DyadicList& lower) {
  EnclosedFactor factor;
  for (std::size_t i = 0; i < size; ++i) {
    std::vector<Enclosure> row;  // of L D
    for (std::size_t j = 0; j <= i; ++j) {
      Enclosure rest(lower[i * (i + 1) / 2 + j]);
      for (std::size_t k = 0; k < j; ++k) rest.add_product(row[k], factor.opposite(j, k));
      if (j < i) {
        row.push_back(rest);
        factor.opposite_.push_back(-(rest / factor.pivots_[j]));
      } else {
        if (!rest.finite() || rest.lower().sign() <= 0) return {};
        factor.pivots_.push_back(std::move(rest));
      }
    }
  }
  return factor;
}

std::vector<Enclosure> EnclosedFactor::solve(std::vector<Enclosure> right) const {
  for (std::size_t i = 0; i < right.size(); ++i) {
    for (std::size_t k = 0; k < i; ++k) right[i].add_product(opposite(i, k), right[k]);
  }
  for (std::size_t i = 0; i < right.size(); ++i) right[i] = right[i] / pivots_[i];
  for (std::size_t i = right.size(); i-- > 0;) {
    for (std::size_t k = 0; k < i; ++k) right[k].add_product(opposite(i, k), right[i]);
  }
  return right;
}

// trace(A^-1) is the sum of the squares of the entries of D^-1/2 L^-1.
Dyadic EnclosedFactor::min_eigenvalue() const {
  const auto size = pivots_.size();
  Enclosure trace;
  for (std::size_t column = 0; column < size; ++column) {
    std::vector<Enclosure> inverse(size);  // the column of L^-1
    inverse[column] = Enclosure(1.0);
    for (std::size_t i = column; i < size; ++i) {
      for (std::size_t k = column; k < i; ++k) inverse[i].add_product(opposite(i, k), inverse[k]);
      trace += inverse[i] * inverse[i] / pivots_[i];
    }
  }
  return (Enclosure(1.0) / trace).lower();
}

}  // namespace kusabi::verify
