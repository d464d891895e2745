// Tests of spelling suggestions.
#include "support/nearest.hpp"

#include <gtest/gtest.h>

namespace {

using kusabi::support::did_you_mean;
using kusabi::support::nearest;

TEST(Nearest, IsTheWordWithTheFewestChanges) {
  EXPECT_EQ(nearest("patern", {"rays", "patterns"}), "patterns");
  EXPECT_EQ(nearest("menbers", {"number", "members"}), "members");
  EXPECT_EQ(nearest("rays", {"ray", "rays"}), "rays");
}

TEST(Nearest, CountsATranspositionOnce) {
  EXPECT_EQ(nearest("gird", {"grid", "give"}), "grid");
  EXPECT_EQ(nearest("ylimti", {"limits"}), "");
}

TEST(Nearest, IsNoneIfHalfOfTheWordIsWrong) {
  EXPECT_EQ(nearest("x", {"y"}), "");
  EXPECT_EQ(nearest("mu", {"mv", "u"}), "");
  EXPECT_EQ(nearest("", {"", "mu"}), "");
  EXPECT_EQ(nearest("nothing", {"patterns", "limit"}), "");
}

TEST(Nearest, IsSuggestedAtTheEndOfAMessage) {
  EXPECT_EQ(did_you_mean("patern", {"rays", "patterns"}), "; did you mean \"patterns\"?");
  EXPECT_EQ(did_you_mean("x", {"y"}), "");
}

}  // namespace
