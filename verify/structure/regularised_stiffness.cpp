// Grounding springs on the diagonal, and iterative refinement with Cholesky factors in double
// precision.
#include "verify/structure/regularised_stiffness.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "verify/arithmetic/word_grid.hpp"

namespace kusabi::verify {
namespace {

// Corrections of the refinement are truncated this many bits below their largest number, which
// loses no accuracy and saves multiplications. The first approximation is truncated as
// TruncatedMatrix requires.
constexpr int refined_bits = 64;
constexpr int first_bits = 9;

// Maximum size of a K that is factorised in intervals, which takes a tenth of a second for it.
constexpr std::size_t max_enclosed = 100;

// The lower triangle of some rows and columns of a matrix, by rows.
DyadicList lower_triangle(const DyadicMatrix& matrix, std::span<const std::size_t> numbers) {
  DyadicList result;
  result.exponent = matrix.entries.exponent;
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    for (std::size_t j = 0; j <= i; ++j)
      result.mantissas.push_back(matrix.entries.mantissas[matrix.size * numbers[i] + numbers[j]]);
  }
  return result;
}

// Adds powers of two to the diagonal, about as large as its largest entry and never zero.
EnclosedMatrix with_springs(EnclosedMatrix stiffness, const std::vector<std::size_t>& springs) {
  if (springs.empty()) return stiffness;
  auto& matrix = stiffness.middle;
  Dyadic largest;
  for (std::size_t i = 0; i < matrix.size; ++i)
    largest = larger(largest, matrix.entries[matrix.size * i + i]);
  const long power = largest.sign() > 0 ? largest.magnitude() : 0;
  DyadicList added(matrix.entries.size());
  added.exponent = power;
  for (const auto k : springs) added.mantissas[matrix.size * k + k] = 1;
  matrix.entries += std::move(added);
  return stiffness;
}

}  // namespace

Dyadic norm_above(const DyadicList& list) {
  mpz_class sum;
  for (const auto& value : list.mantissas) {
    mpz_addmul(sum.get_mpz_t(), value.get_mpz_t(), value.get_mpz_t());
  }
  return sqrt_above(Dyadic(std::move(sum), 2 * list.exponent));
}

std::vector<std::size_t> first_numbers(std::size_t count) {
  std::vector<std::size_t> numbers(count);
  std::iota(numbers.begin(), numbers.end(), std::size_t{0});
  return numbers;
}

RegularisedStiffness::RegularisedStiffness(EnclosedMatrix stiffness,
                                           std::vector<std::size_t> springs)
    : stiffness_(with_springs(std::move(stiffness), springs)),
      coarse_(stiffness_.middle),
      springs_(std::move(springs)) {
  const auto& [middle, radius] = stiffness_;
  std::sort(springs_.begin(), springs_.end());
  for (std::size_t i = 0; i < middle.entries.size(); ++i) {
    rounded_.push_back(middle.entries[i].nearest());
  }
  size_ = norm_above(middle.entries) + radius;
  const auto all = first_numbers(middle.size);
  const auto lower = lower_triangle(middle, all);
  whole_ = factor(all);
  auto minimum = verify::min_eigenvalue(Profile::full(middle.size), lower);
  if (!(whole_ && minimum) && middle.size <= max_enclosed) {
    enclosed_ = EnclosedFactor::of(middle.size, lower);
    if (enclosed_) minimum = enclosed_->min_eigenvalue();
  }
  if ((whole_ || enclosed_) && minimum && *minimum > radius) minimum_ = *minimum - radius;
}

Dyadic RegularisedStiffness::spread(const Dyadic& radius, const DyadicList& x) {
  return radius.sign() == 0 ? Dyadic() : radius * norm_above(x);
}

std::optional<Cholesky> RegularisedStiffness::factor(std::span<const std::size_t> unknowns) const {
  const auto size = stiffness_.middle.size;
  std::vector<double> lower;
  for (std::size_t i = 0; i < unknowns.size(); ++i) {
    for (std::size_t j = 0; j <= i; ++j)
      lower.push_back(rounded_[size * unknowns[i] + unknowns[j]]);
  }
  return Cholesky::of(Profile::full(unknowns.size()), lower);
}

