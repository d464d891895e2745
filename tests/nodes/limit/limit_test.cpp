// Worst-case limit loads compared with the printed numbers of the limit paper and with independent
// programs (tests/reference/limit.json), with enumeration of all vertices of the uncertain loads,
// and with their own exact proofs.
#include <cmath>
#include <fstream>
#include <optional>
#include <random>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "engine/search.hpp"
#include "nodes/limit/search/limit_evidence.hpp"
#include "nodes/limit/search/sign_tree.hpp"
#include "problems/families/grid_truss.hpp"
#include "problems/files/structure_file.hpp"
#include "problems/limit/collapse_mode.hpp"
#include "verify/limit/limit_proof.hpp"
#include "verify/limit/sign_cover.hpp"

namespace kusabi::limit {
namespace {

using problems::LimitModel;
using problems::LimitProblem;
using problems::Structure;
using Json = nlohmann::json;

/// The reference has at least ten digits.
constexpr double reference_digits = 1e-9;

Json reference() {
  std::ifstream stream(KUSABI_SOURCE_DIR "/tests/reference/limit.json");
  return Json::parse(stream);
}

LimitProblem example(const std::string& name) {
  return limit_problem(
      problems::load_structure(std::string(KUSABI_SOURCE_DIR "/examples/") + name));
}

/// All results of one worst case.
struct Solved {
  const LimitProblem& problem;
  LimitModel model = limit_model(problem);
  LoadFactor load_factor{model};
  StaticPricing pricing{model};
  Collapse nominal;
  RootResult root;
  std::uint64_t opened = 1;
  std::vector<ClosedNode> closed;

  // @param alpha in the unit of force
  Solved(const LimitProblem& of, double alpha) : problem(of) {
    EXPECT_EQ(load_factor.solve(model.dead), LoadStatus::collapses);
    nominal = load_factor.collapse();
    const double scaled = alpha / model.force_unit;
    root = solve_root(model, scaled, nominal, load_factor,
                      [this](const Eigen::VectorXd& z, std::span<const int> columns) {
                        return price_alone(pricing, z, columns);
                      });
    if (root.status == RootStatus::closed) closed.push_back(closed_node(root.proof, {}));
    if (root.status == RootStatus::open) search(scaled);
  }

  [[nodiscard]] double upper() const { return root.worst->collapse.factor * model.factor_unit; }

