// Search tests in one process: known counts, the canonical order, and errors.
#include "engine/search.hpp"

#include <numeric>

#include <boost/serialization/vector.hpp>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "engine/simulation.hpp"
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

// Messages of one search are not received in another one (mpi_tests/collectives_mpi_test.cpp).
TEST(Search, BeginsOnTheTransportOnce) {
  class Counter final : public SingleProcess {
   public:
    void begin_search() override { ++begun; }
    int begun = 0;
  };
  Counter transport;
  for (int number = 1; number <= 3; ++number) {
    Queens queens(4);
    search(queens, transport);
    EXPECT_EQ(transport.begun, number);
  }
}

TEST(Search, ReportsSolutionsInDepthFirstOrder) {
  Queens queens(6);
  const auto outcome = search(queens);
  std::vector<std::vector<int>> boards;
  for (const auto& found : outcome.solutions) boards.push_back(found.solution.columns);
  // The order of the tree is the lexicographic order of the boards.
  EXPECT_TRUE(std::is_sorted(boards.begin(), boards.end()));
  EXPECT_EQ(boards.front(), (std::vector<int>{1, 3, 5, 0, 2, 4}));
}

// A binary tree of depth 4, all of whose nodes are solutions. `expand` differs once: when this
// object opens its twentieth node.
struct Moody {
  enum class Slip { none, child_more, other_child, other_bound, solution_less, other_solution };
  struct Node {
    std::uint32_t left = 4;
    std::uint32_t tag = 0;
    template <class Archive>
    void serialize(Archive& archive, unsigned /*version*/) {
      archive& left& tag;
    }
  };
  using Solution = std::uint32_t;

  Slip slip = Slip::none;
  std::uint32_t opened = 0;

  [[nodiscard]] Node root() const { return {}; }
  void expand(Node&& node, Expansion<Moody>& out) {
    ++opened;
    if (node.left > 0) {
      out.branch({node.left - 1, slips(Slip::other_child) ? 1U : 0U});
      out.branch({node.left - 1, 0});
    }
    if (slips(Slip::child_more)) out.branch({0, 0});
    if (!slips(Slip::solution_less)) out.solution(slips(Slip::other_solution) ? 8 : 7);
  }
  [[nodiscard]] double objective(const Solution& /*solution*/) const { return 1; }
  [[nodiscard]] double bound(const Node& /*node*/) const {
    return slips(Slip::other_bound) ? -1 : -2;
  }
  [[nodiscard]] bool slips(Slip which) const { return opened == 20 && slip == which; }
};

TEST(CheckExpand, NamesTheNodeAndTheDifference) {
  using Slip = Moody::Slip;
  const auto complaint_at = [](Slip slip, double share) {
    Moody problem{slip};
    Options options;
    options.check_expand = share;
    try {
      search(problem, options);
      return std::string("none");
    } catch (const ExpansionDiffers& error) {
      return std::string(error.what());
    }
  };
  EXPECT_EQ(complaint_at(Slip::none, 1), "none");
  EXPECT_EQ(complaint_at(Slip::other_child, 0), "none");
  // The tenth node in depth-first order, at its second expansion.
  const auto expected = [](const std::string& what) {
    return "node 0.1: opened twice, " + what + "; expected that expand depends on the node alone";
  };
  EXPECT_EQ(complaint_at(Slip::child_more, 1),
            expected("2 children the first time, 3 the second time"));
  EXPECT_EQ(complaint_at(Slip::other_child, 1), expected("child 0 is not the same"));
  EXPECT_EQ(complaint_at(Slip::other_bound, 1),
            expected("the bound of child 0 is -2 the first time, -1 the second time"));
  EXPECT_EQ(complaint_at(Slip::solution_less, 1),
            expected("1 solutions the first time, 0 the second time"));
  EXPECT_EQ(complaint_at(Slip::other_solution, 1), expected("solution 0 is not the same"));
}

