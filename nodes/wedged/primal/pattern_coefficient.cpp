// Newton's method and bisection in turn, to a relative width.
#include "nodes/wedged/primal/pattern_coefficient.hpp"

#include <algorithm>
#include <cmath>

#include "nodes/wedged/critical/critical_start.hpp"

namespace kusabi::wedged {
namespace {

constexpr double digits = 1e-3;
constexpr int max_probes = 30;

/// Without a limit: growth of the coefficient from one cone program to the next, and in all.
constexpr double growth = 1.4;
constexpr double max_growth = 8;

}  // namespace

std::optional<double> pattern_coefficient(CriticalFriction& critical,
                                          const support::IndexSet& contact,
                                          const CoefficientRange& range) {
  if (contact.empty()) return {};
  const auto pattern = leaf_with(contact, critical.solver().candidates());
  const double maximum = std::isfinite(range.limit) ? range.limit : max_growth * range.first;
  double infeasible = range.infeasible;
  double feasible = std::numeric_limits<double>::infinity();
  double factor = std::isfinite(range.limit) ? range.limit : range.first;
  for (int program = 0; program < max_probes; ++program) {
    const auto said = critical.probe(pattern, factor);
    if (said.sign == conic::Sign::feasible)
      feasible = std::min({feasible, factor, said.feasible_from});
    else
      infeasible = std::max(infeasible, factor);
    infeasible = std::min(std::max(infeasible, said.infeasible_below), feasible);
    if (std::isfinite(feasible)) {
      if (feasible - infeasible <= digits * feasible) break;
      const double middle = infeasible > 0 ? std::sqrt(infeasible * feasible) : 0.6 * feasible;
      const double tangent = said.newton * (1 + digits / 4);
      const bool by_tangent = program % 2 == 0 && tangent > infeasible && tangent < feasible;
      factor = by_tangent ? tangent : middle;
      if (factor < critical.min_factor()) break;
    } else {
      if (infeasible >= maximum) return {};
      const double next = std::isfinite(said.newton) ? said.newton * (1 + digits) : 0;
      factor = std::min(maximum, std::max(growth * factor, std::min(next, 2 * growth * factor)));
    }
  }
  if (!std::isfinite(feasible)) return {};
  return feasible;
}

}  // namespace kusabi::wedged