 private:
  void search(double scaled) {
    SignTree tree(model, scaled, root, true);
    engine::Options options;
    options.goal = engine::Goal::best;
    const auto outcome = engine::search(tree, options);
    opened = outcome.opened();
    closed = outcome.ranks.front().tally.evidence;
    if (outcome.solutions.empty()) return;
    const auto& best = outcome.solutions.front().solution;
    root.worst->collapse.factor = best.factor;
    const auto size = [](const auto& v) { return static_cast<Eigen::Index>(v.size()); };
    root.worst->zeta = Eigen::Map<const Eigen::VectorXd>(best.zeta.data(), size(best.zeta));
    root.worst->collapse.motion =
        Eigen::Map<const Eigen::VectorXd>(best.motion.data(), size(best.motion));
  }
};

/// The truss whose direction cosines and loads are exactly those of the solver.
verify::LimitTruss truss_in_doubles(const LimitProblem& problem, double alpha) {
  using verify::Dyadic;
  verify::LimitTruss truss;
  for (int i = 0; i < problem.member_count(); ++i) {
    auto& column = truss.columns.emplace_back();
    for (Eigen::SparseMatrix<double>::InnerIterator entry(problem.equilibrium, i); entry; ++entry)
      column.emplace_back(entry.row(), verify::Approximate{Dyadic(entry.value()), {}});
  }
  for (const double load : problem.dead) truss.dead.emplace_back(load);
  for (const double load : problem.reference) truss.reference.emplace_back(load);
  for (const auto& column : problem.uncertain) {
    auto& load = truss.uncertain.emplace_back();
    for (const auto& [degree, value] : column.direction)
      load.emplace_back(degree, column.weight * value);
    truss.alpha.push_back(alpha * column.half_width);
  }
  truss.below = truss.above = {{problem.tension.begin(), problem.tension.end()},
                               {problem.compression.begin(), problem.compression.end()}};
  truss.names.resize(truss.members());
  return truss;
}

/// The exact bracket of a solved worst case.
void expect_proved(const Solved& solved, double alpha) {
  const auto theorem = theorem_of(solved.problem, solved.model, alpha, *solved.root.worst,
                                  solved.root.cuts, solved.closed);
  const auto truss = truss_in_doubles(solved.problem, alpha);
  const verify::LimitProof proof(truss, theorem.cuts);
  EXPECT_FALSE(verify::flaw_of_sign_cover(theorem.nodes, truss.uncertain.size()));
  const auto upper = proof.upper(theorem.collapse);
  ASSERT_TRUE(std::holds_alternative<mpq_class>(upper));
  const double above = verify::rounded_up(std::get<mpq_class>(upper));
  EXPECT_NEAR(above, solved.upper(), 1e-9 * std::max(1.0, std::abs(above)));
  for (const auto& node : theorem.nodes) {
    const auto lower = proof.lower(node);
    ASSERT_TRUE(std::holds_alternative<mpq_class>(lower)) << std::get<std::string>(lower);
    EXPECT_GE(std::get<mpq_class>(lower).get_d(),
              above - 3 * closed_gap * solved.model.factor_unit);
  }
}

void expect_near(double value, double expected) {
  EXPECT_NEAR(value, expected, reference_digits * std::max(1.0, std::abs(expected)));
}

class PaperTruss : public testing::TestWithParam<const char*> {};

TEST_P(PaperTruss, HasTheFactorsOfTheReference) {
  const Json expected = reference().at("trusses").at(GetParam()).at("values");
  const LimitProblem problem = example("paper/limit-" + std::string(GetParam()) + ".toml");
  EXPECT_EQ(problem.uncertain_count(), expected.at("uncertain_components").get<int>());
  for (const auto& [alpha, factor] : expected.at("worst_case").items()) {
    const Solved solved(problem, std::stod(alpha));
    expect_near(solved.nominal.factor * solved.model.factor_unit,
                expected.at("nominal").get<double>());
    EXPECT_EQ(solved.root.status, RootStatus::closed);
    expect_near(solved.upper(), factor.get<double>());
    expect_proved(solved, std::stod(alpha));
  }
}

INSTANTIATE_TEST_SUITE_P(Limit, PaperTruss, testing::Values("3x3", "4x4"));

TEST(GridFamily, HasTheFactorsOfTheReference) {
  const Json family = reference().at("family");
  // Up to 8 bays here; larger ones are in bench_limit.
  for (int bays = 5; bays <= 8; ++bays) {
    const LimitProblem problem = limit_problem(checked(problems::grid_truss(bays)));
    const auto key = std::to_string(bays);
    for (const int alpha : {20, 40}) {
      const Solved solved(problem, alpha);
      expect_near(solved.nominal.factor * solved.model.factor_unit,
                  family.at("nominal").at(key).get<double>());
      expect_near(solved.upper(),
                  family.at("worst_case_alpha_" + std::to_string(alpha)).at(key).get<double>());
      EXPECT_EQ(solved.root.status, RootStatus::closed);
      if (bays < 7) expect_proved(solved, alpha);
    }
  }
}

// A component is a rounding error of a direction if it is small relative to those at its node.
TEST(LimitModels, KeepASmallLoadBesideAFarLargerOneAtAnotherNode) {
  auto problem = example("paper/limit-3x3.toml");
  const auto& number = problem.degrees.number;
  std::vector<int> free_nodes;
  for (int node = 0; node < number.cols(); ++node) {
    if ((number.col(node).array() >= 0).all()) free_nodes.push_back(node);
  }
  ASSERT_GE(free_nodes.size(), 2U);
  const int large = number(0, free_nodes[0]);
  const int error = number(1, free_nodes[0]);
  const int small = number(0, free_nodes[1]);
  problem.dead.setZero();
  problem.dead(large) = 1e15;
  problem.dead(error) = problem.dead(small) = 1;
  const auto model = limit_model(problem);
  EXPECT_EQ(model.dead(error), 0);
  EXPECT_GT(model.dead(small), 0);
}

TEST(CollapseModes, AreThoseOfThePaper) {
  const LimitProblem problem = example("paper/limit-3x3.toml");
  const auto sways = [&](double alpha) {
    return problems::collapse_mode(problem, Solved(problem, alpha).root.worst->collapse.motion)
        .along_reference;
  };
  EXPECT_TRUE(sways(0));
  EXPECT_TRUE(sways(20));
  EXPECT_FALSE(sways(40));
}

/// The least factor over all vertices of the loads: lambda* is concave in zeta, so its minimum over
/// the box is at a vertex. Nothing if a vertex has no factor.
std::optional<double> min_over_corners(const LimitModel& model, double alpha) {
  LoadFactor load_factor(model);
  const int m = model.uncertain_count();
  double minimum = std::numeric_limits<double>::infinity();
  for (unsigned corner = 0; corner < 1U << static_cast<unsigned>(m); ++corner) {
    Eigen::VectorXd zeta(m);
    for (int j = 0; j < m; ++j) {
      zeta(j) = ((corner >> static_cast<unsigned>(j)) & 1U) != 0 ? alpha : -alpha;
    }
    if (load_factor.solve(dead_load(model, zeta)) != LoadStatus::collapses) return {};
    minimum = std::min(minimum, load_factor.collapse().factor);
  }
  return minimum;
}

/// A random truss in the plane or in space, with some cables, with one or two reference loads;
/// nothing if it is a mechanism.
std::optional<LimitProblem> random_truss(std::mt19937& bits) {
  const auto number = [&](double from, double to) {
    return from + (to - from) * (static_cast<double>(bits()) * 0x1p-32);
  };
  Structure truss;
  truss.name = "random";
  const int d = truss.dimension = bits() % 4 == 0 ? 3 : 2;
  truss.units = {"m", "kN"};
  const int nodes = 6;
  truss.coordinates.resize(d, nodes);
  for (int node = 0; node < nodes; ++node) {
    for (int axis = 0; axis < d; ++axis) truss.coordinates(axis, node) = number(0, 3);
    truss.node_names.push_back(std::to_string(node));
    truss.fixed.push_back(node < d ? std::array{true, true, true} : std::array<bool, 3>{});
  }
  for (int first = 0; first < nodes; ++first) {
    for (int second = first + 1; second < nodes; ++second) {
      if (number(0, 1) > 0.85) continue;
      const double tension = number(0.3, 1);
      const double compression = bits() % 3 == 0 ? tension * number(0, 1) : tension;
      truss.members.push_back(
          {.first = first, .second = second, .yield = problems::YieldForces{tension, compression}});
    }
  }
  const auto load = [&](problems::Load::Kind kind, int node) {
    Eigen::VectorXd force = Eigen::VectorXd::Zero(d);
    force(static_cast<int>(bits() % static_cast<unsigned>(d))) = number(-1, 1);
    truss.loads.push_back({kind, node, force});
  };
  load(problems::Load::Kind::reference, nodes - 1);
  if (bits() % 2 == 0) load(problems::Load::Kind::reference, nodes - 2);
  load(problems::Load::Kind::dead, nodes - 3);
  try {
    return limit_problem(checked(truss));
  } catch (const support::InputError&) {
    return {};
  }
}

TEST(RandomTrusses, HaveTheLeastFactorOfAllVertices) {
  std::mt19937 bits(7);  // NOLINT(cert-msc32-c,cert-msc51-cpp): repeatable on purpose
  int compared = 0;
  int not_carried = 0;
  for (int trial = 0; trial < 60; ++trial) {
    const auto problem = random_truss(bits);
    const double alpha = 0.02 + 0.2 * (static_cast<double>(bits()) * 0x1p-32);
    if (!problem || problem->uncertain_count() > 8) continue;
    const LimitModel model = limit_model(*problem);
    LoadFactor load_factor(model);
    if (load_factor.solve(model.dead) != LoadStatus::collapses) continue;
    const Solved solved(*problem, alpha);
    const auto minimum = min_over_corners(model, alpha / model.force_unit);
    if (!minimum) {
      EXPECT_EQ(solved.root.status, RootStatus::not_carried) << trial;
      ++not_carried;
      continue;
    }
    EXPECT_NEAR(solved.root.worst->collapse.factor, *minimum, closed_gap) << trial;
    expect_proved(solved, alpha);
    ++compared;
  }
  EXPECT_GE(compared, 15);
  EXPECT_GE(not_carried, 3);
}

TEST(StaticCuts, LeaveAGapThatTheTreeCloses) {
  // A counterexample to the sufficiency of static cuts.
  const LimitProblem problem = example("static-gap.toml");
  const double alpha = 0.45;
  const Solved solved(problem, alpha);
  EXPECT_EQ(solved.root.status, RootStatus::open);
  EXPECT_LT(solved.root.lower * solved.model.factor_unit, solved.upper() - 0.05);
  EXPECT_GT(solved.opened, 1U);
  const auto minimum = min_over_corners(solved.model, alpha / solved.model.force_unit);
  EXPECT_NEAR(solved.root.worst->collapse.factor, minimum.value(), closed_gap);
  expect_proved(solved, alpha);
}

TEST(StaticAndKinematicProgram, HaveTheSameOptimum) {
  const LimitModel model = limit_model(example("paper/limit-4x4.toml"));
  linear::Simplex below(static_program(model, model.dead));
  linear::Simplex above(kinematic_program(model, model.dead));
  ASSERT_EQ(below.solve_robustly(), linear::LinearStatus::optimal);
  ASSERT_EQ(above.solve_robustly(), linear::LinearStatus::optimal);
  EXPECT_NEAR(-below.objective(), above.objective(), 1e-12);
}

TEST(LoadFactor, OfTwoBarsIsThatOfTheHandCalculation) {
  // A node on a horizontal and a vertical bar: lambda is the yield force along x.
  Structure truss;
  truss.name = "two bars";
  truss.dimension = 2;
  truss.units = {"m", "kN"};
  truss.coordinates.resize(2, 3);
  truss.coordinates << 0, 1, 1, 0, 1, 0;
  truss.node_names = {"left", "top", "tip"};
  truss.fixed = {{true, true, false}, {true, true, false}, {false, false, false}};
  truss.members = {{.first = 0, .second = 2, .yield = problems::YieldForces{3, 2}},
                   {.first = 1, .second = 2, .yield = problems::YieldForces{5, 5}}};
  truss.loads = {{problems::Load::Kind::reference, 2, Eigen::Vector2d(1, 0)}};
  const auto factor = [&](const Eigen::Vector2d& dead) -> std::optional<double> {
    auto loaded = truss;
    loaded.loads.push_back({problems::Load::Kind::dead, 2, dead});
    const LimitModel model = limit_model(limit_problem(checked(loaded)));
    LoadFactor solver(model);
    if (solver.solve(model.dead) != LoadStatus::collapses) return {};
    return solver.collapse().factor * model.factor_unit;
  };
  EXPECT_NEAR(factor({0, 0}).value(), 3, 1e-12);
  EXPECT_NEAR(factor({-1, 0}).value(), 4, 1e-12);
  EXPECT_NEAR(factor({4, 0}).value(), -1, 1e-12);  // the dead load alone collapses it
  EXPECT_FALSE(factor({0, 6}));                    // no factor
  truss.loads[0].force *= -1;                      // now the bar yields in compression
  EXPECT_NEAR(factor({0, 0}).value(), 2, 1e-12);
}

}  // namespace
}  // namespace kusabi::limit