TEST(CheckExpand, ExpandsItsShareTwiceWithTheSameOutcome) {
  RandomTree plain(2, 16);
  const auto once = search(plain);
  for (const double share : {0.1, 1.0}) {
    Options options;
    options.check_expand = share;
    const auto checked = simulate(RandomTree(2, 16), 4, 1, {}, options).outcome;
    EXPECT_EQ(checked.opened(), once.opened());
    EXPECT_EQ(checked.fingerprint(), once.fingerprint());
    ASSERT_EQ(checked.solutions.size(), once.solutions.size());
    for (std::size_t i = 0; i < once.solutions.size(); ++i) {
      ASSERT_EQ(checked.solutions[i].path, once.solutions[i].path);
    }
    // The tally counts leaves, including those of repeated expansions.
    const double leaves = static_cast<double>(once.tally());
    EXPECT_NEAR(static_cast<double>(checked.tally()), (1 + share) * leaves, 0.02 * leaves);
  }
}

// Each node is a better solution than its parent, and has a child only if no better solution is
// known.
struct Descent {
  using Node = std::uint32_t;
  using Solution = std::uint32_t;
  [[nodiscard]] Node root() const { return 9; }
  void expand(Node&& node, Expansion<Descent>& out) {
    const bool news = out.cutoff() > node;
    out.solution(node);
    if (node > 0 && news) out.branch(node - 1);
  }
  [[nodiscard]] double objective(const Solution& solution) const { return solution; }
};

TEST(CheckExpand, OpensTheNodeWithTheSameCutoffBothTimes) {
  Descent descent;
  Options options;
  options.goal = Goal::best;
  options.check_expand = 1;
  const auto outcome = search(descent, options);
  ASSERT_EQ(outcome.solutions.size(), 1U);
  EXPECT_EQ(outcome.solutions[0].solution, 0U);
  EXPECT_EQ(outcome.ranks[0].statistics.found, 10U);
  EXPECT_EQ(outcome.opened(), 10U);
}

// A recursion that shares only the definition of the tree with the engine.
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

TEST(Search, ReturnsTheTallyOfTheProblem) {
  RandomTree tree(3, 12);
  const auto outcome = search(tree);
  ASSERT_EQ(outcome.ranks.size(), 1U);
  EXPECT_EQ(outcome.ranks[0].tally, tree.tally());
  EXPECT_GT(tree.tally(), 0U);
}

TEST(Search, StoresAtMostDepthTimesBranchingOpenNodes) {
  RandomTree tree(3, 20);
  const auto outcome = search(tree);
  EXPECT_LE(outcome.ranks[0].statistics.peak_open, 20U * 3U);
}

// A node may report several solutions and have children as well.
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

// A binary tree of depth 4; the node of a given depth that is opened first takes until the search
// is asked to end.
struct Endless {
  struct Node {
    std::uint32_t left = 4;
    template <class Archive>
    void serialize(Archive& archive, unsigned /*version*/) {
      archive& left;
    }
  };
  using Solution = int;

  bool asked = false;

  [[nodiscard]] Node root() const { return {}; }
  void expand(Node&& node, Expansion<Endless>& out) {
    if (node.left > 0) out.branch({node.left - 1});
    if (node.left == 2) {
      asked = true;
      while (!out.poll()) {
      }
      return out.put_back(node);
    }
    if (node.left > 0) out.branch({node.left - 1});
  }
};

TEST(Search, ANodeThatIsPutBackIsNotOpened) {
  Endless endless;
  Options options;
  options.reduction_interval = 0;
  options.interrupt = [&] { return endless.asked ? Interrupt::stop : Interrupt::none; };
  const auto outcome = search(endless, options);
  EXPECT_EQ(outcome.status, Status::interrupted);
  EXPECT_EQ(outcome.opened(), 2U);
  EXPECT_EQ(outcome.open, 3U);  // it, its sibling and that of its parent
}

TEST(Search, ProgressEndsWithTheWholeTreeClosed) {
  RandomTree tree(5, 14);
  Progress last;
  Options options;
  options.reduction_interval = 0;
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
