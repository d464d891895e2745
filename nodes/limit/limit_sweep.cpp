// One question after another; the last one asks for the curve, too.
#include "nodes/limit/limit_sweep.hpp"

#include <algorithm>
#include <utility>

#include "nodes/limit/limit_loads.hpp"

namespace kusabi::limit {

LimitSweep sweep_limit_loads(engine::Campaign& campaign, const problems::Structure& truss,
                             const problems::LimitProblem& problem,
                             std::span<const double> alphas) {
  LimitSweep sweep;
  for (const double alpha : alphas) {
    const LimitQuestion question{.alpha = alpha, .curve = alpha == alphas.back() && alpha > 0};
    sweep.last = limit_loads(campaign, truss, problem, question).answer;
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
