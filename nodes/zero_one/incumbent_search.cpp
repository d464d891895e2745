// Rounding and diving.
#include "nodes/zero_one/incumbent_search.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace kusabi::nodes {
namespace {

using linear::LinearStatus;

// Each step of a dive holds this share of the binaries that are still fractional, but one at least.
constexpr std::size_t steps_of_a_dive = 12;

struct Candidate {
  double distance;
  std::size_t binary;
};

// The fractional binaries, those nearest to 0 or 1 first; the others are held where they are.
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

}  // namespace

std::optional<ZeroOnePoint> point_at(Relaxation& relaxation, const Fixings& fixings,
                                     const linear::Basis& basis) {
  if (relaxation.solve(fixings, basis) != LinearStatus::optimal) return {};
  ZeroOnePoint point{.values = relaxation.simplex().values()};
  for (std::size_t k = 0; k < relaxation.binaries(); ++k) {
    point.values[static_cast<std::size_t>(relaxation.column(k))] = fixings.at_one(k) ? 1 : 0;
  }
  const auto& program = relaxation.program();
  point.objective = program.constant;
  for (std::size_t j = 0; j < point.values.size(); ++j) {
    point.objective += program.columns[j].cost * point.values[j];
  }
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
    const auto start = relaxation.simplex().basis();
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

}  // namespace kusabi::nodes
