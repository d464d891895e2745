// Frontier tests: depth-first order, transfers, and paths computed from the trail.
#include "engine/detail/nodes/frontier.hpp"

#include <algorithm>
#include <random>

#include <gtest/gtest.h>

namespace kusabi::engine {
namespace {

// A node that stores its own path, to check the path computed by the frontier.
using PathNode = Path;

PathNode child_of(const PathNode& parent, std::uint32_t branch) {
  PathNode child = parent;
  child.push_back(branch);
  return child;
}

std::uint64_t mark_of(const Path& path) {
  std::uint64_t mark = root_mark;
  for (const auto branch : path) mark = branch_mark(hash_of_mark(mark), branch);
  return mark;
}

// Paths before and after `path`, and equal to it, compared with the frontier's path.
void expect_compares_as(const Path& path, const Frontier<PathNode>& frontier) {
  std::vector<Path> others{{}, path, child_of(path, 0), child_of({}, 0), child_of({}, 9)};
  if (!path.empty()) {
    others.emplace_back(path.begin(), path.end() - 1);
    others.push_back(path);
    ++others.back().back();
    if (path.back() > 0) {
      others.push_back(path);
      --others.back().back();
    }
  }
  for (const auto& other : others) EXPECT_EQ(other <=> frontier.place(), other <=> path);
}

// Opens one node, checks its path, and gives it `children` children.
PathNode open_and_branch(Frontier<PathNode>& frontier, std::uint32_t children) {
  PathNode node = frontier.open();
  EXPECT_EQ(frontier.path(), node);
  expect_compares_as(node, frontier);
  EXPECT_EQ(frontier.mark(), mark_of(node));
  for (std::uint32_t branch = 0; branch < children; ++branch) {
    frontier.branch(child_of(node, branch));
  }
  frontier.close();
  return node;
}

TEST(Frontier, OpensDepthFirstAndChildrenInOrder) {
  Frontier<PathNode> frontier;
  frontier.add_root({});
  std::vector<PathNode> opened;
  while (!frontier.empty()) {
    const bool inner = opened.size() < 2;
    opened.push_back(open_and_branch(frontier, inner ? 3 : 0));
  }
  const std::vector<PathNode> expected{{}, {0}, {0, 0}, {0, 1}, {0, 2}, {1}, {2}};
  EXPECT_EQ(opened, expected);
}

TEST(Frontier, GivesEveryOtherNodeFromTheShallowestOn) {
  Frontier<PathNode> frontier;
  frontier.add_root({});
  open_and_branch(frontier, 3);  // stack: 2 1 0
  open_and_branch(frontier, 3);  // stack: 2 1 0.2 0.1 0.0
  const auto transfer = frontier.give(100'000);
  ASSERT_EQ(transfer.nodes.size(), 2U);
  EXPECT_EQ(transfer.nodes[0].node, (PathNode{2}));
  EXPECT_EQ(transfer.nodes[1].node, (PathNode{0, 2}));
  EXPECT_EQ(transfer.trail.size(), 2U);  // the root and node 0
  EXPECT_EQ(frontier.size(), 3U);
}

TEST(Frontier, KeepsAtLeastOneNode) {
  Frontier<PathNode> frontier;
  frontier.add_root({});
  EXPECT_FALSE(frontier.can_transfer());
  open_and_branch(frontier, 2);
  ASSERT_TRUE(frontier.can_transfer());
  EXPECT_EQ(frontier.give(100'000).nodes.size(), 1U);
  EXPECT_FALSE(frontier.can_transfer());
}

TEST(Frontier, GivesNoMoreBytesThanTheLimitButAtLeastOneNode) {
  Frontier<PathNode> frontier;
  frontier.add_root({});
  open_and_branch(frontier, 100);
  const auto transfer = frontier.give(400);
  EXPECT_GT(transfer.nodes.size(), 1U);
  EXPECT_LE(pack(transfer.nodes).size(), 400U + 64U);  // and the header of the list
  EXPECT_EQ(frontier.size(), 100U - transfer.nodes.size());
  EXPECT_EQ(frontier.give(1).nodes.size(), 1U);
}

// Pieces of a bundle: within the limit, with at least one node, in order, each below its own trail.
TEST(Frontier, GivesManySiblingsInPieces) {
  for (const std::size_t limit : {1U, 400U, 100'000U}) {
    SCOPED_TRACE(limit);
    Frontier<PathNode> frontier;
    frontier.add_root({});
    open_and_branch(frontier, 100);
    open_and_branch(frontier, 100);
    auto given = frontier.give(100'000);
    const auto nodes = given.nodes;
    EXPECT_EQ(nodes.size(), 99U);  // of 99 + 100
    const auto pieces = in_pieces(std::move(given), limit);
    EXPECT_EQ(pieces.size() == 1, limit == 100'000);
    EXPECT_EQ(pieces.size() > nodes.size() / 3, limit == 1);
    std::size_t place = 0;
    for (const auto& piece : pieces) {
      const auto maximum = std::max(limit, 2 * piece.trail.size() * sizeof(TrailStep));
      EXPECT_TRUE(piece.nodes.size() == 1 || pack(piece).size() <= maximum + 100);  // list headers
      for (const auto& open : piece.nodes) ASSERT_EQ(open.node, nodes[place++].node);
      EXPECT_EQ(piece.trail.size(), piece.nodes.back().depth);
    }
    EXPECT_EQ(place, nodes.size());
  }
}

// Pieces below a long trail: at most twice the size of their nodes, but for one trail.
TEST(Frontier, LimitsTheShareOfTrailsInPieces) {
  constexpr std::uint32_t levels = 1000;
  constexpr std::size_t node_bytes = 500;
  Frontier<std::vector<char>> frontier;
  frontier.add_root({});
  for (std::uint32_t depth = 0; depth < levels; ++depth) {
    frontier.open();
    const auto children = depth + 1 < levels ? 1U : 1000U;
    for (auto left = children; left > 0; --left) frontier.branch(std::vector<char>(node_bytes));
    frontier.close();
  }
  auto given = frontier.give(10'000'000);
  ASSERT_EQ(given.trail.size(), levels);
  const auto nodes = pack(given.nodes).size();
  std::size_t bytes = 0;
  const auto pieces = in_pieces(std::move(given), 4000);
  for (const auto& piece : pieces) bytes += pack(piece).size();
  EXPECT_GT(pieces.size(), 5U);
  EXPECT_LE(bytes, 2 * nodes + levels * sizeof(TrailStep) + pieces.size() * (node_bytes + 100));
}

// Repeated transfers from one node's children: each takes every other of the remaining ones.
TEST(Frontier, GivesAllButOneNodeInRepeatedTransfers) {
  Frontier<PathNode> frontier;
  frontier.add_root({});
  open_and_branch(frontier, 100);
  std::vector<std::uint32_t> left;  // shallowest first: the last child is at the bottom
  for (std::uint32_t branch = 100; branch > 0; --branch) left.push_back(branch - 1);
  while (frontier.can_transfer()) {
    const auto transfer = frontier.give(400);
    ASSERT_FALSE(transfer.nodes.empty());
    for (std::size_t i = 0; i < transfer.nodes.size(); ++i) {
      ASSERT_EQ(transfer.nodes[i].node, PathNode{left[i]});
      left.erase(left.begin() + static_cast<std::ptrdiff_t>(i));
    }
    ASSERT_EQ(frontier.size(), left.size());
    std::vector<PathNode> kept;
    frontier.for_each([&](const PathNode& node) { kept.push_back(node); });
    for (std::size_t i = 0; i < left.size(); ++i) ASSERT_EQ(kept[i], PathNode{left[i]});
  }
  EXPECT_EQ(open_and_branch(frontier, 0), PathNode{left.front()});
  EXPECT_TRUE(frontier.empty());
}

TEST(Frontier, GivesNoChildrenBeforeTheirParentIsClosed) {
  Frontier<PathNode> frontier;
  frontier.add_root({});
  frontier.open();
  for (std::uint32_t branch = 0; branch < 4; ++branch) frontier.branch({branch});
  EXPECT_FALSE(frontier.can_transfer());
  frontier.close();
  EXPECT_TRUE(frontier.can_transfer());
}

TEST(Frontier, DividesTheShareOfANodeAmongItsChildren) {
  Frontier<PathNode> frontier;
  frontier.add_root({});
  open_and_branch(frontier, 4);
  open_and_branch(frontier, 2);
  frontier.open();
  EXPECT_DOUBLE_EQ(frontier.close(), 1.0 / 8);
  frontier.open();
  frontier.branch({0, 1, 0});
  EXPECT_DOUBLE_EQ(frontier.close(), 0);
}

struct ThirdOfEach {
  static constexpr double of_first_child = 1.0 / 3;
};

// A first child of a third of the others' share: 1 + 3 + 3 parts. The shares of all leaves sum to
// one.
TEST(Frontier, AFirstChildMayHaveASmallerShare) {
  Frontier<PathNode, ThirdOfEach> frontier;
  frontier.add_root({});
  frontier.open();
  for (std::uint32_t branch = 0; branch < 3; ++branch) frontier.branch({branch});
  EXPECT_DOUBLE_EQ(frontier.close(), 0);
  frontier.open();
  EXPECT_DOUBLE_EQ(frontier.close(), 1.0 / 7);
  frontier.open();
  frontier.branch({1, 0});
  EXPECT_DOUBLE_EQ(frontier.close(), 0);
  frontier.open();
  EXPECT_DOUBLE_EQ(frontier.close(), 3.0 / 7);
  frontier.open();
  EXPECT_DOUBLE_EQ(frontier.close(), 3.0 / 7);
}

// Several frontiers open and transfer nodes at random; every node must be opened once, with the
// right path, after any number of transfers.
TEST(Frontier, KeepsPathsInAnyNumberOfTransfers) {
  for (unsigned seed = 0; seed < 50; ++seed) {
    std::mt19937 random(seed);
    std::vector<Frontier<PathNode>> ranks(4);
    ranks[0].add_root({});
    std::size_t open = 1;
    std::size_t opened = 0;
    std::uint64_t fingerprint = 0;
    std::uint64_t expected = 0;
    while (open > 0) {
      auto& one = ranks[random() % ranks.size()];
      auto& other = ranks[random() % ranks.size()];
      if (!one.empty()) {
        const auto children = opened < 300 ? static_cast<std::uint32_t>(random() % 4) : 0;
        const auto node = open_and_branch(one, children);
        fingerprint += one.mark();
        expected += mark_of(node);
        open += children;
        --open;
        ++opened;
      } else if (other.can_transfer()) {
        one.take(other.give(1 + random() % 500));
      }
    }
    EXPECT_EQ(fingerprint, expected) << "seed " << seed;
  }
}

}  // namespace
}  // namespace kusabi::engine
