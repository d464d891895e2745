// One question after another; the last one asks for the curve, too.
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

// With those that the file leaves open up to alpha, beside those that it does not: to be searched
// with 1.
problems::LimitProblem settled(problems::LimitProblem problem, double alpha) {
  if (alpha == 0) {
    std::erase_if(problem.uncertain, [](const auto& column) { return !column.in_file; });
  } else {
    const std::array cases{&problem};
    problems::settle_half_widths(cases, {.alpha = alpha});
  }
  return problem;
}

}  // namespace

LimitSweep sweep_limit_loads(engine::Campaign& campaign, const problems::Structure& truss,
                             const problems::LimitProblem& problem,
                             std::span<const double> alphas) {
  LimitSweep sweep;
  const bool fixed = has_fixed(problem);
  for (const double alpha : alphas) {
    // The worst curve is that of all uncertain loads in proportion.
    const bool curve = !fixed && alpha == alphas.back() && alpha > 0;
    const LimitQuestion question{.alpha = fixed ? 1 : alpha, .curve = curve};
    sweep.last = fixed ? limit_loads(campaign, truss, settled(problem, alpha), question).answer
                       : limit_loads(campaign, truss, problem, question).answer;
    const auto& worst = sweep.last.worst;
    sweep.status =
        worst && worst->search != engine::Status::solved ? worst->search : sweep.last.rest;
    if (!worst) break;  // there is no nominal factor
    sweep.points.push_back({alpha, *worst});
    if (sweep.status != engine::Status::solved) break;
  }
  return sweep;
}

bool LimitSweep::whole(std::size_t asked) const {
  if (status != engine::Status::solved || !last.whole()) return false;
  return !last.worst ||
         (points.size() == asked &&
          std::ranges::all_of(points, [](const auto& each) { return each.worst.proved; }));
}

}  // namespace kusabi::limit
