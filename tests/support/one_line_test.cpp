// Control characters of one byte, and of two in UTF-8, which some terminals obey.
#include "support/one_line.hpp"

#include <gtest/gtest.h>

namespace kusabi::support {
namespace {

TEST(OneLine, ControlCharactersAreShownByTheirBytes) {
  EXPECT_EQ(on_one_line("a b"), "a b");
  EXPECT_EQ(on_one_line("a\nb\x7f"), "a\\x0ab\\x7f");
  EXPECT_EQ(on_one_line("a\xc2\x85"), "a\xc2\\x85");  // U+0085, next line
}

TEST(OneLine, LettersOfSeveralBytesStay) {
  EXPECT_EQ(on_one_line("\xc2\xa0\xc3\x85\xe6\xa5\x94"), "\xc2\xa0\xc3\x85\xe6\xa5\x94");
}

}  // namespace
}  // namespace kusabi::support
