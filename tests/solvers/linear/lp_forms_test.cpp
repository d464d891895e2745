// Forms of LP files that are not read: each is named with its line.
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "solvers/linear/unsupported.hpp"
#include "support/input_error.hpp"

namespace kusabi::linear {
namespace {

using testing::HasSubstr;

std::string refusal(const std::string& text) {
  try {
    refuse_unsupported_lp(text, "t.lp");
  } catch (const support::InputError& error) {
    return error.what();
  }
  return "it was read";
}

std::string with(const std::string& objective, const std::string& rows) {
  return "\\ a comment: 3\nMinimize\n" + objective + "\nSubject To\n" + rows +
         "\nBounds\n -1 <= x <= 3\n y free\nBinary\n b\nEnd\n";
}

TEST(LpForms, NamesConstantsOfTheObjective) {
  for (const char* objective : {" obj: x + 2 b + 4", " obj: 4 + x", " obj: x - 4\n + b", " 7"}) {
    EXPECT_THAT(refusal(with(objective, " c: x + b >= 1")),
                HasSubstr("t.lp:3: a constant in the objective; expected terms"))
        << objective;
  }
  EXPECT_THAT(refusal(with(" obj: x\n + 2.5e1", " c: x >= 1")), HasSubstr("t.lp:4: a constant"));
}

TEST(LpForms, NamesAnEmptyObjective) {
  EXPECT_THAT(refusal(with(" obj:", " c: x >= 1")),
              HasSubstr("t.lp:3: an objective without terms; expected at least one term"));
  EXPECT_THAT(refusal(with("", " c: x >= 1")), HasSubstr("t.lp:2: an objective without terms"));
}

TEST(LpForms, NamesRanges) {
  EXPECT_THAT(
      refusal(with(" x", " c: x >= 1\n -1 <= x - b <= 3")),
      HasSubstr("t.lp:6: a range, with a number on the left-hand side; expected one sense"));
  EXPECT_THAT(refusal(with(" x", " d: x - b >= -1 <= 3\n c: x >= 1")),
              HasSubstr("t.lp:5: a range, with two senses"));
}

TEST(LpForms, NamesConstantsAndTermsOnTheWrongSide) {
  EXPECT_THAT(refusal(with(" x", " c: x + 3 >= 1")),
              HasSubstr("t.lp:5: a constant on the left-hand side of a row"));
  for (const char* row : {" c: x >= 1 + b", " c: x >= 2 b", " c: x >= b"}) {
    EXPECT_THAT(refusal(with(" x", row)), HasSubstr("t.lp:5: terms on the right-hand side")) << row;
  }
}

TEST(LpForms, AcceptsWhatIsRead) {
  EXPECT_EQ(refusal(with(" obj: 2x - 3 y + 1e-3b\n + 4 z(1)",
                         " c1: x + 2 y\n  - b >= -1\n c2: 3 x <= 4 c3: y = +2.5\n x + y < 3\n"
                         " - x + b => - 4")),
            "it was read");
  EXPECT_EQ(refusal("max x\nst\n c: x <= 1\nend\n"), "it was read");
}

}  // namespace
}  // namespace kusabi::linear
