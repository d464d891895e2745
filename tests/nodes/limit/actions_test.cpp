// Combinations of actions: the box of each leading action compared with all its combinations.
#include <algorithm>
#include <limits>
#include <string>
#include <vector>

#include <gmock/gmock.h>

#include "nodes/limit/limit_loads.hpp"
#include "problems/files/structure_file.hpp"
#include "problems/limit/half_widths.hpp"
#include "problems/structure/model/load_cases.hpp"
#include "tests/nodes/limit/plain_truss.hpp"

namespace kusabi::limit {
namespace {

using problems::Structure;

struct Action {
  std::vector<std::string> nodes;
  double x;
  double y;
};

const Action roof{{"t1", "t2", "t3"}, 0, -14};
const Action ceiling{{"b1", "b2", "b3"}, 0, -6};
const Action snow{{"t1", "t2", "t3"}, 0, -20};
const Action imposed{{"b1", "b2", "b3"}, 0, -15};
const Action wind{{"t1", "t2", "t3"}, 3, 24};

void add(Structure& truss, const Action& action, double factor, problems::Load::Kind kind) {
  for (const auto& name : action.nodes) {
    const auto found = std::ranges::find(truss.node_names, name);
    truss.loads.push_back({kind, static_cast<int>(found - truss.node_names.begin()),
                           Eigen::Vector2d(factor * action.x, factor * action.y)});
  }
}

// The least factor of snow over all choices of favourable and unfavourable factors, each by a
// program (5) of its own.
double min_factor_by_choices(const Structure& truss, double reference, double max_imposed,
                             double max_wind) {
  double minimum = std::numeric_limits<double>::infinity();
  for (int choice = 0; choice < 16; ++choice) {
    Structure one = truss;
    one.loads.clear();
    one.uncertain.emplace();
    const auto dead = problems::Load::Kind::dead;
    add(one, roof, (choice & 1) != 0 ? 1.35 : 1.0, dead);
    add(one, ceiling, (choice & 2) != 0 ? 1.35 : 1.0, dead);
    add(one, imposed, (choice & 4) != 0 ? max_imposed : 0, dead);
    add(one, wind, (choice & 8) != 0 ? max_wind : 0, dead);
    add(one, snow, reference, problems::Load::Kind::reference);
    const auto factor = test::PlainTruss(one).factor(Eigen::VectorXd());
    EXPECT_TRUE(factor) << choice;
    if (factor) minimum = std::min(minimum, *factor);
  }
  return minimum;
}

double min_factor_by_box(const Structure& truss, const std::string& load_case) {
  const Structure of_case = problems::in_load_case(truss, load_case);
  auto problem = problems::limit_problem(checked(of_case));
  problems::LimitProblem* const one = &problem;
  const auto alpha = problems::set_half_widths({&one, 1}, {});
  engine::SingleProcess alone;
  engine::Analysis analysis(alone);
  const auto answer = limit_loads(analysis, of_case, problem, {.alpha = alpha}).answer;
  EXPECT_TRUE(answer.worst);
  EXPECT_NEAR(answer.worst->ends.at_least(), answer.worst->ends.at_most(), 1e-6);
  return answer.worst->ends.at_most();
}

TEST(Actions, BoxOfALeadingActionCoversAllItsCombinations) {
  const auto truss = problems::load_structure(KUSABI_SOURCE_DIR "/examples/roof-truss.toml");
  ASSERT_THAT(problems::load_cases(truss),
              testing::ElementsAre("6.10 snow leads", "6.10 imposed leads", "6.10 wind leads"));
  EXPECT_NEAR(min_factor_by_box(truss, "6.10 snow leads"),
              min_factor_by_choices(truss, 1.5, 1.5 * 0.7, 1.5 * 0.6), 1e-6);
  EXPECT_NEAR(min_factor_by_box(truss, "6.10 imposed leads"),
              min_factor_by_choices(truss, 0.75, 1.5, 1.5 * 0.6), 1e-6);
  EXPECT_NEAR(min_factor_by_box(truss, "6.10 wind leads"),
              min_factor_by_choices(truss, 0.75, 1.5 * 0.7, 1.5), 1e-6);
}

}  // namespace
}  // namespace kusabi::limit
