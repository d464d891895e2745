// InputError tests: the message is one line for any quoted text.
#include "support/input_error.hpp"

#include <string>

#include <gtest/gtest.h>

namespace kusabi::support {
namespace {

TEST(InputError, SaysFileLineColumnAndMessage) {
  EXPECT_STREQ(InputError("a.toml", {3, 7}, "wrong; expected right").what(),
               "a.toml:3:7: wrong; expected right");
}

TEST(InputError, WithoutAPositionSaysTheFileOnly) {
  EXPECT_STREQ(InputError("a.toml", {}, "wrong").what(), "a.toml: wrong");
}

TEST(InputError, IsOneLineForAnyText) {
  EXPECT_STREQ(InputError("a\nb", {1, 1}, "two\r\nlines").what(),
               "a\\x0Ab:1:1: two\\x0D\\x0Alines");
}

TEST(InQuotes, EscapesQuotesBackslashesAndControlCharacters) {
  EXPECT_EQ(in_quotes("a\"b\\c\td"), "\"a\\\"b\\\\c\\x09d\"");
}

TEST(InQuotes, CutsLongTextBetweenCharacters) {
  EXPECT_EQ(in_quotes(std::string(40, 'x')), '"' + std::string(40, 'x') + '"');
  EXPECT_EQ(in_quotes(std::string(41, 'x')), '"' + std::string(40, 'x') + "...\"");
  // The second byte of the Greek letter would be the 41st: the whole letter is dropped.
  EXPECT_EQ(in_quotes(std::string(39, 'x') + "\u03BC" + "tail"),
            '"' + std::string(39, 'x') + "...\"");
}

}  // namespace
}  // namespace kusabi::support