std::optional<std::string> RegularisedStiffness::solve(std::span<const std::size_t> unknowns,
                                                       const DyadicList& right,
                                                       const Check& check) const {
  if (enclosed_) return solve_enclosed(unknowns, right, check);
  constexpr int max_rounds = 10;
  constexpr double no_digit_more = 0x1p-140;  // further rounds change no digit that is kept
  const auto& middle = stiffness_.middle;
  const bool all = unknowns.size() == middle.size;
  const auto own = all ? std::optional<Cholesky>{} : factor(unknowns);
  const auto& solver = all ? whole_ : own;
  if (!solver) return "K is too ill-conditioned to compute its displacements";
  DyadicList x;
  DyadicList kx(middle.size);
  std::optional<std::string> refusal;
  std::vector<double> step(unknowns.size());
  std::vector<double> everywhere(middle.size, 0);
  double first_size = 0;
  for (int round = 0; round < max_rounds; ++round) {
    for (std::size_t k = 0; k < unknowns.size(); ++k) {
      step[k] = (right[unknowns[k]] - kx[unknowns[k]]).nearest();
    }
    solver->solve(step);
    if (!all_finite(step)) return "its numbers are too large to compute with";
    double size = 0;
    for (const double each : step) size = std::max(size, std::abs(each));
    if (round == 0) first_size = size;
    if (round > 0 && size <= no_digit_more * first_size) break;
    for (std::size_t k = 0; k < unknowns.size(); ++k) everywhere[unknowns[k]] = step[k];
    if (round > 0) {
      x += DyadicList(everywhere, refined_bits);
    } else {
      x = DyadicList(everywhere, first_bits);
      const auto coarse = coarse_ * x;
      if (coarse && !check(x, *coarse, spread(stiffness_.radius + coarse_.cut_off(), x))) return {};
    }
    kx = middle * x;
    refusal = check(x, kx, spread(stiffness_.radius, x));
    if (!refusal) break;
  }
  return refusal;
}

std::optional<std::string> RegularisedStiffness::solve_enclosed(
    std::span<const std::size_t> unknowns, const DyadicList& right, const Check& check) const {
  const auto& middle = stiffness_.middle;
  const bool all = unknowns.size() == middle.size;
  const auto own = all ? std::optional<EnclosedFactor>{}
                       : EnclosedFactor::of(unknowns.size(), lower_triangle(middle, unknowns));
  const auto& solver = all ? enclosed_ : own;
  if (!solver) return "K is too ill-conditioned to compute its displacements";
  std::vector<Enclosure> loads;
  for (const auto row : unknowns) loads.emplace_back(right[row]);
  const auto enclosures = solver->solve(std::move(loads));
  std::vector<Dyadic> numbers(middle.size);
  for (std::size_t k = 0; k < unknowns.size(); ++k) {
    if (!enclosures[k].finite()) return "its numbers are too large to compute with";
    numbers[unknowns[k]] = enclosures[k].lower();
  }
  const DyadicList x(numbers);
  return check(x, middle * x, spread(stiffness_.radius, x));
}

// With R = N - K X, the error is K^-1 N - X = K^-1 R.
std::optional<InverseColumns> RegularisedStiffness::inverse_columns(
    std::span<const std::size_t> columns) const {
  const auto size = stiffness_.middle.size;
  if (!whole_) return {};
  std::vector<double> values;
  values.reserve(size * columns.size());
  for (const auto column : columns) {
    std::vector<double> unit(size, 0);
    unit[column] = 1;
    whole_->solve(unit);
    if (!all_finite(unit)) return {};
    values.insert(values.end(), unit.begin(), unit.end());
  }
  auto grid = words_of(values, size);
  InverseColumns result{.words = std::move(grid.words), .exponent = grid.exponent, .error = {}};
  Dyadic square_of_residual;
  for (std::size_t k = 0; k < columns.size(); ++k) {
    DyadicList x;
    x.exponent = result.exponent;
    for (std::size_t i = 0; i < size; ++i)
      x.mantissas.emplace_back(static_cast<long>(result.words[size * k + i]));
    const auto coarse = coarse_ * x;
    auto residual = coarse ? *coarse : stiffness_.middle * x;
    const auto radius = coarse ? stiffness_.radius + coarse_.cut_off() : stiffness_.radius;
    std::vector<double> unit(size, 0);
    unit[columns[k]] = -1;
    residual += DyadicList(unit);
    square_of_residual = square_of_residual + square(norm_above(residual) + spread(radius, x));
  }
  result.error = quotient_above(sqrt_above(square_of_residual), *minimum_);
  return result;
}

}  // namespace kusabi::verify
