// Each load case is a box: all choices of favourable and unfavourable factors with one leading
// action.
#include "problems/files/sections/action_combinations.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <boost/multiprecision/cpp_int.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace kusabi::problems {
namespace {

using Rational = boost::multiprecision::cpp_rational;
using Actions = std::vector<const Action*>;

enum class Rule { general, without_leading, reduced };  // (6.10), (6.10a), (6.10b)

// Load case: the variable actions that act together, and the leading one.
struct Combination {
  Rule rule;
  const Action* leading;  // null: (6.10a)
  Actions variable;
  std::string name;
};

// Variable actions; those that exclude each other form one set.
std::vector<Actions> alternatives(const std::vector<Action>& actions) {
  std::vector<Actions> sets;
  for (const Action& action : actions) {
    if (action.permanent) continue;
    const auto same = std::ranges::find_if(sets, [&](const Actions& set) {
      return !action.alternatives.empty() && set.front()->alternatives == action.alternatives;
    });
    if (same == sets.end()) {
      sets.push_back({&action});
    } else {
      same->push_back(&action);
    }
  }
  return sets;
}

// All choices of one action from each set; the last set changes fastest.
std::vector<Actions> choices(const std::vector<Actions>& sets) {
  std::vector<Actions> chosen(1);
  for (const Actions& set : sets) {
    std::vector<Actions> longer;
    longer.reserve(chosen.size() * set.size());
    for (const Actions& so_far : chosen) {
      for (const Action* action : set) {
        longer.push_back(so_far);
        longer.back().push_back(action);
      }
    }
    chosen = std::move(longer);
  }
  return chosen;
}

std::vector<Combination> combinations(const ActionCombinations& all) {
  std::vector<Combination> result;
  for (const Actions& variable : choices(alternatives(all.actions))) {
    std::vector<std::string> exclusive;
    for (const Action* action : variable) {
      if (!action->alternatives.empty()) exclusive.push_back(action->name.text);
    }
    const auto with = exclusive.empty() ? "" : fmt::format(", {}", fmt::join(exclusive, ", "));
    if (all.both_rules) {
      result.push_back({Rule::without_leading, nullptr, variable, "6.10a" + with});
    }
    const auto rule = all.both_rules ? Rule::reduced : Rule::general;
    for (const Action* leading : variable) {
      result.push_back({rule, leading, variable,
                        fmt::format("{} {} leads{}", all.both_rules ? "6.10b" : "6.10",
                                    leading->name.text, with)});
    }
  }
  return result;
}

class LoadCases {
 public:
  LoadCases(const ActionCombinations& all, Structure& structure)
      : all_(all), structure_(structure) {}

  void add(const Combination& combination);

 private:
  [[nodiscard]] FactorRange range(const Action& action, const Combination& combination) const;
  void add_factors(const Action& action, FactorRange factors, const std::string& load_case);
  void add_bounded(const Action& action, FactorRange factors, const std::string& load_case);
  void add_load(Load::Kind kind, const ForceComponent& component, double force,
                const std::string& load_case);

  const ActionCombinations& all_;
  Structure& structure_;
};

FactorRange LoadCases::range(const Action& action, const Combination& combination) const {
  if (action.permanent) {
    const auto [lower, upper] = *action.permanent;
    if (combination.rule != Rule::reduced) return {lower, upper};
    const double reduced = all_.reduction * upper;
    return {std::min(lower, reduced), std::max(lower, reduced)};
  }
  const double maximum =
      &action == combination.leading ? action.factor : action.factor * action.combination;
  return {action.either_way ? -maximum : 0, maximum};
}

void LoadCases::add(const Combination& combination) {
  for (const Action& action : all_.actions) {
    if (!action.permanent) continue;
    const FactorRange factors = range(action, combination);
    add_factors(action, factors, combination.name);
    add_bounded(action, factors, combination.name);
  }
  for (const Action* action : combination.variable) {
    const FactorRange factors = range(*action, combination);
    add_factors(*action, factors, combination.name);
    if (action != &all_.actions[all_.reference]) {
      add_bounded(*action, factors, combination.name);
      continue;
    }
    for (const ForceComponent& each : action->components) {
      add_load(Load::Kind::reference, each, factors.upper * each.force, combination.name);
    }
  }
}

void LoadCases::add_factors(const Action& action, FactorRange factors,
                            const std::string& load_case) {
  const bool reference = &action == &all_.actions[all_.reference];
  structure_.actions.push_back(
      {action.name.text, factors.lower, factors.upper, reference, load_case});
}

// Nominal load in the middle of the range, rounded, and an uncertain load whose half-width is
// rounded up, so that the loads at both ends of the range are within it.
void LoadCases::add_bounded(const Action& action, FactorRange factors,
                            const std::string& load_case) {
  if (factors.lower == 0 && factors.upper == 0) return;
  double largest = 0;
  for (const auto& each : action.components) largest = std::max(largest, std::abs(each.force));
  // Exponent of a scaling by a power of two, which is exact; zero for forces of usual size.
  const int exponent = largest > 1e-3 && largest < 1e5 ? 0 : std::ilogb(largest);
  UncertainParameter parameter{action.name.text, {}, {}, {}, load_case};
  Rational half_width = 0;
  std::vector<support::SourcePosition> positions;
  for (const ForceComponent& each : action.components) {
    const double middle = (factors.lower / 2 + factors.upper / 2) * each.force;
    add_load(Load::Kind::dead, each, middle, load_case);
    for (const double end : {factors.lower, factors.upper}) {
      const Rational distance = abs(Rational(end) * Rational(each.force) - Rational(middle));
      half_width = std::max(half_width, Rational(distance / abs(Rational(each.force))));
    }
    parameter.components.push_back({each.node, each.axis, std::scalbn(each.force, -exponent)});
    positions.push_back(each.position);
  }
  if (factors.lower == factors.upper) return;
  auto up = static_cast<double>(half_width);
  while (Rational(up) < half_width)
    up = std::nextafter(up, std::numeric_limits<double>::infinity());
  parameter.half_width = std::scalbn(up, exponent);
  structure_.uncertain->push_back(std::move(parameter));
  structure_.sources.uncertain.insert(structure_.sources.uncertain.end(), positions.begin(),
                                      positions.end());
}

void LoadCases::add_load(Load::Kind kind, const ForceComponent& component, double force,
                         const std::string& load_case) {
  Eigen::VectorXd vector = Eigen::VectorXd::Zero(structure_.dimension);
  vector(component.axis) = force;
  structure_.loads.push_back({kind, component.node, std::move(vector), load_case});
  structure_.sources.loads.push_back(component.position);
}

}  // namespace

std::size_t ActionCombinations::variable_sets() const {
  return alternatives(actions).size();
}

double ActionCombinations::cases() const {
  const auto sets = alternatives(actions);
  double count = static_cast<double>(sets.size()) + (both_rules ? 1 : 0);
  for (const Actions& set : sets) count *= static_cast<double>(set.size());
  return count;
}

void ActionCombinations::add_to(Structure& structure) const {
  structure.uncertain.emplace();
  LoadCases cases(*this, structure);
  for (const Combination& each : combinations(*this)) cases.add(each);
}

}  // namespace kusabi::problems
