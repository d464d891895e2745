// Unbalanced Tree Search benchmark over MPI: the published counts, on any number of ranks.
#include <gtest/gtest.h>

#include "engine/search.hpp"
#include "engine/transport/mpi.hpp"
#include "nodes/benchmark/standard_trees.hpp"

namespace kusabi::benchmark {
namespace {

void expect_published_counts(const char* name) {
  engine::MpiTransport transport;
  const auto& standard = standard_tree(name);
  UnbalancedTree tree(standard.parameters);
  const auto outcome = engine::search(tree, transport);
  if (transport.rank() != 0) return;
  ASSERT_EQ(outcome.ranks.size(), static_cast<std::size_t>(transport.size()));
  const auto counts = outcome.tally();
  EXPECT_EQ(counts.nodes, standard.counts.nodes);
  EXPECT_EQ(counts.leaves, standard.counts.leaves);
  EXPECT_EQ(counts.depth, standard.counts.depth);
  EXPECT_EQ(outcome.opened(), standard.counts.nodes);
}

// Shallow and even: many small transfers.
TEST(MpiUnbalancedTree, T1HasItsPublishedCounts) {
  expect_published_counts("T1");
}

// Depth 1572; nearly all of the root's 2000 subtrees end at once.
TEST(MpiUnbalancedTree, T3HasItsPublishedCounts) {
  expect_published_counts("T3");
}

}  // namespace
}  // namespace kusabi::benchmark
