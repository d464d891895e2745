// Recorded trees: a recording of a search is searched as the tree itself; wrong files are refused.
#include "nodes/benchmark/recorded_tree.hpp"

#include <cmath>
#include <sstream>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "engine/simulation.hpp"
#include "nodes/benchmark/sized_tree.hpp"

namespace kusabi::benchmark {
namespace {

using testing::HasSubstr;

RecordedTree read(const std::string& text) {
  std::istringstream stream(text);
  return RecordedTree::read(stream, "tree");
}

std::string refusal(const std::string& text) {
  try {
    read(text);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "accepted";
}

TEST(RecordedTree, IsTheTreeThatWasSearched) {
  SizedTree tree(3, 2000);
  std::ostringstream recording;
  engine::Options options;
  options.record = [&](std::size_t depth, double seconds) {
    EXPECT_GE(seconds, 0);
    recording << depth << " 1000\n";
  };
  const auto searched = engine::search(tree, options);
  auto recorded = read(recording.str());
  EXPECT_EQ(recorded.size(), searched.opened());
  // All paths are the same, since the mark sum is.
  EXPECT_EQ(engine::search(recorded).fingerprint(), searched.fingerprint());
}

TEST(RecordedTree, TakesItsRecordedTimeInASimulation) {
  const auto tree = read("# a comment\n0 1000\n1 2000\n2 500.5\n1 4000\n");
  EXPECT_EQ(tree.size(), 4U);
  EXPECT_DOUBLE_EQ(tree.total_seconds(), 7500.5e-9);
  EXPECT_DOUBLE_EQ(tree.least_seconds(), 500.5e-9);
  EXPECT_DOUBLE_EQ(tree.longest_path(), 5000e-9);
  const auto alone = engine::simulate(tree, 1, 1);
  EXPECT_EQ(alone.outcome.opened(), 4U);
  EXPECT_GT(alone.seconds, tree.total_seconds());
  EXPECT_LT(alone.seconds, 1.5 * tree.total_seconds());
}

TEST(RecordedTree, IsRefusedWithTheNumberOfAnInvalidLine) {
  EXPECT_EQ(refusal(""), "tree: has no nodes; expected a recorded tree");
  EXPECT_EQ(refusal("1 5\n"), "tree, line 1: expected the root first, with depth 0");
  EXPECT_EQ(refusal("0 5\n2 5\n"), "tree, line 2: expected a depth from 1 to 1");
  EXPECT_EQ(refusal("0 5\n1 5\n0 5\n"), "tree, line 3: expected a depth from 1 to 2");
  for (const std::string line : {"0", "0 x", "0 -1", "0 1 2", "0 nan", "-1 5"}) {
    EXPECT_THAT(refusal(line), HasSubstr("tree, line 1: expected")) << line;
  }
}

}  // namespace
}  // namespace kusabi::benchmark
