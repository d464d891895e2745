// Row by row, as the books have it.
#include "verify/cholesky.hpp"

#include <algorithm>
#include <cmath>

namespace kusabi::verify {
namespace {

// Digits of a guess so far below its largest number are of no use.
constexpr int guessed_bits = 64;

// The square of the Frobenius norm of A - shift I - L L'. Outside of the profile all of it is zero.
Dyadic square_of_error(const Profile& profile, const DyadicList& matrix, double shift,
                       const DyadicList& lower) {
  Dyadic sum;
  mpz_class product;
  for (std::size_t i = 0; i < profile.size(); ++i) {
    for (std::size_t j = profile.first(i); j <= i; ++j) {
      product = 0;
      for (std::size_t k = std::max(profile.first(i), profile.first(j)); k <= j; ++k) {
        mpz_addmul(product.get_mpz_t(), lower.mantissas[profile.at(i, k)].get_mpz_t(),
                   lower.mantissas[profile.at(j, k)].get_mpz_t());
      }
      auto error = matrix[profile.at(i, j)] - Dyadic(product, 2 * lower.exponent);
      if (i == j) error = error - Dyadic(shift);
      sum = sum + square(error);
      if (i != j) sum = sum + square(error);
    }
  }
  return sum;
}

bool finite(std::span<const double> values) {
  return std::all_of(values.begin(), values.end(), [](double x) { return std::isfinite(x); });
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
      double rest = matrix[profile.at(i, j)] - (i == j ? shift : 0);
      for (std::size_t k = 0; k < j - start; ++k) rest -= row[k] * other[k];
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

void Cholesky::solve(std::span<double> right) const {
  for (std::size_t i = 0; i < profile_.size(); ++i) {
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

// The least eigenvalue is not above the least entry of the diagonal; from there down by halves.
std::optional<Dyadic> least_eigenvalue(const Profile& profile, const DyadicList& matrix) {
  std::vector<double> guess;
  guess.reserve(profile.entries());
  for (std::size_t at = 0; at < profile.entries(); ++at) guess.push_back(matrix[at].nearest());
  if (!finite(guess) || guess.empty()) return {};
  double shift = guess[0];
  for (std::size_t i = 0; i < profile.size(); ++i) {
    shift = std::min(shift, guess[profile.at(i, i)]);
  }
  constexpr int beyond_double_precision = 60;
  for (int step = 0; step < beyond_double_precision && shift > 0; ++step, shift /= 2) {
    const auto factor = Cholesky::of(profile, guess, shift);
    if (!factor || !finite(factor->lower())) continue;
    const DyadicList lower(factor->lower(), guessed_bits);
    const auto error = sqrt_above(square_of_error(profile, matrix, shift, lower));
    const auto bound = Dyadic(shift) - error;
    if (bound + bound > Dyadic(shift)) return bound;
  }
  return {};
}

}  // namespace kusabi::verify
