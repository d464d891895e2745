// Tests of path hashes and of the text form of a path.
#include "engine/path.hpp"

#include <set>

#include <gtest/gtest.h>

namespace kusabi::engine {
namespace {

TEST(Path, IsWrittenAsBranchNumbersFromTheRoot) {
  EXPECT_EQ(to_string(Path{}), "root");
  EXPECT_EQ(to_string(Path{0, 1, 12}), "0.1.12");
}

TEST(Path, ALongPathIsAbbreviatedInTheMiddle) {
  Path path(1000, 0);
  path.back() = 7;
  const auto text = to_string(path);
  EXPECT_LT(text.size(), 100U);
  EXPECT_NE(text.find("(968 more)"), std::string::npos);
  EXPECT_EQ(text.back(), '7');
}

TEST(Path, MarksAndHashesOfAWholeTreeDiffer) {
  std::set<std::uint64_t> marks{root_mark};
  std::set<std::uint64_t> hashes{hash_of_mark(root_mark)};
  std::vector<std::uint64_t> level(hashes.begin(), hashes.end());
  for (int depth = 0; depth < 6; ++depth) {
    std::vector<std::uint64_t> next;
    for (const auto parent : level) {
      for (std::uint32_t branch = 0; branch < 5; ++branch) {
        const auto mark = branch_mark(parent, branch);
        EXPECT_TRUE(marks.insert(mark).second);
        EXPECT_TRUE(hashes.insert(hash_of_mark(mark)).second);
        next.push_back(hash_of_mark(mark));
      }
    }
    level = std::move(next);
  }
}

// A sum linear in the branch number would not detect that one of three siblings was opened three
// times and the two others never.
TEST(Path, SumsOfMarksDistinguishSiblings) {
  std::uint64_t parent = 1;
  for (int trial = 0; trial < 10'000; ++trial) {
    parent = branch_hash(parent, 0);
    EXPECT_NE(branch_mark(parent, 0) + branch_mark(parent, 2), 2 * branch_mark(parent, 1));
  }
}

TEST(Path, HashOfAPathDependsOnTheOrderOfItsBranches) {
  EXPECT_NE(branch_hash(branch_hash(root_mark, 0), 1), branch_hash(branch_hash(root_mark, 1), 0));
}

}  // namespace
}  // namespace kusabi::engine
