// Guesses in double precision, checks without rounding.
#include "verify/block_proof.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

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

Dyadic norm_above(const DyadicList& list) {
  mpz_class sum;
  for (const auto& value : list.mantissas) {
    mpz_addmul(sum.get_mpz_t(), value.get_mpz_t(), value.get_mpz_t());
  }
  return sqrt_above(Dyadic(std::move(sum), 2 * list.exponent));
}

// The lower triangle of a matrix, row by row.
DyadicList lower_triangle(const DyadicMatrix& matrix) {
  DyadicList result;
  result.exponent = matrix.entries.exponent;
  for (std::size_t i = 0; i < matrix.size; ++i) {
    for (std::size_t j = 0; j <= i; ++j) {
      result.mantissas.push_back(matrix.entries.mantissas[matrix.size * i + j]);
    }
  }
  return result;
}

std::optional<Cholesky> factor_of(const std::vector<double>& matrix, std::size_t size,
                                  std::span<const std::size_t> unknowns) {
  std::vector<double> lower;
  for (std::size_t i = 0; i < unknowns.size(); ++i) {
    for (std::size_t j = 0; j <= i; ++j) lower.push_back(matrix[size * unknowns[i] + unknowns[j]]);
  }
  return Cholesky::of(Profile::full(unknowns.size()), lower);
}

std::vector<std::size_t> first_numbers(std::size_t count) {
  std::vector<std::size_t> numbers(count);
  std::iota(numbers.begin(), numbers.end(), std::size_t{0});
  return numbers;
}

}  // namespace

BlockProof::BlockProof(ContactBlock block) : block_(std::move(block)) {
  const auto& [middle, radius] = block_.stiffness;
  Dyadic steepest(1.0);
  for (const double mu : block_.friction) {
    friction_.emplace_back(mu);
    steepest = larger(steepest, Dyadic(1.0) + square(friction_.back()));
  }
  steepest_ = sqrt_above(steepest);
  for (std::size_t i = 0; i < middle.entries.size(); ++i) {
    rounded_.push_back(middle.entries[i].nearest());
  }
  size_of_stiffness_ = norm_above(middle.entries) + radius;
  factor_ = factor_of(rounded_, middle.size, first_numbers(middle.size));
  const auto least = verify::least_eigenvalue(Profile::full(middle.size), lower_triangle(middle));
  if (factor_ && least && *least > radius) least_ = *least - radius;
}

Dyadic BlockProof::tangential_square(const DyadicList& vector, std::size_t candidate) const {
  const auto d = block_.dimension;
  Dyadic sum;
  for (std::size_t k = 1; k < d; ++k) sum = sum + square(vector[d * candidate + k]);
  return sum;
}

// What K x may be off by, K being anywhere within its enclosure.
Dyadic BlockProof::spread(const DyadicList& x) const {
  if (block_.stiffness.radius.sign() == 0) return {};
  return block_.stiffness.radius * norm_above(x);
}

// Solves for the unknowns, the others being zero: K x = right in their rows. Solved again for what
// is left, x has more digits than a double, as many as a badly scaled K needs.
std::optional<std::string> BlockProof::guess(const Cholesky& factor,
                                             std::span<const std::size_t> unknowns,
                                             const DyadicList& right, const Check& check) const {
  constexpr int most_rounds = 10;
  const auto& middle = block_.stiffness.middle;
  DyadicList x(middle.size);
  DyadicList kx(middle.size);
  std::optional<std::string> refusal;
  std::vector<double> step(unknowns.size());
  std::vector<double> everywhere(middle.size, 0);
  for (int round = 0; round < most_rounds; ++round) {
    for (std::size_t k = 0; k < unknowns.size(); ++k) {
      step[k] = (right[unknowns[k]] - kx[unknowns[k]]).nearest();
    }
    factor.solve(step);
    if (!finite(step)) return "its numbers are too large to compute with";
    for (std::size_t k = 0; k < unknowns.size(); ++k) everywhere[unknowns[k]] = step[k];
    x += DyadicList(everywhere, guessed_bits);
    kx = middle * x;
    refusal = check(x, kx);
    if (!refusal) break;
  }
  return refusal;
}

