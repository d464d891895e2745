// Searches in one process: counts that are known, the canonical order, and errors.
#include "engine/search.hpp"

#include <numeric>

#include <boost/serialization/vector.hpp>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/engine/queens.hpp"
#include "tests/engine/random_tree.hpp"

namespace kusabi::engine {
namespace {

using examples::Queens;
using examples::RandomTree;

// The published numbers of solutions (OEIS A000170).
TEST(Search, FindsAllPlacementsOfQueens) {
  const std::vector<std::size_t> known{1, 1, 0, 0, 2, 10, 4, 40, 92, 352};
  for (int size = 0; size < static_cast<int>(known.size()); ++size) {
    Queens queens(size);
    EXPECT_EQ(search(queens).solutions.size(), known[static_cast<std::size_t>(size)]) << size;
  }
}

TEST(Search, ReportsSolutionsInDepthFirstOrder) {
  Queens queens(6);
  const auto outcome = search(queens);
  std::vector<std::vector<int>> boards;
  for (const auto& found : outcome.solutions) boards.push_back(found.solution.columns);
  // The tree's order is the lexicographic order of the boards.
  EXPECT_TRUE(std::is_sorted(boards.begin(), boards.end()));
  EXPECT_EQ(boards.front(), (std::vector<int>{1, 3, 5, 0, 2, 4}));
}

// A recursion that shares nothing with the engine but the tree's definition.
struct Recount {
  std::uint64_t nodes = 0;
  std::uint64_t fingerprint = 0;
  std::vector<Path> solutions;

  void queens(int size, std::vector<int>& columns, Path& path, std::uint64_t mark) {
    ++nodes;
    fingerprint += mark;
    const int row = static_cast<int>(columns.size());
    if (row == size) {
      solutions.push_back(path);
      return;
    }
    std::uint32_t branch = 0;
    for (int column = 0; column < size; ++column) {
      bool free = true;
      for (int above = 0; above < row; ++above) {
        const int other = columns[static_cast<std::size_t>(above)];
        free = free && other != column && std::abs(other - column) != row - above;
      }
      if (!free) continue;
      columns.push_back(column);
      path.push_back(branch);
      queens(size, columns, path, branch_mark(hash_of_mark(mark), branch));
      columns.pop_back();
      path.pop_back();
      ++branch;
    }
  }
};

TEST(Search, OpensEveryNodeOnceAsARecursionDoes) {
  Queens queens(8);
  const auto outcome = search(queens);
  Recount recount;
  std::vector<int> columns;
  Path path;
  recount.queens(8, columns, path, root_mark);
  EXPECT_EQ(outcome.opened(), recount.nodes);
  EXPECT_EQ(outcome.fingerprint(), recount.fingerprint);
  std::vector<Path> paths;
  for (const auto& found : outcome.solutions) paths.push_back(found.path);
  EXPECT_EQ(paths, recount.solutions);
}

TEST(Search, HandsOverTheTallyOfTheProblem) {
  RandomTree tree(3, 12);
  const auto outcome = search(tree);
  ASSERT_EQ(outcome.ranks.size(), 1U);
  EXPECT_EQ(outcome.ranks[0].tally, tree.tally());
  EXPECT_GT(tree.tally(), 0U);
}

TEST(Search, HoldsNoMoreOpenNodesThanDepthTimesBranching) {
  RandomTree tree(3, 20);
  const auto outcome = search(tree);
  EXPECT_LE(outcome.ranks[0].statistics.peak_open, 20U * 3U);
}

// A node may yield several solutions and have children as well.
struct Counting {
  using Node = int;
  using Solution = int;
  Node root() const { return 3; }
  void expand(Node&& node, Expansion<Counting>& out) {
    for (int i = 0; i < node; ++i) {
      out.solution(10 * node + i);
      out.branch(node - 1);
    }
  }
};

TEST(Search, KeepsTheOrderOfSeveralSolutionsOfOneNode) {
  Counting counting;
  const auto outcome = search(counting);
  std::vector<int> values;
  for (const auto& found : outcome.solutions) values.push_back(found.solution);
  EXPECT_THAT(values,
              testing::ElementsAre(30, 31, 32, 20, 21, 10, 10, 20, 21, 10, 10, 20, 21, 10, 10));
}

struct Throwing {
  using Node = int;
  using Solution = int;
  Node root() const { return 0; }
  void expand(Node&& node, Expansion<Throwing>& out) {
    if (node == 2) throw std::domain_error("no such thing");
    out.branch(node + 2);
    out.branch(node + 1);
  }
};

TEST(Search, AnExceptionNamesTheNodeAndCarriesItsCause) {
  Throwing throwing;
  try {
    search(throwing);
    FAIL() << "nothing was thrown";
  } catch (const ExpansionFailed& failure) {
    EXPECT_STREQ(failure.what(), "node 0: no such thing");
    EXPECT_THROW(std::rethrow_if_nested(failure), std::domain_error);
  }
}

TEST(Search, ProgressEndsWithTheWholeTreeClosed) {
  RandomTree tree(5, 14);
  Progress last;
  Options options;
  options.survey_interval = 0;
  double closed_before = 0;
  options.progress = [&](const Progress& progress) {
    EXPECT_GE(progress.closed, closed_before);
    closed_before = progress.closed;
    last = progress;
  };
  const auto outcome = search(tree, options);
  EXPECT_EQ(last.opened, outcome.opened());
  EXPECT_EQ(last.open, 0U);
  EXPECT_EQ(last.found, outcome.solutions.size());
  EXPECT_NEAR(last.closed, 1.0, 1e-9);
}

}  // namespace
}  // namespace kusabi::engine
