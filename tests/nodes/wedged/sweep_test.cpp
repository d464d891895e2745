// Counts over friction: compared with an enumeration at each coefficient, and combined from
// histories by hand.
#include <cmath>
#include <cstdint>
#include <initializer_list>
#include <numeric>
#include <set>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "engine/analysis/analysis.hpp"
#include "engine/simulation.hpp"
#include "engine/transport/single_process.hpp"
#include "nodes/wedged/pattern_search.hpp"
#include "nodes/wedged/sweep/sweep_search.hpp"
#include "nodes/wedged/tree/candidate_friction.hpp"
#include "problems/files/problem_text.hpp"
#include "problems/files/structure_file.hpp"
#include "random_structure.hpp"
#include "support/input_error.hpp"

namespace kusabi::wedged {
namespace {

constexpr double width = 1e-8;

/// Block, S and G.
using Cones = std::set<std::tuple<std::uint32_t, support::IndexSet, support::IndexSet>>;

problems::WedgedProblem problem_in(const std::string& file) {
  const std::string path = KUSABI_SOURCE_DIR "/" + file;
  return problems::wedged_problem(problems::read_structure(problems::problem_text(path), path));
}

problems::WedgedProblem example(const std::string& name) {
  return problem_in("examples/" + name);
}

SweepFindings swept(const problems::WedgedProblem& problem, double maximum) {
  engine::SingleProcess alone;
  engine::Analysis analysis(alone, {});
  return sweep_friction(analysis, problem, {.maximum = maximum, .width = width});
}

Cones maximal_at(const SweepFindings& findings, double friction) {
  Cones cones;
  for (const auto& cone : findings.cones) {
    const bool over = cone.absorbed && cone.absorbed->upper <= friction;
    if (cone.begins.upper <= friction && !over)
      cones.emplace(cone.block, cone.pattern.contact, cone.pattern.separated);
  }
  return cones;
}

void expect_as_enumerated(const problems::WedgedProblem& problem, const SweepFindings& findings,
                          double friction) {
  engine::SingleProcess alone;
  engine::Analysis analysis(alone, {});
  const auto own = find_patterns(analysis, problem, candidate_friction(problem, friction));
  ASSERT_EQ(own.unresolved(), 0U);
  const auto count = findings.count_at(friction);
  EXPECT_TRUE(count.exact()) << friction;
  EXPECT_EQ(count.known, own.count()) << friction;
  Cones cones;
  for (const auto& leaf : own.leaves)
    cones.emplace(leaf.block, leaf.pattern.contact, leaf.pattern.separated);
  EXPECT_EQ(maximal_at(findings, friction), cones) << friction;
}

// At its own coefficient this flat leaf is feasible to Newton's method and infeasible by its
// relative interior.
TEST(FrictionSweep, CountsNoFlatConeThatLiesInAnother) {
  const auto problem = problem_in("tests/nodes/wedged/cases/normals_in_balance.toml");
  for (const double maximum : {1.70468, 2.43526, 3.65289}) {
    const auto findings = swept(problem, maximum);
    EXPECT_TRUE(findings.answered());
    expect_as_enumerated(problem, findings, maximum);
    EXPECT_EQ(findings.count_at(maximum).known, 4U);
  }
}

TEST(FrictionSweep, AgreesWithAnEnumerationAtEachCoefficient) {
  for (const auto* name : {"plane-truss.toml", "space-truss.toml", "elastic-body.toml",
                           "wedge-in-groove.toml", "peg-in-hole.toml", "two-bars.toml"}) {
    SCOPED_TRACE(name);
    const auto problem = example(name);
    const auto findings = swept(problem, 0.93);
    EXPECT_TRUE(findings.answered());
    for (const double friction : {0.13, 0.33, 0.53, 0.73, 0.93})
      expect_as_enumerated(problem, findings, friction);
  }
}

// Components, right angles and rods: cones with inactive candidates, some of which become part of
// larger ones as friction grows.
TEST(FrictionSweep, CountsFlatConesUntilALargerConeContainsThem) {
  std::size_t flat = 0;
  std::size_t absorbed = 0;
  for (const int dimension : {2, 3}) {
    for (std::uint64_t seed = 1; seed <= 100; ++seed) {
      SCOPED_TRACE(::testing::Message() << dimension << " " << seed);
      problems::WedgedProblem problem;
      try {
        problem = problems::wedged_problem(checked(random_structure(dimension, seed)));
      } catch (const support::InputError&) {  // a mechanism
        continue;
      }
      const auto findings = swept(problem, 2.71);
      EXPECT_TRUE(findings.answered());
      for (const auto& cone : findings.cones) {
        flat += cone.solid() ? 0 : 1;
        absorbed += cone.absorbed ? 1 : 0;
      }
      for (const double friction : {0.613, 1.171, 2.71})
        expect_as_enumerated(problem, findings, friction);
      for (const auto& [from, to, known, open] : findings.staircase()) {
        const auto count = findings.count_at(std::midpoint(from, to));
        EXPECT_EQ(count.known, known) << from;
        EXPECT_EQ(count.unresolved, open) << from;
      }
    }
  }
  EXPECT_GT(flat, 20U);
  EXPECT_GT(absorbed, 2U);
}

// Two bars at 45 degrees, whose tip sticks from a decimal coefficient on.
TEST(FrictionSweep, BracketsTheCoefficientAtWhichAPatternBecomesFeasible) {
  const auto findings = swept(example("two-bars.toml"), 3);
  ASSERT_EQ(findings.cones.size(), 1U);
  const auto& begins = findings.cones.front().begins;
  EXPECT_LT(begins.lower, 2);
  EXPECT_GT(begins.upper, 2);
  EXPECT_FALSE(findings.count_at(2).exact());
  EXPECT_TRUE(findings.count_at(begins.lower).exact());
  EXPECT_EQ(findings.count_at(begins.lower).known, 0U);
  EXPECT_TRUE(findings.count_at(begins.upper).exact());
  EXPECT_EQ(findings.count_at(begins.upper).known, 1U);
}

TEST(FrictionSweep, IsTheSameOnAnyNumberOfRanks) {
  const auto problem = example("plane-truss.toml");
  const std::int64_t maximum = std::llround(0.9 / width);
  SignPatternTree tree(problem, candidate_friction(problem, 0.9));
  std::vector<SweepTree::Leaf> leaves;
  for (const auto& found : engine::search(tree).solutions) {
    leaves.push_back({.place = {.block = 0, .pattern = found.solution.pattern},
                      .stage = {LeafStage::Kind::solid, {}, {}}});
  }
  ASSERT_GT(leaves.size(), 5U);
  const auto histories = [](const auto& solutions) {
    std::set<std::tuple<std::uint32_t, std::int64_t, std::int64_t>> cells;
    for (const auto& [path, solution] : solutions) {
      for (const auto& change : solution.history.changes)
        cells.emplace(solution.number, change.before, change.after);
    }
    return cells;
  };
  SweepTree alone(problem, width, maximum, leaves);
  const auto expected = histories(engine::search(alone).solutions);
  EXPECT_EQ(expected.size(), leaves.size());
  for (const int ranks : {2, 5}) {
    const auto many = engine::simulate(SweepTree(problem, width, maximum, leaves), ranks, 3);
    EXPECT_EQ(histories(many.outcome.solutions), expected);
  }
}

support::IndexSet set_of(std::initializer_list<int> members) {
  support::IndexSet set;
  for (const int each : members) set |= support::IndexSet::single(each);
  return set;
}

LeafStage flat(std::initializer_list<int> loaded, std::initializer_list<int> moved) {
  return {LeafStage::Kind::flat, set_of(loaded), set_of(moved)};
}

// A cone of two leaves becomes feasible with the first of them, and ends when a third becomes
// solid.
TEST(FrictionSweep, CombinesHistoriesOfLeaves) {
  const LeafStage solid{LeafStage::Kind::solid, {}, {}};
  SweepFindings findings;
  findings.enumerated = true;
  findings.maximum = 100;
  findings.blocks = 1;
  const SignPattern both{set_of({0, 1}), set_of({2}), {}};
  const SignPattern one{set_of({0}), set_of({1, 2}), {}};
  add_histories(findings,
                {{0, both, LeafHistory{.changes = {{20, 22, flat({0}, {2})}, {40, 41, solid}}}},
                 {0, one, LeafHistory{.changes = {{10, 11, flat({0}, {2})}}}},
                 {0, one, LeafHistory{.changes = {}, .open_above = 70}}},
                {set_of({0, 1, 2})}, FrictionGrid(1));
  ASSERT_EQ(findings.cones.size(), 2U);
  const auto& first = findings.cones[0];
  EXPECT_EQ(first.pattern.inactive, set_of({1}));
  EXPECT_EQ(first.begins.upper, 11);
  ASSERT_TRUE(first.absorbed);
  EXPECT_EQ(first.absorbed->lower, 40);
  const auto at = [&](double friction) {
    const auto count = findings.count_at(friction);
    return std::pair(count.known.number().value(), count.unresolved);
  };
  EXPECT_EQ(at(10), std::pair(std::uint64_t{0}, std::size_t{0}));
  EXPECT_EQ(at(11), std::pair(std::uint64_t{1}, std::size_t{0}));
  EXPECT_EQ(at(21), std::pair(std::uint64_t{1}, std::size_t{0}));
  EXPECT_EQ(at(40.5), std::pair(std::uint64_t{0}, std::size_t{2}));
  EXPECT_EQ(at(41), std::pair(std::uint64_t{1}, std::size_t{0}));
  EXPECT_EQ(at(70), std::pair(std::uint64_t{1}, std::size_t{0}));
  EXPECT_EQ(at(71), std::pair(std::uint64_t{1}, std::size_t{1}));
  const auto stairs = findings.staircase();
  ASSERT_EQ(stairs.size(), 4U);
  for (const auto& [from, to, known, open] : stairs)
    EXPECT_EQ(at(std::midpoint(from, to)), std::pair(*known.number(), open)) << from;
  EXPECT_EQ(stairs[1].from, 11);
  EXPECT_EQ(stairs[1].to, 40);
  EXPECT_EQ(stairs[1].known, 1U);
  EXPECT_EQ(stairs[3].to, 100);
  EXPECT_EQ(stairs[3].unresolved, 1U);
}

}  // namespace
}  // namespace kusabi::wedged
