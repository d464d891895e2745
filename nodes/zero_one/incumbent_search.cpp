// Rounding and diving.
#include "nodes/zero_one/incumbent_search.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "nodes/zero_one/objective_steps.hpp"

namespace kusabi::zero_one {
namespace {

using linear::LinearStatus;

// Each step of a dive fixes this share of the fractional binaries, but one at least.
constexpr std::size_t steps_of_a_dive = 12;

struct Candidate {
  double distance;
  std::size_t binary;
};

// The fractional binaries, those nearest to 0 or 1 first; the others are fixed at their values.
std::vector<Candidate> hold_whole_ones(const Relaxation& relaxation, Fixings& fixings) {
  std::vector<Candidate> rest;
  for (std::size_t k = 0; k < relaxation.binaries(); ++k) {
    if (!fixings.free(k)) continue;
    const double at = relaxation.value(k);
    const double distance = std::min(at, 1 - at);
    if (distance <= integrality_tolerance) {
      fixings.fix(k, at > 0.5);
    } else {
      rest.push_back({distance, k});
    }
  }
  std::stable_sort(rest.begin(), rest.end(),
                   [](const auto& a, const auto& b) { return a.distance < b.distance; });
  return rest;
}

// Sum of the violations of rows; infinite if one exceeds rounding.
double excess(const linear::LinearProgram& program, const std::vector<double>& values) {
  constexpr double part = 1e-12;
  struct Activity {
    double sum = 0;
    double size = 0;
  };
  std::vector<Activity> activities(program.rows.size());
  for (const auto& [row, column, value] : program.entries) {
    auto& [sum, size] = activities[static_cast<std::size_t>(row)];
    const double term = value * values[static_cast<std::size_t>(column)];
    sum += term;
    size += std::abs(term);
  }
  double total = 0;
  for (std::size_t i = 0; i < activities.size(); ++i) {
    const auto& [sum, size] = activities[i];
    const auto& [lower, upper, name] = program.rows[i];
    const double missing = std::max({0.0, lower - sum, sum - upper});
    if (!(missing <= part * size)) return linear::infinity;
    total += missing;
  }
  return total;
}

double largest_cost(const linear::LinearProgram& program) {
  double largest = 0;
  for (const auto& column : program.columns) largest = std::max(largest, std::abs(column.cost));
  return largest;
}

double objective_of(const linear::LinearProgram& program, const std::vector<double>& values) {
  double sum = program.constant;
  for (std::size_t j = 0; j < values.size(); ++j) sum += program.columns[j].cost * values[j];
  return sum;
}

}  // namespace

std::optional<ZeroOnePoint> point_at(Relaxation& relaxation, const Fixings& fixings,
                                     const linear::Basis& basis) {
  if (relaxation.solve(fixings, basis) != LinearStatus::optimal) return {};
  ZeroOnePoint point{.values = relaxation.values()};
  for (std::size_t k = 0; k < relaxation.binaries(); ++k) {
    point.values[static_cast<std::size_t>(relaxation.column(k))] = fixings.at_one(k) ? 1 : 0;
  }
  const auto& program = relaxation.program();
  for (std::size_t j = 0; j < point.values.size(); ++j) {
    const auto& column = program.columns[j];
    point.values[j] = std::clamp(point.values[j], column.lower, column.upper);
  }
  const auto exact = relaxation.exact_point();
  if (exact.status == LinearStatus::optimal) {
    point.values = exact.values;
    point.objective = exact.objective;
    point.proved = true;
    if (!std::isfinite(point.objective)) return {};
    return point;
  }
  // Too much work: the doubles are accurate enough if their objective agrees with the bound and the
  // violations of rows are negligible even at the largest cost, which may be a penalty on them.
  constexpr double share = 0.25;
  point.objective = objective_of(program, point.values);
  const double maximum = share * step_width(point.objective);
  const bool accurate = exact.status == LinearStatus::failed &&
                        std::abs(point.objective - relaxation.bound()) <= maximum &&
                        excess(program, point.values) * largest_cost(program) <= maximum;
  if (!accurate) return {};
  return point;
}

Fixings rounded_fixings(const Relaxation& relaxation, Fixings fixings) {
  for (std::size_t k = 0; k < relaxation.binaries(); ++k) {
    if (fixings.free(k)) fixings.fix(k, relaxation.value(k) > 0.5);
  }
  return fixings;
}

std::optional<ZeroOnePoint> dive(Relaxation& relaxation, const Fixings& fixings,
                                 const linear::Basis& basis) {
  if (relaxation.solve(fixings, basis) != LinearStatus::optimal) return {};
  Fixings held = fixings;
  for (;;) {
    if (support::is_requested(relaxation.stop())) return {};
    const auto start = relaxation.basis();
    const auto fractional = hold_whole_ones(relaxation, held);
    if (fractional.empty()) return point_at(relaxation, held, start);
    const std::size_t count = std::max<std::size_t>(1, relaxation.binaries() / steps_of_a_dive);
    Fixings next = held;
    for (std::size_t i = 0; i < std::min(count, fractional.size()); ++i) {
      next.fix(fractional[i].binary, relaxation.value(fractional[i].binary) > 0.5);
    }
    const bool up = relaxation.value(fractional.front().binary) > 0.5;
    if (relaxation.solve(next, start) != LinearStatus::optimal) {
      next = held;
      next.fix(fractional.front().binary, !up);
      if (relaxation.solve(next, start) != LinearStatus::optimal) return {};
    }
    held = std::move(next);
  }
}

}  // namespace kusabi::zero_one
