// One analysis for each alpha; the last one also computes the curve.
#include "nodes/limit/limit_sweep.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "nodes/limit/limit_loads.hpp"
#include "problems/limit/half_widths.hpp"

namespace kusabi::limit {
namespace {

bool has_fixed(const problems::LimitProblem& problem) {
  return std::ranges::any_of(problem.uncertain, &problems::UncertainColumn::in_file);
}

// Sets the half-widths of loads without one in the file to alpha.
// @return alpha of the search
double settle(problems::LimitProblem& problem, double alpha) {
  const std::array cases{&problem};
  return problems::set_half_widths(cases, {.alpha = alpha}).value();
}

}  // namespace

LimitSweep sweep_limit_loads(engine::Analysis& analysis, const problems::Structure& truss,
                             const problems::LimitProblem& problem, std::span<const double> alphas,
                             bool evidence) {
  LimitSweep sweep;
  for (const double alpha : alphas) {
    auto own = problem;
    LimitParameters parameters{.alpha = settle(own, alpha), .evidence = evidence};
    // The worst-case curve scales all uncertain loads in proportion.
    parameters.curve = !has_fixed(problem) && alpha == alphas.back() && alpha > 0;
    auto found = limit_loads(analysis, truss, own, parameters);
    sweep.last = std::move(found.answer);
    sweep.status = sweep.last.ended();
    const auto& worst = sweep.last.worst;
    if (evidence) sweep.theorems.push_back(std::move(found.theorems));
    if (!worst) break;  // there is no nominal factor
    sweep.points.push_back({alpha, *worst, guaranteed_interval(sweep.last)});
    if (sweep.status != engine::Status::solved) break;
  }
  return sweep;
}

bool LimitSweep::whole(std::size_t asked) const {
  if (status != engine::Status::solved || !last.whole()) return false;
  return !last.worst ||
         (points.size() == asked && std::ranges::all_of(points, [](const auto& each) {
            return each.worst.proved() && is_proved(each.interval.standing());
          }));
}

}  // namespace kusabi::limit
