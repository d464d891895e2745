// Ranges of names.
#include "run/output/name_ranges.hpp"

#include <gtest/gtest.h>

namespace kusabi::run {
namespace {

TEST(NameRanges, AreFormedFromThreeNamesOn) {
  EXPECT_EQ(with_ranges({}), "-");
  EXPECT_EQ(with_ranges({"a"}), "a");
  EXPECT_EQ(with_ranges({"b.1,0", "b.2,0"}), "b.1,0 b.2,0");
  EXPECT_EQ(with_ranges({"b.1,0", "b.2,0", "b.3,0"}), "b.1…3,0");
  EXPECT_EQ(with_ranges({"x", "n8", "n9", "n10", "n11", "n13", "n14"}), "x n8…11 n13 n14");
}

TEST(NameRanges, VaryOneNumberOnly) {
  EXPECT_EQ(with_ranges({"2.7", "2.8", "2.9", "3.0"}), "2.7…9 3.0");
  EXPECT_EQ(with_ranges({"2.1", "3.1", "4.1", "5.2"}), "2…4.1 5.2");
  EXPECT_EQ(with_ranges({"1.1", "2.2", "3.3"}), "1.1 2.2 3.3");
}

TEST(NameRanges, KeepNamesThatFormNoRange) {
  EXPECT_EQ(with_ranges({"n01", "n02", "n03"}), "n01 n02 n03");
  EXPECT_EQ(with_ranges({"n0", "n1", "n2"}), "n0…2");
  EXPECT_EQ(with_ranges({"n3", "n2", "n1"}), "n3 n2 n1");
  const std::string huge = "n99999999999999999999999";
  EXPECT_EQ(with_ranges({huge, huge, huge}), huge + " " + huge + " " + huge);
}

TEST(NameRanges, HaveTheWidthOfTheirCharacters) {
  EXPECT_EQ(shown_width("b.1…3,0"), 7U);
  EXPECT_EQ(shown_width("楔"), 1U);
}

}  // namespace
}  // namespace kusabi::run
