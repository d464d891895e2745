// XML escaping tests.
#include "pictures/xml_text.hpp"

#include <gtest/gtest.h>

namespace {

using kusabi::pictures::xml_comment;
using kusabi::pictures::xml_text;

TEST(XmlText, EscapesSpecialCharacters) {
  EXPECT_EQ(xml_text("a<b & \"c\">d"), "a&lt;b &amp; &quot;c&quot;&gt;d");
}

TEST(XmlText, KeepsCharactersOfSeveralBytes) {
  EXPECT_EQ(xml_text("µ 楔 \U0001F4D0"), "µ 楔 \U0001F4D0");
}

TEST(XmlText, ReplacesInvalidCharacters) {
  const char* const none = "\uFFFD";
  EXPECT_EQ(xml_text("\x01"), none);
  EXPECT_EQ(xml_text("\xE6\xA5"
                     "x"),
            std::string(none) + none + "x");                             // truncated
  EXPECT_EQ(xml_text("\xC0\xAF"), std::string(none) + none);             // overlong encoding
  EXPECT_EQ(xml_text("\xED\xA0\x80"), std::string(none) + none + none);  // surrogate
}

TEST(XmlText, CommentsContainNoDoubleDash) {
  EXPECT_EQ(xml_comment("a--b---"), "<!-- a- -b- - - -->\n");
  EXPECT_EQ(xml_comment(""), "");
}

}  // namespace
