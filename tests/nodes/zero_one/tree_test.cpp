// The zero-one tree: small programs with known optima, random ones against all values of their
// binaries, and the bound that must never be above the optimum.
#include "nodes/zero_one/tree.hpp"

#include <cmath>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/nodes/zero_one/programs.hpp"

namespace kusabi::nodes {
namespace {

using tests::by_brute_force;
using tests::random_mixed;
using tests::satisfies;

struct Solved {
  std::optional<ZeroOnePoint> point;
  double bound = 0;
  ZeroOneTally tally;
  std::uint64_t opened = 0;
};

Solved solved(const problems::MixedProgram& mixed, const ZeroOneRootOptions& options = {},
              ZeroOneBranching branching = ZeroOneBranching::look_ahead) {
  ZeroOneTree tree(prepare_root(mixed, options), branching);
  engine::Options search;
  search.goal = engine::Goal::best;
  const auto outcome = engine::search(tree, search);
  Solved result{.point = {}, .tally = outcome.ranks[0].tally, .opened = outcome.opened()};
  if (!outcome.solutions.empty()) result.point = outcome.solutions[0].solution;
  result.bound = tree.lower_bound(outcome.bound, result.tally);
  return result;
}

TEST(ZeroOneTree, FindsWhatTryingAllBinariesFinds) {
  int with_points = 0;
  int without = 0;

  for (int kind = 0; kind < 5; ++kind) {
    for (unsigned seed = 0; seed < 20; ++seed) {
      const auto mixed = random_mixed(seed, kind, 8);
      const auto expected = by_brute_force(mixed);
      const auto found = solved(mixed);
      ASSERT_EQ(found.point.has_value(), expected.has_value()) << kind << " " << seed;

      ++(expected ? with_points : without);
      if (!expected) continue;
      EXPECT_NEAR(found.point->objective, *expected, 1e-7) << kind << " " << seed;
      EXPECT_TRUE(satisfies(mixed, found.point->values)) << kind << " " << seed;
      EXPECT_LE(found.bound, *expected) << kind << " " << seed;
      EXPECT_NEAR(found.bound, *expected, 1e-6) << kind << " " << seed;
    }
  }
  EXPECT_GT(with_points, 50);
  EXPECT_GT(without, 5);
}

}  // namespace
}  // namespace kusabi::nodes
