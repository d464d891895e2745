// Row-oriented Cholesky factorisation within a profile; the error of the factor is computed
// exactly.
#include "verify/arithmetic/cholesky.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "verify/arithmetic/wide.hpp"
#include "verify/arithmetic/word_grid.hpp"

namespace kusabi::verify {
namespace {

std::size_t longest_row(const Profile& profile) {
  std::size_t longest = 0;
  for (std::size_t i = 0; i < profile.size(); ++i)
    longest = std::max(longest, i + 1 - profile.first(i));
  return longest;
}

// The square of the Frobenius norm of A - shift I - L L'. All entries outside the profile are zero.
Dyadic square_of_error(const Profile& profile, const DyadicList& matrix, double shift,
                       const WordGrid& lower) {
  Dyadic sum;
  for (std::size_t i = 0; i < profile.size(); ++i) {
    for (std::size_t j = profile.first(i); j <= i; ++j) {
      const auto start = std::max(profile.first(i), profile.first(j));
      const auto* const row = lower.words.data() + profile.at(i, start);
      const auto* const other = lower.words.data() + profile.at(j, start);
      Wide product = 0;
      for (std::size_t k = 0; k <= j - start; ++k) product += static_cast<Wide>(row[k]) * other[k];
      auto error = matrix[profile.at(i, j)] - Dyadic(integer(product), 2 * lower.exponent);
      if (i == j) error = error - Dyadic(shift);
      auto share = square(error);
      sum = sum + (i == j ? share : share.scaled(1));
    }
  }
  return sum;
}

// Dot product in four partial sums, which are vectorised.
double dot(const double* a, const double* b, std::size_t size) {
  std::array<double, 4> sums{};
  std::size_t k = 0;
  for (; k + 4 <= size; k += 4) {
    for (std::size_t part = 0; part < 4; ++part) sums[part] += a[k + part] * b[k + part];
  }
  for (; k < size; ++k) sums[0] += a[k] * b[k];
  return (sums[0] + sums[1]) + (sums[2] + sums[3]);
}

// Upper estimate of the least eigenvalue by inverse iteration, close to it but not proved.
double estimated_eigenvalue(const Cholesky& factor, std::size_t size) {
  constexpr int steps = 12;
  std::vector<double> motion(size);
  for (std::size_t i = 0; i < size; ++i)
    motion[i] = 1 + 0.4 * std::sin(static_cast<double>(i) * static_cast<double>(i));
  double norm = std::sqrt(dot(motion.data(), motion.data(), size));
  double estimate = 0;
  for (int step = 0; step < steps; ++step) {
    for (double& value : motion) value /= norm;
    factor.solve(motion);
    norm = std::sqrt(dot(motion.data(), motion.data(), size));
    estimate = 1 / norm;
  }
  return estimate;
}

}  // namespace

std::optional<Cholesky> Cholesky::of(const Profile& profile, std::span<const double> matrix,
                                     double shift) {
  Cholesky factor;
  factor.profile_ = profile;
  factor.lower_.resize(profile.entries());
  auto& lower = factor.lower_;
  for (std::size_t i = 0; i < profile.size(); ++i) {
    for (std::size_t j = profile.first(i); j <= i; ++j) {
      const auto start = std::max(profile.first(i), profile.first(j));
      const double* const row = lower.data() + profile.at(i, start);
      const double* const other = lower.data() + profile.at(j, start);
      const double rest =
          matrix[profile.at(i, j)] - (i == j ? shift : 0) - dot(row, other, j - start);
      if (i != j) {
        lower[profile.at(i, j)] = rest / lower[profile.at(j, j)];
      } else {
        if (!(rest > 0) || !std::isfinite(rest)) return {};
        lower[profile.at(i, i)] = std::sqrt(rest);
      }
    }
  }
  return factor;
}

// Leading zeros stay zero in the first of the two triangular systems.
void Cholesky::solve(std::span<double> right) const {
  const auto nonzero = std::ranges::find_if(right, [](double each) { return each != 0; });
  for (auto i = static_cast<std::size_t>(nonzero - right.begin()); i < profile_.size(); ++i) {
    for (std::size_t k = profile_.first(i); k < i; ++k) {
      right[i] -= lower_[profile_.at(i, k)] * right[k];
    }
    right[i] /= lower_[profile_.at(i, i)];
  }
  for (std::size_t i = profile_.size(); i-- > 0;) {
    right[i] /= lower_[profile_.at(i, i)];
    for (std::size_t k = profile_.first(i); k < i; ++k) {
      right[k] -= lower_[profile_.at(i, k)] * right[i];
    }
  }
}

// Candidates for the bound are half the estimate, a quarter of it, and so on.
std::optional<Dyadic> min_eigenvalue(const Profile& profile, const DyadicList& matrix) {
  std::vector<double> rounded;
  rounded.reserve(profile.entries());
  for (std::size_t at = 0; at < profile.entries(); ++at) rounded.push_back(matrix[at].nearest());
  if (!all_finite(rounded) || rounded.empty()) return {};
  const auto first = Cholesky::of(profile, rounded);
  if (!first) return {};
  double shift = estimated_eigenvalue(*first, profile.size()) / 2;
  const auto terms = longest_row(profile);
  constexpr int beyond_double_precision = 60;
  for (int step = 0; step < beyond_double_precision && shift > 0; ++step, shift /= 2) {
    const auto factor = Cholesky::of(profile, rounded, shift);
    if (!factor || !all_finite(factor->lower())) continue;
    const auto lower = words_of(factor->lower(), terms);
    const auto error = sqrt_above(square_of_error(profile, matrix, shift, lower));
    const auto bound = Dyadic(shift) - error;
    if (bound + bound > Dyadic(shift)) return bound;
  }
  return {};
}

}  // namespace kusabi::verify
