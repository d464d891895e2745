// The limit paper's method as printed: compared with enumeration of all vertices, by itself (no
// static cuts), stopped, started from samples (remark 4.5), with too small an M; and the dual (45)
// at nodes compared with the relaxation (42).
#include <algorithm>
#include <random>
#include <string>

#include <gtest/gtest.h>

#include "engine/transport/single_process.hpp"
#include "nodes/limit/limit_loads.hpp"
#include "nodes/limit/model/load_factor.hpp"
#include "nodes/zero_one/disjunctive_cuts.hpp"
#include "problems/families/grid_truss.hpp"
#include "problems/files/structure_file.hpp"
#include "problems/limit/dual_limit.hpp"
#include "problems/limit/mixed_limit.hpp"

namespace kusabi::limit {
namespace {

using problems::FixedTau;
using problems::LimitModel;
using problems::LimitProblem;

problems::Structure example(const std::string& name) {
  return problems::load_structure(std::string(KUSABI_SOURCE_DIR "/examples/") + name);
}

LimitAnswer answered(const problems::Structure& truss, const LimitParameters& parameters,
                     const engine::Limits& limits = {}) {
  engine::SingleProcess alone;
  engine::Analysis analysis(alone, {.limits = limits});
  return limit_loads(analysis, truss, problems::limit_problem(checked(truss)), parameters).answer;
}

/// lambda* is concave in zeta, so the least of all vertices is the worst case.
double worst_corner(const LimitProblem& problem, double alpha) {
  const auto model = problems::limit_model(problem);
  LoadFactor solver(model);
  double worst = linear::infinity;
  const auto m = static_cast<unsigned>(model.uncertain_count());
  for (unsigned corner = 0; corner < 1U << m; ++corner) {
    Eigen::VectorXd zeta(m);
    for (unsigned j = 0; j < m; ++j) {
      zeta(j) = (((corner >> j) & 1U) != 0 ? alpha : -alpha) / model.force_unit;
    }
    EXPECT_EQ(solver.solve(dead_load(model, zeta)), LoadStatus::collapses);
    worst = std::min(worst, solver.collapse().factor * model.factor_unit);
  }
  return worst;
}

struct Case {
  problems::Structure truss;
  double alpha;
  double big_m;
};

// Small enough for all vertices: 2^7, 2^9.
std::vector<Case> small_cases() {
  return {{example("static-gap.toml"), 0.35, 20},
          {example("static-gap.toml"), 0.45, 20},
          {problems::grid_truss(2), 40, 1}};
}

void expect_nothing_of_static_cuts(const LimitWorstCase& worst) {
  EXPECT_TRUE(worst.as_printed);
  EXPECT_EQ(worst.counts.pricings, 0U);
  EXPECT_EQ(worst.counts.relaxations, 0U);
  EXPECT_EQ(worst.counts.rounds, 0U);
  EXPECT_EQ(worst.cuts, 0U);
  EXPECT_EQ(worst.tree_programs, 0U);
}

TEST(PrintedMethod, FindsTheWorstVertexWithoutStaticCuts) {
  for (const auto& [truss, alpha, big_m] : small_cases()) {
    const double expected = worst_corner(problems::limit_problem(checked(truss)), alpha);
    const double near = 1e-7 * std::max(1.0, std::abs(expected));
    for (const auto method : {LimitMethod::fixed, LimitMethod::disjunctive}) {
      SCOPED_TRACE(truss.name + " " + std::to_string(alpha));
      const auto found = answered(truss, {.alpha = alpha, .method = method, .big_m = big_m});
      ASSERT_TRUE(found.worst && found.worst->zero_one);
      const auto& worst = *found.worst;
      expect_nothing_of_static_cuts(worst);
      EXPECT_NEAR(worst.ends.at_most(), expected, near);
      EXPECT_NEAR(worst.ends.at_least(), expected, near);
      EXPECT_EQ(worst.zero_one->upper, worst.ends.at_most());
      ASSERT_TRUE(worst.collapse);
      EXPECT_NEAR(worst.collapse->factor, expected, near);
      // Floating point and a given M: no proof.
      EXPECT_FALSE(worst.proved() || is_proved(worst.ends.lower) || is_proved(worst.ends.upper));
      EXPECT_FALSE(found.whole());
      EXPECT_EQ(worst.zero_one->cut_programs > 0, method == LimitMethod::disjunctive);
    }
  }
}

TEST(PrintedMethod, IsProvedAfterwardsOnRequest) {
  for (const auto& [truss, alpha, big_m] : small_cases()) {
    const auto found = answered(
        truss,
        {.alpha = alpha, .method = LimitMethod::disjunctive, .big_m = big_m, .evidence = true});
    EXPECT_TRUE(found.whole());
    EXPECT_FALSE(found.worst->as_printed);
    EXPECT_GT(found.worst->counts.pricings, 0U);
    EXPECT_NEAR(found.worst->zero_one->lower, found.worst->ends.at_least(), 1e-5);
    EXPECT_NEAR(found.worst->zero_one->upper, found.worst->ends.at_most(), 1e-5);
  }
}

// With a very small M motions are almost zero, and (29) is above the worst case.
TEST(PrintedMethod, IsCorrectedByTheProofIfMIsTooSmall) {
  const auto truss = example("static-gap.toml");
  const double expected = worst_corner(problems::limit_problem(checked(truss)), 0.35);
  const auto found = answered(
      truss, {.alpha = 0.35, .method = LimitMethod::fixed, .big_m = 0.05, .evidence = true});
  EXPECT_TRUE(found.whole());
  EXPECT_NEAR(found.worst->ends.at_most(), expected, 1e-6);
  EXPECT_GT(found.worst->zero_one->lower, expected + 0.01);
}

TEST(PrintedMethod, HasOnlyTheBoundsOfItsTreeIfStopped) {
  // tests/reference/limit.json; with M = 5 this tree takes far more nodes.
  const double truth = 37.0120;
  const auto found = answered(
      example("paper/limit-3x3.toml"),
      {.alpha = 40, .method = LimitMethod::fixed, .big_m = 5, .evidence = true}, {.nodes = 40});
  const auto& worst = *found.worst;
  EXPECT_EQ(worst.search, engine::Status::node_limit);
  expect_nothing_of_static_cuts(worst);
  // The relaxation (38) gains M/2 from each gamma.
  EXPECT_LT(worst.ends.at_least(), 0);
  EXPECT_GT(worst.ends.at_most(), truth);
  EXPECT_FALSE(found.whole());
}

TEST(PrintedMethod, StartsFromTheBestSample) {
  for (const auto& [truss, alpha, big_m] : small_cases()) {
    const LimitParameters parameters{
        .alpha = alpha, .method = LimitMethod::fixed, .big_m = big_m, .samples = 50};
    const auto found = answered(truss, parameters);
    ASSERT_EQ(found.samples.size(), 50U);
    const auto& start = found.worst->zero_one->start;
    ASSERT_TRUE(start);
    EXPECT_EQ(*start, *std::ranges::min_element(found.samples));
    EXPECT_LE(found.worst->ends.at_most(), *start);
    EXPECT_NEAR(found.worst->ends.at_most(),
                worst_corner(problems::limit_problem(checked(truss)), alpha), 1e-6);
    // Stopped before its first point, it still has that of the sample.
    const auto stopped = answered(truss, parameters, {.nodes = 1});
    EXPECT_EQ(stopped.worst->ends.at_most(), *start);
  }
}

// ---- (45) -------------------------------------------------------------------------------------

/// (42) with u and gamma free, as in the paper.
linear::MixedProgram relaxation_of(const LimitModel& model, double alpha,
                                   const Eigen::VectorXd& big_m) {
  const auto none = [](int count) { return Eigen::VectorXd::Constant(count, linear::infinity); };
  auto mixed = problems::worst_case_program(model, alpha, big_m, none(model.free_count()),
                                            none(model.member_count()));
  for (int j = 0; j < model.uncertain_count(); ++j) {
    const int gamma = model.free_count() + model.member_count() + j;
    mixed.program.columns[static_cast<std::size_t>(gamma)].lower = -linear::infinity;
  }
  return mixed;
}

std::vector<FixedTau> random_held(std::mt19937& bits, int m) {
  std::vector<FixedTau> held;
  for (int j = 0; j < m; ++j) {
    constexpr FixedTau each[] = {FixedTau::not_fixed, FixedTau::at_zero, FixedTau::at_one};
    held.push_back(each[bits() % 3]);
  }
  return held;
}

// Cuts of the optimum of the first relaxation, one for each binary that has one.
std::vector<problems::RelaxationCut> some_cuts(const linear::MixedProgram& mixed) {
  zero_one::Relaxation relaxation(mixed);
  EXPECT_EQ(relaxation.solve(relaxation.root(), {}), linear::LinearStatus::optimal);
  std::vector<problems::RelaxationCut> cuts;
  for (std::size_t k = 0; k < relaxation.binaries() && cuts.size() < 4; ++k) {
    if (std::min(relaxation.value(k), 1 - relaxation.value(k)) < 1e-6) continue;
    const auto cut =
        zero_one::deepest_cut(relaxation, mixed.program.rows.size(), relaxation.values(), k);
    if (cut) cuts.push_back({cut->terms, cut->lower});
  }
  return cuts;
}

class DualAtNodes {
 public:
  explicit DualAtNodes(const Case& of)
      : model_(problems::limit_model(problems::limit_problem(checked(of.truss)))),
        alpha_(of.alpha / model_.force_unit),
        big_m_(of.big_m * Eigen::VectorXd::Ones(model_.uncertain_count()) / model_.factor_unit) {}

