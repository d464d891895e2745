// The share of an uncertain load, from -1 to 1, is the place of the factor in its range.
#include "problems/limit/action_factors.hpp"

#include <algorithm>
#include <stdexcept>

namespace kusabi::problems {
namespace {

// The ends exactly.
double factor_at(const ActionFactors& range, double share) {
  if (share <= -1) return range.lower;
  if (share >= 1) return range.upper;
  return (range.lower * (1 - share) + range.upper * (1 + share)) / 2;
}

}  // namespace

std::vector<ActionFactor> action_factors(const Structure& truss, const LimitProblem& problem,
                                         const Eigen::VectorXd& shares) {
  std::vector<ActionFactor> factors;
  for (const auto& range : truss.actions) {
    ActionFactor each{range.action, range.upper, range.reference};
    if (!range.reference && range.lower != range.upper) {
      const auto column =
          std::ranges::find(problem.uncertain, range.action, &UncertainColumn::name);
      if (column == problem.uncertain.end())
        throw std::logic_error("an action with a range of factors is no uncertain load");
      each.factor = factor_at(range, shares(column - problem.uncertain.begin()));
    }
    factors.push_back(std::move(each));
  }
  return factors;
}

}  // namespace kusabi::problems
