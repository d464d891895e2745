// Lines folded for a narrow page, and colours.
#include "run/output/terminal_page.hpp"

#include <sstream>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "run/output/name_ranges.hpp"

namespace kusabi::run {
namespace {

using testing::ElementsAre;

std::vector<std::string> words_of(const std::string& text) {
  std::istringstream in(text);
  std::vector<std::string> list;
  for (std::string word; in >> word;) list.push_back(word);
  return list;
}

std::vector<std::string> lines_of(const std::string& text) {
  std::istringstream in(text);
  std::vector<std::string> list;
  for (std::string line; std::getline(in, line);) list.push_back(line);
  return list;
}

TEST(Page, DoesNotFoldLinesOfFiles) {
  const std::string text(500, 'x');
  EXPECT_EQ(folded(text + " y\n", Page::endless), text + " y\n");
  EXPECT_EQ(folded("short\n\n  lines\n", 20), "short\n\n  lines\n");
}

TEST(Page, ContinuesListsBelowTheLastColumn) {
  EXPECT_THAT(lines_of(folded("    1   4.9e-03  b13 t13 b23 t23 b33 t33\n", 33)),
              ElementsAre("    1   4.9e-03  b13 t13 b23 t23", "                 b33 t33"));
  EXPECT_THAT(lines_of(folded("a sentence that is too long\n", 16)),
              ElementsAre("a sentence that", "is too long"));
  EXPECT_THAT(lines_of(folded("  what is indented stays it\n", 20)),
              ElementsAre("  what is indented", "    stays it"));
}

TEST(Page, KeepsAllWordsUnbroken) {
  const std::string text =
      "    1   4.885e-03  楔13 t13 b23…29 b33 t33 b43 t43\nIt can stick in 27 ways at friction "
      "coefficient 0.65, or at\n    in tension:     a-b c-d e-f g-h i-j k-l m-n o-p\n"
      "aVeryLongNameThatNoTerminalOfFortyColumnsShowsInOneLine here\n";
  for (const std::size_t width : {17U, 20U, 25U, 40U, 41U, 60U, 80U}) {
    const auto text_there = folded(text, width);
    EXPECT_EQ(words_of(text_there), words_of(text)) << width;
    for (const auto& line : lines_of(text_there)) {
      if (words_of(line).size() > 1) {
        EXPECT_LE(shown_width(line), width) << line;
      }
    }
  }
}

TEST(Page, MarksTextOnlyIfItHasColours) {
  const Page plain;
  EXPECT_EQ(plain.strong("yes"), "yes");
  EXPECT_EQ(plain.warning("no\n"), "no\n");
  const Page terminal{.width = 80, .colours = true};
  EXPECT_EQ(terminal.strong("yes"), "\033[1myes\033[0m");
  EXPECT_EQ(terminal.warning("no\n"), "\033[33mno\033[0m\n");
  EXPECT_EQ(terminal.warning(""), "");
}

TEST(Page, MarksHaveNoWidth) {
  const Page terminal{.width = 12, .colours = true};
  EXPECT_EQ(folded(terminal.strong("twelve chars"), 12), terminal.strong("twelve chars"));
}

}  // namespace
}  // namespace kusabi::run
