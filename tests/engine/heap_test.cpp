// Heap tests: order by bounds, transfers, and shared trails.
#include "engine/detail/nodes/heap.hpp"

#include <cmath>
#include <random>
#include <set>

#include <gtest/gtest.h>

#include "engine/detail/nodes/frontier.hpp"

namespace kusabi::engine {
namespace {

// A node that stores its own path and its bound.
struct PathNode {
  Path path;
  double bound = 0;

  template <class Archive>
  void serialize(Archive& archive, unsigned /*version*/) {
    archive& path& bound;
  }
};

double bound_of(const PathNode& node) {
  return node.bound;
}

// Children of the root with these bounds, in a bundle as from a frontier: the first child last.
Bundle<PathNode> children(const std::vector<double>& bounds) {
  Bundle<PathNode> bundle;
  TrailStep root;
  root.branches = static_cast<std::uint32_t>(bounds.size());
  bundle.trail = {root};
  for (auto branch = root.branches; branch-- > 0;) {
    bundle.nodes.emplace_back(PathNode{{branch}, bounds[branch]}, 1, branch);
  }
  return bundle;
}

std::vector<double> drain(Heap<PathNode>& heap) {
  std::vector<double> bounds;
  while (!heap.empty()) {
    bounds.push_back(heap.best().bound);
    EXPECT_EQ(heap.take().nodes.front().node.bound, bounds.back());
  }
  return bounds;
}

TEST(Heap, TakesTheLeastBoundFirst) {
  Heap<PathNode> heap;
  heap.put(children({3, 1, 4}), bound_of);
  heap.put(children({1, 5, -9, 2}), bound_of);
  EXPECT_EQ(heap.size(), 7U);
  EXPECT_EQ(drain(heap), (std::vector<double>{-9, 1, 1, 2, 3, 4, 5}));
}

TEST(Heap, TakesTheLastInsertedFirstAmongEqualBounds) {
  Heap<PathNode> heap;
  heap.put(children({0, 0}), bound_of);
  heap.put(children({0, 0, 0}), bound_of);
  std::vector<Path> order;
  while (!heap.empty()) order.push_back(heap.take().nodes.front().node.path);
  EXPECT_EQ(order, (std::vector<Path>{{0}, {1}, {2}, {0}, {1}}));
}

TEST(Heap, GivesEveryOtherNodeAndKeepsTheBest) {
  Heap<PathNode> heap;
  heap.put(children({1, 2, 3, 4, 5}), bound_of);
  const auto transfer = heap.give(100'000);
  ASSERT_EQ(size_of(transfer), 2U);
  EXPECT_EQ(transfer[0].nodes[0].node.bound, 2);
  EXPECT_EQ(transfer[1].nodes[0].node.bound, 4);
  EXPECT_EQ(drain(heap), (std::vector<double>{1, 3, 5}));
}

TEST(Heap, GivesNoMoreBytesThanTheLimitButAtLeastOneNode) {
  Heap<PathNode> heap;
  heap.put(children(std::vector<double>(100, 1)), bound_of);
  const auto one = heap.give(1);
  EXPECT_EQ(size_of(one), 1U);
  const auto transfer = heap.give(1000);
  const auto bytes = pack(transfer).size();
  EXPECT_LE(bytes, 1000U + 64U);  // and the header of the list
  EXPECT_GE(bytes, 1000U - pack(one).size());
  // The node that did not fit is still here, with its trail.
  EXPECT_EQ(heap.size(), 99U - size_of(transfer));
  std::set<Path> paths{one[0].nodes[0].node.path};
  for (const auto& bundle : transfer) paths.insert(bundle.nodes[0].node.path);
  while (!heap.empty()) {
    auto bundle = heap.take();
    ASSERT_EQ(bundle.trail.size(), 1U);
    paths.insert(bundle.nodes[0].node.path);
  }
  EXPECT_EQ(paths.size(), 100U);
}

TEST(Heap, GivesNothingIfItHasOneNode) {
  Heap<PathNode> heap;
  heap.put(children({1}), bound_of);
  EXPECT_FALSE(heap.can_transfer());
}

TEST(Heap, RefusesABoundThatIsNotANumber) {
  Heap<PathNode> heap;
  EXPECT_THROW(heap.put(children({1, std::nan("")}), bound_of), std::domain_error);
}

// Takes the one node of a bundle through a frontier, which checks its trail.
Path path_by_trail(Bundle<PathNode> bundle) {
  Frontier<PathNode> frontier;
  frontier.take(std::move(bundle));
  frontier.open();
  return frontier.path();
}

// A chain whose nodes also have a leaf that waits: each trail continues the one before.
TEST(Heap, MemoryOfAChainGrowsWithItsNodes) {
  constexpr std::uint32_t depth = 3000;
  Frontier<PathNode> frontier;
  Heap<PathNode> heap;
  frontier.add_root({});
  std::size_t half = 0;
  for (std::uint32_t opened = 0; opened < depth; ++opened) {
    if (frontier.empty()) frontier.take(heap.take());
    frontier.open();
    frontier.branch({{opened}, 1});
    frontier.branch({{opened}, 0});
    frontier.close();
    heap.put(frontier.take_all(), bound_of);
    if (opened == depth / 2) half = heap.bytes();
  }
  EXPECT_LT(heap.bytes(), 2.2 * static_cast<double>(half));  // not four times
  // The leaf of node d has the path 1, 1, ..., 1, 0 of length d + 1.
  for (heap.take(); !heap.empty();) {
    const auto bundle = heap.take();
    Path expected(bundle.nodes[0].node.path[0] + std::size_t{1}, 1);
    expected.back() = 0;
    ASSERT_EQ(path_by_trail(bundle), expected);
  }
}

TEST(Heap, IsFullAtItsByteLimit) {
  Heap<PathNode> heap(1000, 2000);
  heap.put(children({1}), bound_of);
  EXPECT_FALSE(heap.full());
  const auto one = heap.bytes();
  EXPECT_GT(one, sizeof(PathNode));
  heap.put(children(std::vector<double>(100, 1)), bound_of);
  EXPECT_TRUE(heap.full());
  while (heap.size() > 1) heap.take();
  EXPECT_FALSE(heap.full());
  EXPECT_LE(heap.bytes(), 2 * one);
}

// A bundle as checkpoints had it when trails were lists of steps.
struct OlderBundle {
  std::vector<TrailStep> trail;
  std::vector<OpenNode<PathNode>> nodes;

  template <class Archive>
  void serialize(Archive& archive, unsigned /*version*/) {
    archive& trail& nodes;
  }
};

TEST(Bundle, OfAnOlderCheckpointIsRead) {
  OlderBundle older{{{0, 2, 77, 0.5}, {1, 3, 88, 0.25}}, {}};
  older.nodes.emplace_back(PathNode{{1, 2}, 3.5}, 2, 2);
  const auto bundle = unpack<Bundle<PathNode>>(pack(older));
  ASSERT_EQ(bundle.trail.size(), 2U);
  EXPECT_EQ(bundle.trail[1].hash, 88U);
  EXPECT_EQ(bundle.trail[1].share_of_each, 0.25);
  ASSERT_EQ(bundle.nodes.size(), 1U);
  EXPECT_EQ(bundle.nodes[0].node.path, (Path{1, 2}));
  const auto again = unpack<Bundle<PathNode>>(pack(bundle));
  EXPECT_EQ(again.trail[0].branches, 2U);
  EXPECT_EQ(again.nodes[0].branch, 2U);
}

// A heap that receives the remainder of a depth-first search at random moments: after any transfers
// each node still has its own path.
TEST(Heap, KeepsPathsInAnyNumberOfTransfers) {
  std::mt19937 random(5);
  Frontier<PathNode> frontier;
  Heap<PathNode> heap;
  frontier.add_root({});
  std::size_t checked = 0;
  for (int opened = 0; opened < 2000; ++opened) {
    if (frontier.empty()) {
      if (heap.empty()) break;
      frontier.take(heap.take());
    }
    const auto node = frontier.open();
    ASSERT_EQ(frontier.path(), node.path);
    const auto count = opened < 500 ? 1 + static_cast<std::uint32_t>(random() % 3) : 0;
    for (std::uint32_t branch = 0; branch < count; ++branch) {
      auto path = node.path;
      path.push_back(branch);
      frontier.branch({std::move(path), static_cast<double>(random() % 10)});
    }
    frontier.close();
    if (!frontier.empty() && random() % 4 == 0) heap.put(frontier.take_all(), bound_of);
    if (opened % 100 != 0) continue;
    std::size_t copied = 0;
    const auto bundles = unpack<Transfer<PathNode>>(pack(heap.all()));
    for (const auto& bundle : bundles) {
      ASSERT_FALSE(bundle.nodes.empty());
      for (const auto& open : bundle.nodes) {
        auto trail = bundle.trail;
        trail.resize(open.depth);
        ASSERT_EQ(path_by_trail({std::move(trail), {open}}), open.node.path);
        ++copied;
      }
    }
    EXPECT_EQ(copied, heap.size());
    EXPECT_EQ(pack(heap.all()), pack(bundles));  // saved as the list of bundles is
    checked += copied;
  }
  EXPECT_TRUE(frontier.empty() && heap.empty());
  EXPECT_GT(checked, 500U);
}

}  // namespace
}  // namespace kusabi::engine
