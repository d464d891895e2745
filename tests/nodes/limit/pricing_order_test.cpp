// The order of the pricing programs compared with distances between all pairs, from the members of
// a grid.
#include "nodes/limit/root/pricing_order.hpp"

#include <algorithm>
#include <vector>

#include <gtest/gtest.h>

#include "problems/families/grid_truss.hpp"
#include "problems/limit/limit_problem.hpp"

namespace kusabi::limit {
namespace {

constexpr int unreachable = 1000;

// Steps between free displacements along one axis, by members that resist both (Floyd-Warshall
// algorithm).
std::vector<std::vector<int>> steps_between(const problems::Structure& truss,
                                            const problems::LimitProblem& problem) {
  const auto n = static_cast<std::size_t>(problem.free_count());
  std::vector steps(n, std::vector<int>(n, unreachable));
  for (std::size_t e = 0; e < n; ++e) steps[e][e] = 0;
  for (const auto& member : truss.members) {
    for (int axis = 0; axis < truss.dimension; ++axis) {
      const int first = problem.degrees.number(axis, member.first);
      const int second = problem.degrees.number(axis, member.second);
      const double along =
          truss.coordinates(axis, member.first) - truss.coordinates(axis, member.second);
      if (first < 0 || second < 0 || along == 0) continue;
      const auto a = static_cast<std::size_t>(first);
      const auto b = static_cast<std::size_t>(second);
      steps[a][b] = steps[b][a] = 1;
    }
  }
  for (std::size_t k = 0; k < n; ++k) {
    for (std::size_t a = 0; a < n; ++a) {
      for (std::size_t b = 0; b < n; ++b) {
        steps[a][b] = std::min(steps[a][b], steps[a][k] + steps[k][b]);
      }
    }
  }
  return steps;
}

TEST(PricingOrder, GoesFromEachLoadToTheNearestThatIsLeft) {
  const auto truss = problems::grid_truss(5);
  const auto problem = limit_problem(checked(truss));
  const auto model = limit_model(problem);
  const auto steps = steps_between(truss, problem);
  const auto degree = [&](int column) {
    return static_cast<std::size_t>(
        model.uncertain[static_cast<std::size_t>(column)].direction.front().degree);
  };
  const PricingOrder order(model);
  for (const int every : {1, 3}) {
    std::vector<int> left;
    for (int j = 2; j < model.uncertain_count(); j += every) left.push_back(j);
    int here = left.front();
    for (const int next : order.walk(left)) {
      const auto distance = [&](int j) {
        return std::min(unreachable, steps[degree(here)][degree(j)]);
      };
      EXPECT_EQ(next, *std::ranges::min_element(left, {}, distance)) << "after " << here;
      ASSERT_EQ(std::erase(left, next), 1U);
      here = next;
    }
    EXPECT_TRUE(left.empty());
  }
}

}  // namespace
}  // namespace kusabi::limit