  // @return true if the omitted rows were redundant there
  bool compare(const std::vector<FixedTau>& held, bool with_cuts) {
    auto mixed = relaxation_of(model_, alpha_, big_m_);
    const auto cuts = with_cuts ? some_cuts(mixed) : std::vector<problems::RelaxationCut>{};
    for (const auto& cut : cuts) mixed.program.add_row({.lower = cut.lower}, cut.terms);
    for (std::size_t j = 0; j < held.size(); ++j) {
      auto& tau = mixed.program.columns[static_cast<std::size_t>(mixed.binaries[j])];
      if (held[j] == FixedTau::at_zero) tau.upper = 0;
      if (held[j] == FixedTau::at_one) tau.lower = 1;
    }
    linear::Simplex primal(mixed.program);
    EXPECT_EQ(primal.solve_robustly(), linear::LinearStatus::optimal);
    linear::Simplex dual(problems::dual_program(model_, alpha_, big_m_, held, cuts));
    EXPECT_EQ(dual.solve_robustly(), linear::LinearStatus::optimal);
    const double near = 1e-7 * std::max(1.0, std::abs(primal.objective()));
    EXPECT_LE(-dual.objective(), primal.objective() + near);
    for (std::size_t j = 0; j < held.size(); ++j) {
      if (held[j] == FixedTau::not_fixed) continue;
      const auto values = primal.values();
      const Eigen::VectorXd motion =
          Eigen::Map<const Eigen::VectorXd>(values.data(), model_.free_count());
      if (std::abs(model_.uncertain[j].along(motion)) > 0.49 * big_m_(static_cast<Eigen::Index>(j)))
        return false;
    }
    EXPECT_NEAR(-dual.objective(), primal.objective(), near);
    return true;
  }

  [[nodiscard]] int uncertain_count() const { return model_.uncertain_count(); }

 private:
  LimitModel model_;
  double alpha_;
  Eigen::VectorXd big_m_;
};

TEST(DualProgram, HasTheOptimumOfTheRelaxationAtNodes) {
  auto cases = small_cases();
  cases.push_back({example("paper/limit-3x3.toml"), 40, 5});
  std::mt19937 bits(7);
  int compared = 0;
  for (const auto& each : cases) {
    DualAtNodes nodes(each);
    for (const bool with_cuts : {false, true}) {
      EXPECT_TRUE(nodes.compare(
          std::vector<FixedTau>(static_cast<std::size_t>(nodes.uncertain_count())), with_cuts));
      for (int k = 0; k < 6; ++k) {
        compared += nodes.compare(random_held(bits, nodes.uncertain_count()), with_cuts) ? 1 : 0;
      }
    }
  }
  EXPECT_GE(compared, 24);  // of 48
}

}  // namespace
}  // namespace kusabi::limit
