// Gaussian elimination in rational numbers, rows with few entries first: supports of basic
// solutions are nearly triangular.
#include "verify/limit/stress_state.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace kusabi::verify {
namespace {

/// Factor of the pivots of members without stress.
constexpr double without_stress = 1e-9;

/// Equation of one displacement for the corrections of force densities and of the factor.
struct Equation {
  std::map<std::size_t, mpq_class> entries;  // by place in the support; the factor comes last
  std::vector<mpq_class> missing;            // one for each load
};

std::uint64_t words(const mpq_class& number) {
  return mpz_size(number.get_num_mpz_t()) + mpz_size(number.get_den_mpz_t());
}

/// Exact force densities and factors near those of a state.
class ExactColumns {
 public:
  ExactColumns(const ExactTruss& truss, const StressState& state);

  // Removes the equilibrium error of all columns. @return false if that is impossible, or a limit
  // is reached
  bool balance(const EliminationLimits& limits);
  [[nodiscard]] bool within_yield_forces() const;
  [[nodiscard]] CarriedFactor carried() const;

 private:
  [[nodiscard]] std::size_t pivot_of(const Equation& equation) const;

  const ExactTruss& truss_;
  const StressState& state_;
  std::vector<std::vector<mpq_class>> values_;  // by load: densities, then the factor
  std::vector<bool> stressed_;                  // by place
  std::vector<Equation> equations_;             // with entries or an error
};

ExactColumns::ExactColumns(const ExactTruss& truss, const StressState& state)
    : truss_(truss), state_(state), stressed_(state.support.size()) {
  const auto loads = state.columns.size();
  const auto& support = state.support;
  std::vector<Equation> all(truss.displacements);
  for (auto& equation : all) equation.missing.resize(loads);
  for (std::size_t place = 0; place < support.size(); ++place) {
    for (const auto& [e, entry] : truss.columns[support[place]]) all[e].entries[place] = entry;
  }
  for (std::size_t e = 0; e < all.size(); ++e) {
    if (sgn(truss.reference[e]) != 0) all[e].entries[support.size()] = -truss.reference[e];
    all[e].missing[0] = truss.dead[e];
  }
  for (std::size_t load = 0; load < loads; ++load) {
    const auto& column = state.columns[load];
    auto& values = values_.emplace_back(support.size() + 1);
    for (const auto& [member, force] : column.forces) {
      const auto found = std::ranges::lower_bound(support, member);
      if (found == support.end() || *found != member) continue;
      const auto place = found - support.begin();
      // Zero, which the elimination corrects, where the length is beyond double precision.
      const double density = force / std::sqrt(truss.square_lengths[member].get_d());
      if (std::isfinite(density)) values[static_cast<std::size_t>(place)] = density;
      stressed_[static_cast<std::size_t>(place)] = true;
    }
    values.back() = column.factor;
    if (load > 0) {
      for (const auto& [e, value] : truss.uncertain[load - 1]) all[e].missing[load] += value;
    }
    for (auto& equation : all) {
      for (const auto& [place, entry] : equation.entries) {
        if (sgn(values[place]) != 0) equation.missing[load] -= entry * values[place];
      }
    }
  }
  for (auto& equation : all) {
    const bool any =
        std::ranges::any_of(equation.missing, [](const mpq_class& each) { return sgn(each) != 0; });
    if (any || !equation.entries.empty()) equations_.push_back(std::move(equation));
  }
}

// Members with stress first, then those that can take either sign, then cables; the factor only
// where no member can balance.
std::size_t ExactColumns::pivot_of(const Equation& equation) const {
  std::size_t best = equation.entries.begin()->first;
  double largest = -1;
  for (const auto& [place, entry] : equation.entries) {
    if (place == state_.support.size()) continue;
    double size = std::abs(entry.get_d());
    if (!stressed_[place]) {
      const auto member = state_.support[place];
      const bool cable = sgn(truss_.tension[member]) == 0 || sgn(truss_.compression[member]) == 0;
      size *= cable ? without_stress * without_stress : without_stress;
    }
    if (size <= largest) continue;
    largest = size;
    best = place;
  }
  return best;
}

bool ExactColumns::balance(const EliminationLimits& limits) {
  std::uint64_t products = 0;
  std::vector<std::pair<std::size_t, Equation>> solved;  // by pivot
  while (!equations_.empty()) {
    if (products > limits.products || support::is_requested(limits.stop)) return false;
    const auto next = std::ranges::min_element(
        equations_, {}, [](const Equation& each) { return each.entries.size(); });
    auto equation = std::move(*next);
    if (next != equations_.end() - 1) *next = std::move(equations_.back());
    equations_.pop_back();
    if (equation.entries.empty()) {
      const auto wrong = [](const mpq_class& each) { return sgn(each) != 0; };
      if (std::ranges::any_of(equation.missing, wrong)) return false;
      continue;
    }
    const auto pivot = pivot_of(equation);
    const mpq_class inverse = 1 / equation.entries[pivot];
    equation.entries.erase(pivot);
    for (auto& [place, entry] : equation.entries) entry *= inverse;
    for (auto& each : equation.missing) each *= inverse;
    for (auto& other : equations_) {
      const auto found = other.entries.find(pivot);
      if (found == other.entries.end()) continue;
      const mpq_class times = std::move(found->second);
      other.entries.erase(found);
      for (const auto& [place, entry] : equation.entries) {
        products += words(times) * words(entry);
        auto& changed = other.entries[place];
        changed -= times * entry;
        if (sgn(changed) == 0) other.entries.erase(place);
      }
      for (std::size_t load = 0; load < other.missing.size(); ++load)
        other.missing[load] -= times * equation.missing[load];
    }
    solved.emplace_back(pivot, std::move(equation));
  }
  std::vector<std::vector<mpq_class>> changes(values_.size());
  for (auto& change : changes) change.resize(state_.support.size() + 1);
  for (auto each = solved.rbegin(); each != solved.rend(); ++each) {
    const auto& [pivot, equation] = *each;
    for (std::size_t load = 0; load < changes.size(); ++load) {
      auto& change = changes[load];
      change[pivot] = equation.missing[load];
      for (const auto& [place, entry] : equation.entries) {
        if (sgn(change[place]) != 0) change[pivot] -= entry * change[place];
      }
      values_[load][pivot] += change[pivot];
    }
  }
  return true;
}

bool ExactColumns::within_yield_forces() const {
  for (std::size_t place = 0; place < state_.support.size(); ++place) {
    const auto member = state_.support[place];
    mpq_class variation;
    for (std::size_t load = 1; load < values_.size(); ++load)
      variation += abs(values_[load][place]);
    const auto fits = [&](const mpq_class& density, const mpq_class& yield) {
      return sgn(density) <= 0 ||
             density * density * truss_.square_lengths[member] <= yield * yield;
    };
    const auto& mean = values_.front()[place];
    if (!fits(variation + mean, truss_.tension[member])) return false;
    if (!fits(variation - mean, truss_.compression[member])) return false;
  }
  return true;
}

CarriedFactor ExactColumns::carried() const {
  CarriedFactor result{values_.front().back(), {}};
  for (std::size_t load = 1; load < values_.size(); ++load)
    result.factor -= abs(values_[load].back());
  for (std::size_t place = 0; place < state_.support.size(); ++place) {
    const auto has_force = [&](const auto& column) { return sgn(column[place]) != 0; };
    if (std::ranges::any_of(values_, has_force)) result.members.push_back(state_.support[place]);
  }
  return result;
}

}  // namespace

std::optional<CarriedFactor> carried_factor(const ExactTruss& truss, const StressState& state,
                                            const EliminationLimits& limits) {
  ExactColumns columns(truss, state);
  if (!columns.balance(limits) || !columns.within_yield_forces()) return {};
  return columns.carried();
}

}  // namespace kusabi::verify
