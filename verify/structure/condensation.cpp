// Static condensation in integers: multiples of 2^-300 for the stiffness, of 2^-160 for the
// dependent displacements.
#include "verify/structure/condensation.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "verify/arithmetic/cholesky.hpp"
#include "verify/structure/enclosed_problem.hpp"
#include "verify/structure/scaled_partition.hpp"

namespace kusabi::verify {
namespace {

constexpr long displacement_grid = -160;
constexpr long kept_bits = 160;  // of K
class Condensation {
 public:
  Condensation(const Structure& structure, std::span<const ForceList> loads, double springs,
               const support::LongWork& work)
      : structure_(structure),
        loads_(loads),
        work_(work),
        rows_(candidate_rows(structure, loads, springs)) {}

  std::variant<LoadedStiffness, std::string> result();

 private:
  std::optional<std::string> partition();
  std::optional<std::string> factorise();
  void solve_dependent();
  void refine(std::size_t column);
  void complement();
  EnclosedMatrix in_contact_frames();
  LoadedStiffness separated(EnclosedMatrix whole) const;

  [[nodiscard]] Dyadic entry(std::size_t i, std::size_t j) const {
    return {complement_[parts_.contact * i + j], stiffness_grid};
  }

  const Structure& structure_;
  std::span<const ForceList> loads_;
  const support::LongWork& work_;
  CandidateRows rows_;
  PartitionedStiffness parts_;
  Profile profile_;
  std::optional<Cholesky> factor_;                 // of K_NN
  Dyadic minimum_;                                 // lower bound of its eigenvalues
  std::vector<std::vector<mpz_class>> dependent_;  // X, by columns, on the displacement grid
  std::vector<std::vector<mpz_class>> residual_;  // R = K_NC - K_NN X, on the product of both grids
  std::vector<mpz_class> complement_;             // S, c x c, on the stiffness grid
  Dyadic radius_;
};

std::optional<std::string> Condensation::partition() {
  auto found = scaled_partition(rows_);
  if (auto* const why = std::get_if<std::string>(&found)) return std::move(*why);
  parts_ = std::get<PartitionedStiffness>(std::move(found));
  rows_.stiffness = {};  // as large as its parts
  return {};
}

std::optional<std::string> Condensation::factorise() {
  if (parts_.rest == 0) return {};
  constexpr std::size_t largest_profile = 50'000'000;
  std::vector<std::size_t> first(parts_.rest);
  for (std::size_t row = 0; row < parts_.rest; ++row) {
    first[row] = row;
    for (const auto& entry : parts_.rest_rest[row]) first[row] = std::min(first[row], entry.column);
  }
  profile_ = Profile(std::move(first));
  if (profile_.entries() > largest_profile) return "the structure is too large for a proof";
  DyadicList entries(profile_.entries());
  entries.exponent = stiffness_grid;
  std::vector<double> rounded(profile_.entries(), 0.0);
  for (std::size_t row = 0; row < parts_.rest; ++row) {
    for (const auto& entry : parts_.rest_rest[row]) {
      if (entry.column > row) continue;
      entries.mantissas[profile_.at(row, entry.column)] = entry.value;
      rounded[profile_.at(row, entry.column)] = Dyadic(entry.value, stiffness_grid).nearest();
    }
  }
  support::throw_if_requested(work_.stop);
  const auto minimum = min_eigenvalue(profile_, entries);
  support::throw_if_requested(work_.stop);
  factor_ = Cholesky::of(profile_, rounded);
  if (!minimum || !factor_) return too_ill_conditioned;
  minimum_ = *minimum;
  return {};
}

// X, a column for each displacement of C, by iterative refinement with double-precision solutions
// until the square of the residual is negligible.
void Condensation::solve_dependent() {
  dependent_.assign(parts_.contact, std::vector<mpz_class>(parts_.rest));
  residual_.assign(parts_.contact, std::vector<mpz_class>(parts_.rest));
  for (std::size_t row = 0; row < parts_.rest; ++row) {
    for (const auto& entry : parts_.rest_contact[row]) {
      mpz_mul_2exp(residual_[entry.column][row].get_mpz_t(), entry.value.get_mpz_t(),
                   static_cast<mp_bitcnt_t>(-displacement_grid));
    }
  }
  for (std::size_t column = 0; column < parts_.contact; ++column) {
    work_.report_share("enclosing K for the proof, columns",
                       static_cast<double>(column) / static_cast<double>(parts_.contact));
    refine(column);
  }
}

void Condensation::refine(std::size_t column) {
  constexpr int max_rounds = 60;
  constexpr long small = -125;
  const long grid = stiffness_grid + displacement_grid;
  std::vector<double> step(parts_.rest);
  std::vector<mpz_class> added(parts_.rest);
  long before = 0;
  for (int round = 0; round < max_rounds; ++round) {
    long largest = small;
    for (const auto& value : residual_[column]) {
      if (sgn(value) != 0) largest = std::max(largest, Dyadic(value, grid).magnitude());
    }
    if (largest == small || (round > 0 && largest >= before)) return;
    before = largest;
    for (std::size_t row = 0; row < parts_.rest; ++row) {
      step[row] = Dyadic(residual_[column][row], grid).nearest();
    }
    factor_->solve(step);
    for (std::size_t row = 0; row < parts_.rest; ++row) {
      if (!std::isfinite(step[row])) return;
      added[row] = Dyadic(step[row]).multiples(displacement_grid);
      dependent_[column][row] += added[row];
    }
    for (std::size_t row = 0; row < parts_.rest; ++row) {
      for (const auto& entry : parts_.rest_rest[row]) {
        mpz_submul(residual_[column][row].get_mpz_t(), entry.value.get_mpz_t(),
                   added[entry.column].get_mpz_t());
      }
    }
  }
}

Dyadic square_sum(const std::vector<std::vector<mpz_class>>& columns, long grid) {
  mpz_class sum;
  for (const auto& column : columns) {
    for (const auto& value : column)
      mpz_addmul(sum.get_mpz_t(), value.get_mpz_t(), value.get_mpz_t());
  }
  return {std::move(sum), 2 * grid};
}

// S = K_CC - K_CN X - X'R and a bound of its distance from the condensed stiffness.
void Condensation::complement() {
  const auto c = parts_.contact;
  const long grid = stiffness_grid + displacement_grid;
  std::vector<mpz_class> sums(
      c * c);  // K_CN X + X'R, on the product of the stiffness grid and twice the displacement grid
  for (std::size_t row = 0; row < parts_.rest; ++row) {
    for (const auto& entry : parts_.rest_contact[row]) {
      for (std::size_t j = 0; j <= entry.column; ++j) {
        mpz_addmul(sums[c * entry.column + j].get_mpz_t(), entry.value.get_mpz_t(),
                   dependent_[j][row].get_mpz_t());
      }
    }
  }
  for (auto& sum : sums) {
    mpz_mul_2exp(sum.get_mpz_t(), sum.get_mpz_t(), static_cast<mp_bitcnt_t>(-displacement_grid));
  }
  complement_.assign(c * c, 0);
  for (std::size_t i = 0; i < c; ++i) {
    for (const auto& entry : parts_.contact_contact[i])
      complement_[c * i + entry.column] = entry.value;
  }
  for (std::size_t i = 0; i < c; ++i) {
    const double part = static_cast<double>(i) / static_cast<double>(c);
    work_.report_share("enclosing K for the proof, products", part * part);
    for (std::size_t j = 0; j <= i; ++j) {
      auto* const sum = sums[c * i + j].get_mpz_t();
      for (std::size_t row = 0; row < parts_.rest; ++row) {
        if (sgn(residual_[j][row]) == 0) continue;
        mpz_addmul(sum, dependent_[i][row].get_mpz_t(), residual_[j][row].get_mpz_t());
      }
      mpz_class rounded;
      mpz_fdiv_q_2exp(rounded.get_mpz_t(), sum, static_cast<mp_bitcnt_t>(-2 * displacement_grid));
      complement_[c * i + j] -= rounded;
      complement_[c * j + i] = complement_[c * i + j];
    }
  }
  // delta ‖E‖^2 + (‖R‖ + delta ‖E‖)^2 / (s - delta), E = [I; -X]; and a rounding error for each
  // entry
  const Dyadic count(static_cast<double>(c));
  const auto delta = sqrt_above(parts_.error_square);
  const auto size_square = count + square_sum(dependent_, displacement_grid);
  radius_ = delta * size_square + count.scaled(stiffness_grid);
  if (parts_.rest > 0) {
    const auto left = sqrt_above(square_sum(residual_, grid)) + delta * sqrt_above(size_square);
    radius_ = radius_ + quotient_above(square(left), minimum_ - delta);
  }
}

// Frame of displacements that are already in the frame of their candidate.
Frame unit_frame(std::size_t d) {
  Frame result(d, std::vector<Enclosure>(d));
  for (std::size_t k = 0; k < d; ++k) result[k][k] = Enclosure(1);
  return result;
}

// Q'S Q with the frames Q of the candidates, without the scaling.
EnclosedMatrix Condensation::in_contact_frames() {
  const auto d = structure_.dimension;
  const auto c = parts_.contact;
  std::vector<std::vector<mpz_class>> frames;  // of each candidate, by columns
  Dyadic error_square;
  for (std::size_t i = 0; i < rows_.seen.size(); ++i) {
    auto& own = frames.emplace_back();
    const bool rotates = i < structure_.contact.size() && !rows_.shared.contains(i);
    for (const auto& column : rotates ? frame(structure_.contact[i], d) : unit_frame(d)) {
      for (const auto& component : column) {
        own.push_back(component.lower().multiples(stiffness_grid));
        error_square =
            error_square + square(component.distance(Dyadic(own.back(), stiffness_grid)));
      }
    }
  }
  Dyadic size_square;
  for (const auto& value : complement_) {
    size_square = size_square + square(Dyadic(value, stiffness_grid));
  }
  const auto error = sqrt_above(error_square);
  auto radius = radius_ + error * sqrt_above(size_square) * (Dyadic(2.0) + error);

  std::vector<Dyadic> entries(c * c);
  std::vector<Dyadic> half(d);
  long largest = stiffness_grid;
  for (std::size_t i = 0; i < c; ++i) {
    support::throw_if_requested(work_.stop);
    for (std::size_t j = 0; j <= i; ++j) {
      const auto& left = frames[i / d];
      const auto& right = frames[j / d];
      Dyadic sum;
      for (std::size_t k = 0; k < d; ++k) {
        Dyadic inner;
        for (std::size_t l = 0; l < d; ++l) {
          inner = inner + entry(i / d * d + k, j / d * d + l) *
                              Dyadic(right[j % d * d + l], stiffness_grid);
        }
        sum = sum + inner * Dyadic(left[i % d * d + k], stiffness_grid);
      }
      if (sum.sign() != 0) largest = std::max(largest, sum.magnitude());
      entries[c * i + j] = entries[c * j + i] = std::move(sum);
    }
  }
  EnclosedMatrix result;
  const long grid = largest - kept_bits;
  const long scale = 2 * parts_.contact_scale;
  result.middle.size = c;
  result.middle.entries.exponent = grid + scale;
  for (const auto& each : entries) result.middle.entries.mantissas.push_back(each.multiples(grid));
  radius = radius + Dyadic(static_cast<double>(c)).scaled(grid);
  result.radius = radius.scaled(scale);
  return result;
}

// The rows of the candidates, and the columns of the loads beside them.
LoadedStiffness Condensation::separated(EnclosedMatrix whole) const {
  LoadedStiffness result{std::move(whole), {}};
  if (rows_.loads.empty()) return result;
  auto& [matrix, radius] = result.stiffness;
  const DyadicMatrix all = std::move(matrix);
  const auto size = all.size - structure_.dimension;
  matrix = {size, DyadicList(size * size)};
  matrix.entries.exponent = all.entries.exponent;
  for (std::size_t i = 0; i < size; ++i) {
    for (std::size_t j = 0; j < size; ++j)
      matrix.entries.mantissas[size * i + j] = all.entries.mantissas[all.size * i + j];
  }
  for (std::size_t load = 0; load < loads_.size(); ++load) {
    auto& [forces, error] = result.loads.emplace_back();
    forces = DyadicList(size);
    forces.exponent = all.entries.exponent - rows_.load_scales[load];
    for (std::size_t i = 0; i < size; ++i)
      forces.mantissas[i] = all.entries.mantissas[all.size * i + size + load];
    error = radius.scaled(-rows_.load_scales[load]);
  }
  return result;
}

std::variant<LoadedStiffness, std::string> Condensation::result() {
  if (auto why = partition()) return *why;
  if (auto why = factorise()) return *why;
  if (parts_.rest > 0 && !(minimum_ > sqrt_above(parts_.error_square))) return too_ill_conditioned;
  solve_dependent();
  complement();
  return separated(in_contact_frames());
}

}  // namespace

std::variant<EnclosedMatrix, std::string> condensed_stiffness(const Structure& structure,
                                                              double springs,
                                                              const support::LongWork& work) {
  auto found = loaded_stiffness(structure, {}, springs, work);
  if (auto* why = std::get_if<std::string>(&found)) return std::move(*why);
  return std::move(std::get<LoadedStiffness>(found).stiffness);
}

std::variant<LoadedStiffness, std::string> loaded_stiffness(const Structure& structure,
                                                            std::span<const ForceList> loads,
                                                            double springs,
                                                            const support::LongWork& work) {
  return Condensation(structure, loads, springs, work).result();
}

}  // namespace kusabi::verify
