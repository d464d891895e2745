// Static condensation in integers: multiples of 2^-300 for the stiffness, of 2^-160 for the
// dependent displacements.
#include "verify/structure/condensation.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "verify/arithmetic/cholesky.hpp"
#include "verify/arithmetic/reverse_cuthill_mckee.hpp"
#include "verify/structure/assembly.hpp"
#include "verify/structure/enclosed_problem.hpp"
#include "verify/structure/several_normals.hpp"

namespace kusabi::verify {
namespace {

constexpr long stiffness_grid = -300;
constexpr long displacement_grid = -160;
constexpr long kept_bits = 160;  // of K
constexpr const char* too_ill =
    "the stiffness is not proved to be positive definite: the structure is a mechanism, or too "
    "ill-conditioned for a factor in double precision";

struct Entry {
  std::size_t column;
  mpz_class value;
};
using Rows = std::vector<std::vector<Entry>>;

// K^0, scaled by powers of two, rounded to the grid and partitioned as in equation (2).
struct Parts {
  std::size_t contact = 0;  // c
  std::size_t rest = 0;     // n
  Rows contact_contact;     // all by rows; columns of N in the order of N
  Rows rest_contact;
  Rows rest_rest;
  Dyadic error_square;  // of the distance from the exact K^0, scaled alike, in the Frobenius norm
  long contact_scale = 0;  // displacements of C are multiplied by 2^this, forces divided
};

// Half of the exponent of a diagonal entry: scaling with 2^-this on both sides makes it about 1.
long half_exponent(const Dyadic& value) {
  return static_cast<long>(std::floor(static_cast<double>(value.magnitude()) / 2));
}

class Condensation {
 public:
  Condensation(const Structure& structure, std::span<const ForceList> loads, double springs,
               const support::LongWork& work)
      : structure_(structure), loads_(loads), springs_(springs), work_(work), freedom_(structure) {}

  std::variant<LoadedStiffness, std::string> result();

