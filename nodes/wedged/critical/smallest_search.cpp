// Conversion of the outcome of the tree to a bracket.
#include "nodes/wedged/critical/smallest_search.hpp"

#include <algorithm>
#include <cmath>

#include "engine/collectives.hpp"

namespace kusabi::wedged {

std::int64_t multiples(double maximum, double width) {
  return static_cast<std::int64_t>(std::llround(maximum / width));
}

// If the tree is infeasible up to the upper bound of the known leaf, the lower bound is the grid
// point before it. The bound of a stopped search lies between two points.
void SmallestCoefficient::narrow(NarrowingBracket& bracket, double width) const {
  if (std::isfinite(upper)) bracket.reduce_upper(upper, leaf);
  const FrictionGrid grid(width);
  double known = lower;
  if (status != engine::Status::solved) {
    const auto below = static_cast<std::int64_t>(std::floor(lower / width));
    known = grid.at(grid.at(below) <= lower ? below : below - 1);
  }
  const double above = bracket.upper_or_infinity();
  bracket.raise_lower(known < above ? known : grid.at(multiples(above, width) - 1));
}

SmallestCoefficient smallest_coefficient(const engine::OutcomeOf<CriticalTree>& outcome,
                                         const CriticalGrid& grid, double known) {
  SmallestCoefficient smallest;
  smallest.status = outcome.status;
  const bool whole = outcome.status == engine::Status::solved;
  smallest.lower = whole ? grid.maximum : std::min(grid.maximum, std::max(known, outcome.bound));
  const FrictionGrid points(grid.width);
  for (const auto& found : outcome.solutions) {
    const auto& [cell, leaf] = found.solution;
    smallest.lower = std::min(smallest.lower, points.at(cell.infeasible));
    smallest.upper = points.at(cell.feasible);
    smallest.leaf = leaf;
  }
  // Every schedule opens the undecided leaves below the upper bound, so the result is the same.
  smallest.lower = std::min(smallest.lower, outcome.tally().undecided_from.value);
  return smallest;
}

SmallestCoefficient find_smallest(engine::Analysis& analysis,
                                  const problems::WedgedProblem& problem,
                                  const SmallestParameters& parameters,
                                  std::vector<CriticalCost>& costs,
                                  std::vector<engine::RankReport<CriticalTree>>& ranks) {
  const auto& [direction, phase, grid, known, bounds] = parameters;
  CriticalTree tree(problem, grid.width, multiples(grid.maximum, grid.width), direction, known,
                    grid.precision);
  if (direction == CriticalDirection::down) configure(tree, problem, bounds);
  engine::Options options;
  options.goal = engine::Goal::best;
  options.order =
      direction == CriticalDirection::up ? engine::Order::best_first : engine::Order::depth_first;
  auto outcome = analysis.search(tree, options);
  costs.push_back({phase, direction == CriticalDirection::up ? known : grid.maximum,
                   outcome.opened(), bounds.programs + outcome.tally().programs});
  const auto result = engine::from_first_rank(analysis.transport(), [&] {
    return smallest_coefficient(outcome, parameters.grid, parameters.known);
  });
  if (analysis.is_first()) ranks = std::move(outcome.ranks);
  return result;
}

}  // namespace kusabi::wedged
