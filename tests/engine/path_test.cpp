// Path hashes and how a path is written.
#include "engine/path.hpp"

#include <set>

#include <gtest/gtest.h>

namespace kusabi::engine {
namespace {

TEST(Path, IsWrittenAsBranchNumbersFromTheRoot) {
  EXPECT_EQ(to_string(Path{}), "root");
  EXPECT_EQ(to_string(Path{0, 1, 12}), "0.1.12");
}

TEST(Path, ALongOneIsCutInTheMiddle) {
  Path path(1000, 0);
  path.back() = 7;
  const auto text = to_string(path);
  EXPECT_LT(text.size(), 100U);
  EXPECT_NE(text.find("(968 more)"), std::string::npos);
  EXPECT_EQ(text.back(), '7');
}

TEST(Path, HashesOfAWholeTreeDiffer) {
  std::set<std::uint64_t> seen{root_hash};
  std::vector<std::uint64_t> level{root_hash};
  for (int depth = 0; depth < 6; ++depth) {
    std::vector<std::uint64_t> next;
    for (const auto parent : level) {
      for (std::uint32_t branch = 0; branch < 5; ++branch) {
        next.push_back(branch_hash(parent, branch));
        EXPECT_TRUE(seen.insert(next.back()).second);
      }
    }
    level = std::move(next);
  }
}

TEST(Path, HashOfAPathDependsOnTheOrderOfItsBranches) {
  EXPECT_NE(branch_hash(branch_hash(root_hash, 0), 1), branch_hash(branch_hash(root_hash, 1), 0));
}

}  // namespace
}  // namespace kusabi::engine