 private:
  void add_loads(SparseEnclosure& stiffness);
  void release_rollers(const ContactPoint& point, SparseEnclosure& stiffness);
  void number_candidates(SparseEnclosure& stiffness);
  std::optional<std::string> partition();
  void order_unknowns(const SparseEnclosure& stiffness);
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
  double springs_;
  const support::LongWork& work_;
  Freedom freedom_;
  std::vector<std::vector<std::size_t>> seen_;  // d displacements of each candidate
  std::vector<std::size_t> load_numbers_;       // rows of the loads, d or none
  std::vector<long> load_scales_;               // forces are multiplied by 2^this
  CandidateNumbers shared_numbers_;  // displacements of candidates at nodes with several contact
                                     // normals, already in their frames
  std::vector<std::size_t> place_;   // position of each free displacement in C or N
  std::vector<bool> is_contact_;
  std::vector<std::size_t> displacement_;  // displacement at each position in N
  Parts parts_;
  Profile profile_;
  std::optional<Cholesky> factor_;                 // of K_NN
  Dyadic minimum_;                                 // lower bound of its eigenvalues
  std::vector<std::vector<mpz_class>> dependent_;  // X, by columns, on the displacement grid
  std::vector<std::vector<mpz_class>> residual_;  // R = K_NC - K_NN X, on the product of both grids
  std::vector<mpz_class> complement_;             // S, c x c, on the stiffness grid
  Dyadic radius_;
};

void Condensation::order_unknowns(const SparseEnclosure& stiffness) {
  place_.assign(freedom_.count, 0);
  is_contact_.assign(freedom_.count, false);
  for (const auto& numbers : seen_) {
    for (const auto number : numbers) {
      is_contact_[number] = true;
      place_[number] = parts_.contact++;
    }
  }
  std::vector<std::size_t> rest;
  for (std::size_t number = 0; number < freedom_.count; ++number) {
    if (is_contact_[number]) continue;
    place_[number] = rest.size();
    rest.push_back(number);
  }
  std::vector<std::vector<std::size_t>> neighbours(rest.size());
  for (std::size_t at = 0; at < rest.size(); ++at) {
    for (const auto& [column, value] : stiffness[rest[at]]) {
      if (!is_contact_[column] && column != rest[at]) neighbours[at].push_back(place_[column]);
    }
  }
  for (const auto at : reverse_cuthill_mckee(neighbours)) displacement_.push_back(rest[at]);
  for (std::size_t at = 0; at < displacement_.size(); ++at) place_[displacement_[at]] = at;
  parts_.rest = rest.size();
}

// Adds a grounding spring, without coupling, for a displacement of a candidate that a roller
// prevents, so that K has d rows for each candidate. It is as stiff as the node along the axis
// nearest to its normal. The roller takes the reaction of the obstacle along this displacement
// (docs/theory/wedged.md, "Rollers at candidates").
void Condensation::release_rollers(const ContactPoint& point, SparseEnclosure& stiffness) {
  auto& numbers = freedom_.number[point.node];
  const auto normal = numbers[largest_component_axis(point.normal)];
  for (std::size_t axis = 0; axis < structure_.dimension; ++axis) {
    if (numbers[axis] != Freedom::none) continue;
    const auto spring = stiffness[normal][normal];
    numbers[axis] = freedom_.count++;
    stiffness.emplace_back()[numbers[axis]] = spring;
  }
}

// A load is a row of K^0, H'f, and stays with the candidates: condensed with them it becomes E'f.
// Forces are scaled by powers of two to the size of the stiffness. Loads are the displacements of
// one more candidate.
void Condensation::add_loads(SparseEnclosure& stiffness) {
  const double size = typical_stiffness(structure_);
  for (std::size_t load = 0; load < structure_.dimension; ++load) {
    const auto row = freedom_.count++;
    stiffness.emplace_back()[row] = Enclosure(size);
    load_numbers_.push_back(row);
    if (load >= loads_.size()) continue;
    double largest = 0;
    for (const auto& force : loads_[load]) {
      for (const double component : force.components)
        largest = std::max(largest, std::abs(component));
    }
    const int scale = largest == 0 ? 0 : std::ilogb(size) - std::ilogb(largest);
    load_scales_.push_back(scale);
    for (const auto& [node, components] : loads_[load]) {
      for (std::size_t axis = 0; axis < structure_.dimension; ++axis) {
        const Enclosure force(Dyadic(components[axis]).scaled(scale));
        if (force.is_zero()) continue;
        for (const auto& [number, weight] : freedom_.weighted(node, axis)) {
          stiffness[row][number] += force * weight;
          stiffness[number][row] += force * weight;
        }
      }
    }
  }
}

// A candidate alone at its node has the displacements of the node. Rollers are released before
// normal coordinates are introduced, since the opposite place may be at a node with several contact
// normals.
void Condensation::number_candidates(SparseEnclosure& stiffness) {
  if (!loads_.empty()) add_loads(stiffness);
  const auto shared = shared_nodes(structure_);
  const auto add_springs = [&](const auto& numbers) {
    for (const auto number : numbers) {
      if (springs_ != 0 && number != Freedom::none)
        stiffness[number][number] += Enclosure(springs_);
    }
  };
  for (const auto& point : structure_.contact) {
    if (shared.contains(point.node)) continue;
    add_springs(freedom_.number[point.node]);
  }
  for (const auto& point : structure_.contact) {
    if (!shared.contains(point.node)) release_rollers(point, stiffness);
  }
  shared_numbers_ = use_normal_coordinates(structure_, freedom_, stiffness);
  for (const auto& [candidate, numbers] : shared_numbers_) add_springs(numbers);
  const auto d = static_cast<std::ptrdiff_t>(structure_.dimension);
  for (std::size_t i = 0; i < structure_.contact.size(); ++i) {
    const auto found = shared_numbers_.find(i);
    const auto& numbers = freedom_.number[structure_.contact[i].node];
    seen_.push_back(found != shared_numbers_.end()
                        ? found->second
                        : std::vector<std::size_t>(numbers.begin(), numbers.begin() + d));
  }
  if (!load_numbers_.empty()) seen_.push_back(load_numbers_);
}

std::optional<std::string> Condensation::partition() {
  auto stiffness = enclosed_stiffness(structure_, freedom_);
  number_candidates(stiffness);
  for (std::size_t row = 0; row < stiffness.size(); ++row) {
    const auto diagonal = stiffness[row].find(row);
    if (diagonal == stiffness[row].end()) return too_ill;
    for (const auto& [column, value] : stiffness[row]) {
      if (!value.finite()) return "a bar has no length, or an element no area";
    }
    if (diagonal->second.lower().sign() <= 0) return too_ill;
  }
  order_unknowns(stiffness);
  // N: each displacement has its own scale. C: all have the same, such that the error bound needs
  // no weighted norm.
  std::vector<long> scale(freedom_.count);
  std::optional<long> largest;
  for (std::size_t row = 0; row < freedom_.count; ++row) {
    scale[row] = half_exponent(stiffness[row].at(row).lower());
    if (is_contact_[row]) largest = std::max(largest.value_or(scale[row]), scale[row]);
  }
  parts_.contact_scale = *largest;
  for (std::size_t row = 0; row < freedom_.count; ++row) {
    if (is_contact_[row]) scale[row] = *largest;
  }
  parts_.contact_contact.resize(parts_.contact);
  parts_.rest_contact.resize(parts_.rest);
  parts_.rest_rest.resize(parts_.rest);
  for (std::size_t row = 0; row < freedom_.count; ++row) {
    for (const auto& [column, value] : stiffness[row]) {
      const long shift = -scale[row] - scale[column];
      Entry entry{place_[column], value.lower().scaled(shift).multiples(stiffness_grid)};
      const auto error = value.upper().scaled(shift) - Dyadic(entry.value, stiffness_grid);
      parts_.error_square = parts_.error_square + square(error);
      if (is_contact_[row] && !is_contact_[column]) continue;  // its transpose
      auto& rows = is_contact_[row]      ? parts_.contact_contact
                   : is_contact_[column] ? parts_.rest_contact
                                         : parts_.rest_rest;
      rows[place_[row]].push_back(std::move(entry));
    }
  }
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
  support::leave_if(work_.stop);
  const auto minimum = min_eigenvalue(profile_, entries);
  support::leave_if(work_.stop);
  factor_ = Cholesky::of(profile_, rounded);
  if (!minimum || !factor_) return too_ill;
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
    work_.reached("enclosing K for the proof, columns",
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
    work_.reached("enclosing K for the proof, products", part * part);
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
  for (std::size_t i = 0; i < seen_.size(); ++i) {
    auto& own = frames.emplace_back();
    const bool rotates = i < structure_.contact.size() && !shared_numbers_.contains(i);
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
    support::leave_if(work_.stop);
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
  if (load_numbers_.empty()) return result;
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
    forces.exponent = all.entries.exponent - load_scales_[load];
    for (std::size_t i = 0; i < size; ++i)
      forces.mantissas[i] = all.entries.mantissas[all.size * i + size + load];
    error = radius.scaled(-load_scales_[load]);
  }
  return result;
}

std::variant<LoadedStiffness, std::string> Condensation::result() {
  if (auto why = partition()) return *why;
  if (auto why = factorise()) return *why;
  if (parts_.rest > 0 && !(minimum_ > sqrt_above(parts_.error_square))) return too_ill;
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
