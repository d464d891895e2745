// Guesses in double precision, checks without rounding.
#include "verify/proof.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numeric>
#include <span>

namespace kusabi::verify {
namespace {

// A step of a guess loses nothing by being cut off so far below its largest number, and what is not
// there need not be multiplied.
constexpr int guessed_bits = 64;

bool finite(std::span<const double> values) {
  return std::all_of(values.begin(), values.end(), [](double x) { return std::isfinite(x); });
}

bool holds(std::uint64_t set, std::size_t candidate) {
  return ((set >> candidate) & 1U) != 0;
}

Dyadic square(const Dyadic& x) {
  return x * x;
}

const Dyadic& larger(const Dyadic& a, const Dyadic& b) {
  return a < b ? b : a;
}

// The square of the Frobenius norm of K - shift I - L L', L being lower triangular.
Dyadic square_of_error(const DyadicMatrix& stiffness, double shift, const DyadicList& lower) {
  const auto size = stiffness.size;
  Dyadic sum;
  mpz_class product;
  for (std::size_t i = 0; i < size; ++i) {
    for (std::size_t j = 0; j <= i; ++j) {
      product = 0;
      for (std::size_t k = 0; k <= j; ++k) {
        mpz_addmul(product.get_mpz_t(), lower.mantissas[size * i + k].get_mpz_t(),
                   lower.mantissas[size * j + k].get_mpz_t());
      }
      auto error = stiffness.entries[size * i + j] - Dyadic(product, 2 * lower.exponent);
      if (i == j) error = error - Dyadic(shift);
      sum = sum + square(error);
      if (i != j) sum = sum + square(error);
    }
  }
  return sum;
}

}  // namespace

Proof::Proof(const Certificate& certificate)
    : certificate_(certificate),
      stiffness_{certificate.displacements(), DyadicList(certificate.stiffness)},
      steepest_(1.0),
      factor_(Cholesky::of(certificate.stiffness, certificate.displacements())) {
  for (const double mu : certificate.friction) {
    friction_.emplace_back(mu);
    steepest_ = larger(steepest_, Dyadic(1.0) + square(friction_.back()));
  }
  Dyadic sum;
  for (std::size_t i = 0; i < stiffness_.entries.size(); ++i) {
    sum = sum + square(stiffness_.entries[i]);
  }
  size_of_stiffness_ = sqrt_above(sum);
  if (factor_) least_ = bound_of_eigenvalues();
}

// The least eigenvalue is not above the least entry of the diagonal; from there down by halves.
std::optional<Dyadic> Proof::bound_of_eigenvalues() const {
  const auto size = stiffness_.size;
  const auto& matrix = certificate_.stiffness;
  double shift = matrix[0];
  for (std::size_t i = 0; i < size; ++i) shift = std::min(shift, matrix[size * i + i]);
  constexpr int beyond_double_precision = 60;
  for (int step = 0; step < beyond_double_precision; ++step, shift /= 2) {
    const auto factor = Cholesky::of(matrix, size, shift);
    if (!factor || !finite(factor->lower())) continue;
    const DyadicList lower(factor->lower(), guessed_bits);
    const auto bound = Dyadic(shift) - sqrt_above(square_of_error(stiffness_, shift, lower));
    if (bound + bound > Dyadic(shift)) return bound;
  }
  return {};
}

std::optional<std::string> Proof::refusal(const Record& record) const {
  switch (record.claim) {
    case Claim::dead:
      return refusal_of_dead(record);
    case Claim::alive:
      return refusal_of_alive(record);
    default:
      return {};
  }
}

Dyadic Proof::tangential_square(const DyadicList& vector, std::size_t candidate) const {
  const auto d = certificate_.dimension;
  Dyadic sum;
  for (std::size_t k = 1; k < d; ++k) sum = sum + square(vector[d * candidate + k]);
  return sum;
}

// Solves for the unknowns, the others being zero: K x = right in their rows. Solved again for what
// is left, x has more digits than a double, as many as a badly scaled K needs.
std::optional<std::string> Proof::guess(const Cholesky& factor,
                                        std::span<const std::size_t> unknowns,
                                        const DyadicList& right, const Check& check) const {
  constexpr int most_rounds = 5;
  DyadicList x(stiffness_.size);
  DyadicList kx(stiffness_.size);
  std::optional<std::string> refusal;
  std::vector<double> step(unknowns.size());
  std::vector<double> everywhere(stiffness_.size, 0);
  for (int round = 0; round < most_rounds; ++round) {
    for (std::size_t k = 0; k < unknowns.size(); ++k) {
      step[k] = (right[unknowns[k]] - kx[unknowns[k]]).nearest();
    }
    factor.solve(step);
    if (!finite(step)) return "its numbers are too large to compute with";
    for (std::size_t k = 0; k < unknowns.size(); ++k) everywhere[unknowns[k]] = step[k];
    x += DyadicList(everywhere, guessed_bits);
    kx = stiffness_ * x;
    refusal = check(x, kx);
    if (!refusal) break;
  }
  return refusal;
}

std::optional<std::string> Proof::refusal_of_dead(const Record& record) const {
  if (record.separated == certificate_.all_candidates()) return {};  // r = 0, nothing else
  std::vector<std::size_t> all(stiffness_.size);
  std::iota(all.begin(), all.end(), std::size_t{0});
  std::vector<double> lambda(stiffness_.size, 0);
  for (std::size_t i = 0; i < certificate_.candidates(); ++i) {
    lambda[certificate_.dimension * i] = record.numbers[i];
  }
  return guess(*factor_, all, DyadicList(lambda),
               [&](const auto& w, const auto& nu) { return check_dead(record, w, nu); });
}

std::optional<std::string> Proof::check_dead(const Record& record, const DyadicList& w,
                                             const DyadicList& nu) const {
  const auto d = certificate_.dimension;
  std::optional<Dyadic> delta;
  Dyadic epsilon_squared;
  for (std::size_t i = 0; i < certificate_.candidates(); ++i) {
    epsilon_squared = epsilon_squared + tangential_square(nu, i);
    const auto normal = nu[d * i];
    if (!holds(record.contact, i) && normal.sign() < 0) {
      epsilon_squared = epsilon_squared + square(normal);
    }
    if (holds(record.separated, i)) continue;
    const auto slip = sqrt_above(square(friction_[i]) * tangential_square(w, i));
    const auto margin = Dyadic{} - w[d * i] - slip;
    if (margin.sign() <= 0) {
      return "its multipliers do not rule out a reaction at " + certificate_.names[i];
    }
    if (!delta || margin < *delta) delta = margin;
  }
  if (square(*delta * *least_) > epsilon_squared * steepest_) return {};
  return "its multipliers rule out too little, or ask for what u_n >= 0 does not give";
}

std::optional<std::string> Proof::refusal_of_alive(const Record& record) const {
  if (record.contact == 0) return "no candidate is in contact";
  const auto d = certificate_.dimension;
  const auto size = stiffness_.size;
  std::vector<double> right(size, 0);
  std::vector<std::size_t> loose;  // all displacements but the normal ones of U
  auto number = record.numbers.begin();
  for (std::size_t i = 0; i < certificate_.candidates(); ++i) {
    const bool touches = holds(record.contact, i);
    for (std::size_t k = touches ? 1 : 0; k < d; ++k) {
      loose.push_back(d * i + k);
      if (touches) right[d * i + k] = *number++;
    }
  }
  std::vector<double> block;
  for (const auto row : loose) {
    for (const auto column : loose) block.push_back(certificate_.stiffness[size * row + column]);
  }
  const auto factor = Cholesky::of(block, loose.size());
  if (!factor) return "K is too badly conditioned to compute its displacements";
  const DyadicList reaction(right);
  return guess(*factor, loose, reaction,
               [&](const auto& u, const auto& r) { return check_alive(record, reaction, u, r); });
}

std::optional<std::string> Proof::check_alive(const Record& record, const DyadicList& right,
                                              const DyadicList& u, const DyadicList& r) const {
  const auto d = certificate_.dimension;
  const auto m = certificate_.candidates();
  const auto& s = *least_;
  Dyadic rest_squared;
  for (std::size_t i = 0; i < m; ++i) {
    for (std::size_t k = holds(record.contact, i) ? 1 : 0; k < d; ++k) {
      rest_squared = rest_squared + square(r[d * i + k] - right[d * i + k]);
    }
  }
  const auto rest = sqrt_above(rest_squared);    // s times the error of u
  const auto error = size_of_stiffness_ * rest;  // s times that of r_n
  for (std::size_t i = 0; i < m; ++i) {
    const auto& name = certificate_.names[i];
    if (holds(record.separated, i)) {
      if (!(s * u[d * i] > rest)) return name + " does not separate";
      continue;
    }
    const auto pressure = s * r[d * i] - error;
    if (pressure.sign() <= 0) return name + " is not pressed against the obstacle";
    const auto shear = s * sqrt_above(tangential_square(right, i));
    if (!(friction_[i] * pressure > shear)) return name + " slips, or is about to";
  }
  return {};
}

}  // namespace kusabi::verify