std::optional<std::string> BlockProof::refusal_of_dead(std::uint64_t contact,
                                                       std::uint64_t separated,
                                                       std::span<const double> multipliers) const {
  if (separated == ~std::uint64_t{0} >> (64 - candidates())) return {};  // r = 0, nothing else
  const auto all = first_numbers(block_.stiffness.middle.size);
  std::vector<double> y(all.size(), 0);
  for (std::size_t i = 0; i < candidates(); ++i) y[block_.dimension * i] = multipliers[i];
  return guess(*factor_, all, DyadicList(y), [&](const auto& w, const auto& nu) {
    return check_dead(contact, separated, w, nu);
  });
}

std::optional<std::string> BlockProof::check_dead(std::uint64_t contact, std::uint64_t separated,
                                                  const DyadicList& w, const DyadicList& nu) const {
  const auto d = block_.dimension;
  std::optional<Dyadic> delta;
  Dyadic epsilon_squared;
  for (std::size_t i = 0; i < candidates(); ++i) {
    epsilon_squared = epsilon_squared + tangential_square(nu, i);
    const auto normal = nu[d * i];
    if (!holds(contact, i) && normal.sign() < 0) {
      epsilon_squared = epsilon_squared + square(normal);
    }
    if (holds(separated, i)) continue;
    const auto slip = sqrt_above(square(friction_[i]) * tangential_square(w, i));
    const auto margin = Dyadic{} - w[d * i] - slip;
    if (margin.sign() <= 0) {
      return "its multipliers do not rule out a reaction at " + block_.names[i];
    }
    if (!delta || margin < *delta) delta = margin;
  }
  const auto epsilon = sqrt_above(epsilon_squared) + spread(w);
  if (*delta * *least_ > epsilon * steepest_) return {};
  return "its multipliers rule out too little, or ask for what u_n >= 0 does not give";
}

std::optional<std::string> BlockProof::refusal_of_alive(std::uint64_t contact,
                                                        std::uint64_t separated,
                                                        std::span<const double> tangential) const {
  if (contact == 0) return "no candidate is in contact";
  const auto d = block_.dimension;
  const auto size = block_.stiffness.middle.size;
  std::vector<double> right(size, 0);
  std::vector<std::size_t> loose;  // all displacements but the normal ones of U
  auto number = tangential.begin();
  for (std::size_t i = 0; i < candidates(); ++i) {
    const bool touches = holds(contact, i);
    for (std::size_t k = touches ? 1 : 0; k < d; ++k) {
      loose.push_back(d * i + k);
      if (!touches) continue;
      if (block_.friction[i] == 0 && *number != 0) {
        return block_.names[i] + " has no friction, but a tangential reaction";
      }
      right[d * i + k] = *number++;
    }
  }
  const auto factor = factor_of(rounded_, size, loose);
  if (!factor) return "K is too badly conditioned to compute its displacements";
  const DyadicList reaction(right);
  return guess(*factor, loose, reaction, [&](const auto& u, const auto& r) {
    return check_alive(contact, separated, reaction, u, r);
  });
}

std::optional<std::string> BlockProof::check_alive(std::uint64_t contact, std::uint64_t separated,
                                                   const DyadicList& right, const DyadicList& u,
                                                   const DyadicList& r) const {
  const auto d = block_.dimension;
  const auto& s = *least_;
  Dyadic rest_squared;
  for (std::size_t i = 0; i < candidates(); ++i) {
    for (std::size_t k = holds(contact, i) ? 1 : 0; k < d; ++k) {
      rest_squared = rest_squared + square(r[d * i + k] - right[d * i + k]);
    }
  }
  const auto unknown = spread(u);
  const auto rest = sqrt_above(rest_squared) + unknown;        // s times the error of u
  const auto error = size_of_stiffness_ * rest + s * unknown;  // s times that of r_n
  for (std::size_t i = 0; i < candidates(); ++i) {
    const auto& name = block_.names[i];
    if (holds(separated, i)) {
      if (!(s * u[d * i] > rest)) return name + " does not separate";
      continue;
    }
    const auto pressure = s * r[d * i] - error;
    if (pressure.sign() <= 0) return name + " is not pressed against the obstacle";
    if (friction_[i].sign() == 0) continue;  // r_t = 0, as it must be
    const auto shear = s * sqrt_above(tangential_square(right, i));
    if (!(friction_[i] * pressure > shear)) return name + " slips, or is about to";
  }
  return {};
}

}  // namespace kusabi::verify
