// Zero-one tree: small programs with known optima, random ones compared with enumeration of their
// binaries for all options, bounds that must never be above the optimum, and the same answer on
// simulated ranks.
#include "nodes/zero_one/tree.hpp"

#include <cmath>
#include <fstream>
#include <limits>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "engine/search.hpp"
#include "solvers/linear/program_file.hpp"
#include "support/input_error.hpp"
#include "tests/nodes/zero_one/programs.hpp"

namespace kusabi::zero_one {
namespace {

using tests::by_brute_force;
using tests::random_mixed;
using tests::satisfies;

struct Solved {
  std::optional<ZeroOnePoint> point;
  double bound = 0;
  bool proved = false;
  ZeroOneTally tally;
};

struct Way {
  ZeroOneRootOptions root = {};
  ZeroOneBranching branching = ZeroOneBranching::paper;
  engine::Order order = engine::Order::depth_first;
};

Solved solved(const linear::MixedProgram& mixed, const Way& way = {}) {
  ZeroOneTree tree(prepare_root(mixed, way.root), way.branching);
  engine::Options search;
  search.goal = engine::Goal::best;
  search.order = way.order;
  const auto outcome = engine::search(tree, search);
  Solved result{.point = {}, .proved = tree.proves(), .tally = outcome.ranks[0].tally};
  if (!outcome.solutions.empty()) result.point = outcome.solutions[0].solution;
  result.bound = tree.lower_bound(outcome.bound, result.tally);
  return result;
}

std::string program_path(const std::string& name) {
  return std::string(KUSABI_SOURCE_DIR) + "/tests/" + name;
}

TEST(ZeroOneTree, SolvesProgramsWithKnownOptima) {
  const std::vector<std::pair<std::string, std::optional<double>>> known{
      {"knapsack.lp", 220}, {"budget.lp", 42},     {"stations.lp", 2},  {"assignment.mps", 5},
      {"warehouses.lp", 9}, {"two-pipes.lp", 20},  {"odd-cycle.lp", 2}, {"coins.lp", 2},
      {"parity.lp", {}},    {"farther-end.lp", -4}};
  for (const auto& [name, optimum] : known) {
    const auto file = linear::read_program(program_path("programs/" + name));
    const double sense = file.maximise ? -1 : 1;
    const auto tried = by_brute_force(file.mixed);
    ASSERT_EQ(tried.has_value(), optimum.has_value()) << name;
    for (const auto& way :
         {Way{}, Way{.root = {.cuts = ZeroOneCuts::disjunctive, .tighten = false, .dive = false},
                 .branching = ZeroOneBranching::look_ahead}}) {
      const auto found = solved(file.mixed, way);
      ASSERT_EQ(found.point.has_value(), optimum.has_value()) << name;
      if (!optimum) continue;
      EXPECT_NEAR(sense * *tried, *optimum, 1e-9) << name;
      EXPECT_NEAR(sense * found.point->objective, *optimum, 1e-9) << name;
      EXPECT_TRUE(satisfies(file.mixed, found.point->values)) << name;
      EXPECT_TRUE(found.proved) << name;
    }
  }
}

// v^U of remark 4.5: a number above the objective of a known point.
TEST(ZeroOneTree, StartsFromAnIncumbent) {
  for (unsigned seed = 0; seed < 10; ++seed) {
    const auto mixed = random_mixed(seed, 2, 8);
    const auto without =
        solved(mixed, {.root = {.tighten = false, .dive = false, .as_printed = true}});
    if (!without.point) continue;
    for (const double above : {0.0, 0.5}) {
      auto incumbent = *without.point;
      incumbent.objective += above;
      const auto with = solved(
          mixed,
          {.root = {.tighten = false, .dive = false, .incumbent = incumbent, .as_printed = true}});
      ASSERT_TRUE(with.point);
      EXPECT_NEAR(with.point->objective, without.point->objective, 1e-8);
      EXPECT_NEAR(with.bound, without.bound, 1e-6);
      EXPECT_LE(with.tally.programs, without.tally.programs);
    }
  }
}

TEST(ZeroOneTree, AgreesWithAnEnumerationOfAllBinaries) {
  int with_points = 0;
  int without = 0;
  const std::vector<Way> ways{
      {},
      {.root = {.tighten = false, .dive = false}, .branching = ZeroOneBranching::look_ahead},
      {.root =
           {.cuts = ZeroOneCuts::disjunctive, .tighten = false, .dive = false, .as_printed = true}},
      {.root = {.cuts = ZeroOneCuts::disjunctive}, .order = engine::Order::best_first},
      {.root = {.cuts = ZeroOneCuts::disjunctive, .tighten = false, .dive = false},
       .branching = ZeroOneBranching::look_ahead,
       .order = engine::Order::hybrid}};
  for (int kind = 0; kind < 5; ++kind) {
    for (unsigned seed = 0; seed < 14; ++seed) {
      const auto mixed = random_mixed(seed, kind, 8);
      const auto expected = by_brute_force(mixed);
      ++(expected ? with_points : without);
      for (std::size_t w = 0; w < ways.size(); ++w) {
        SCOPED_TRACE(testing::Message() << "kind " << kind << " seed " << seed << " way " << w);
        const auto found = solved(mixed, ways[w]);
        ASSERT_EQ(found.point.has_value(), expected.has_value());
        if (!expected) continue;
        EXPECT_NEAR(found.point->objective, *expected, 1e-7);
        EXPECT_TRUE(satisfies(mixed, found.point->values));
        EXPECT_LE(found.bound, *expected + (found.proved ? 0 : 1e-9));
        EXPECT_NEAR(found.bound, *expected, 1e-6);
        // Columns without bounds are the only reason for missing proofs.
        EXPECT_TRUE(found.proved || kind == 4);
      }
    }
  }
  EXPECT_GT(with_points, 30);
  EXPECT_GT(without, 5);
}

TEST(ZeroOneTree, DoesNotDependOnNodesOpenedBefore) {
  const auto mixed = random_mixed(3, 0, 24);
  ZeroOneTree used(prepare_root(mixed, {.tighten = false, .dive = false}));
  const auto search = [](ZeroOneTree& tree) {
    engine::Options options;
    options.goal = engine::Goal::best;
    return engine::search(tree, options);
  };
  const auto first = search(used);
  const auto second = search(used);
  ASSERT_EQ(first.solutions.size(), 1U);
  EXPECT_EQ(first.solutions[0].path, second.solutions[0].path);
  EXPECT_EQ(first.solutions[0].solution.values, second.solutions[0].solution.values);
  EXPECT_EQ(first.fingerprint(), second.fingerprint());
  EXPECT_GT(first.opened(), 10U);
}

TEST(ZeroOneTree, SolvesProgramsWithoutRowsOrWithoutBinaries) {
  linear::MixedProgram free;
  free.binaries = {free.program.add_column({.cost = -2, .upper = 1}),
                   free.program.add_column({.cost = 3, .upper = 1})};
  free.program.constant = 10;
  EXPECT_NEAR(solved(free).point->objective, 8, 1e-9);
  linear::MixedProgram linear_only;
  const int x = linear_only.program.add_column({.cost = 1});
  linear_only.program.add_row({.lower = 2.5}, {{{x, 1}}});
  EXPECT_NEAR(solved(linear_only).point->objective, 2.5, 1e-9);
}

TEST(ZeroOneTree, RefusesInvalidBinaries) {
  auto mixed = random_mixed(0, 0, 4);
  mixed.program.columns[2].upper = 2;
  EXPECT_THROW(Relaxation{mixed}, std::invalid_argument);
  mixed.program.columns[2].upper = 1;
  mixed.binaries.push_back(0);
  EXPECT_THROW(Relaxation{mixed}, std::invalid_argument);
}

TEST(ProgramFile, IsRefusedWithItsMessageIfMalformed) {
  int files = 0;
  for (const auto& entry : std::filesystem::directory_iterator(program_path("bad-programs"))) {
    ++files;
    std::ifstream stream(entry.path());
    std::string expected;
    std::getline(stream, expected);
    expected = expected.substr(expected.find("expect: ") + 8);
    const auto gap = expected.find("...");  // GLPK's own text
    try {
      linear::read_program(entry.path());
      ADD_FAILURE() << entry.path() << " was read";
    } catch (const support::InputError& error) {
      std::string said = error.what();
      said = said.substr(said.find(entry.path().filename().string()));
      if (gap == std::string::npos) {
        EXPECT_EQ(said, expected);
      } else {
        EXPECT_THAT(said, testing::StartsWith(expected.substr(0, gap)));
        EXPECT_THAT(said, testing::EndsWith(expected.substr(gap + 3)));
        EXPECT_GT(said.size(), expected.size()) << "GLPK's words are missing";
        EXPECT_EQ(said.find('\n'), std::string::npos);
      }
    }
  }
  EXPECT_GT(files, 5);
}

}  // namespace
}  // namespace kusabi::zero_one
