// Tests of the MPS reader: each rule of docs/mps.md, with accepted and refused files.
#include <clocale>
#include <filesystem>
#include <fstream>
#include <string>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <zlib.h>

#include "solvers/linear/mps_file.hpp"
#include "support/input_error.hpp"

namespace kusabi::linear {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

// Column x with cost 2, y with cost 3; rows l, g, e.
std::string file(const std::string& sections, const std::string& head = "NAME T\n") {
  return head +
         "ROWS\n N c\n L l\n G g\n E e\nCOLUMNS\n x c 2 l 1\n x g 1 e 1\n y c 3 l 1\n y g -1\n" +
         sections + "ENDATA\n";
}

ProgramFile read(const std::string& text) {
  return parse_mps(text, "t.mps");
}

std::string refusal(const std::string& text) {
  try {
    read(text);
  } catch (const support::InputError& error) {
    return error.what();
  }
  return "it was read";
}

std::pair<double, double> ends(const ProgramFile& program, std::size_t row) {
  const auto& [lower, upper, name] = program.mixed.program.rows.at(row);
  return {lower, upper};
}

std::pair<double, double> bounds(const ProgramFile& program, std::size_t column) {
  const auto& at = program.mixed.program.columns.at(column);
  return {at.lower, at.upper};
}

using Ends = std::pair<double, double>;

TEST(Mps, ReadsRowsColumnsAndTheirEntries) {
  const auto read_file = read(file("RHS\n R l 4 g 1\n R e 2\n"));
  const auto& program = read_file.mixed.program;
  EXPECT_EQ(program.name, "T");
  EXPECT_FALSE(read_file.maximise);
  EXPECT_THAT(read_file.warnings, IsEmpty());
  ASSERT_THAT(program.columns, SizeIs(2));
  EXPECT_EQ(program.columns[1].name, "y");
  EXPECT_EQ(program.columns[0].cost, 2);
  EXPECT_EQ(program.columns[1].cost, 3);
  EXPECT_EQ(bounds(read_file, 0), Ends(0, infinity));
  ASSERT_THAT(program.rows, SizeIs(3));
  EXPECT_EQ(ends(read_file, 0), Ends(-infinity, 4));
  EXPECT_EQ(ends(read_file, 1), Ends(1, infinity));
  EXPECT_EQ(ends(read_file, 2), Ends(2, 2));
  ASSERT_THAT(program.entries, SizeIs(5));
  EXPECT_EQ(program.entries[3].row, 1);
  EXPECT_EQ(program.entries[3].column, 1);
  EXPECT_EQ(program.entries[3].value, -1);
}

TEST(Mps, TakesARightHandSideOfTheObjectiveForMinusTheConstant) {
  EXPECT_EQ(read(file("RHS\n R c -10\n")).mixed.program.constant, 10);
  EXPECT_EQ(read(file("RHS\n c -10\n")).mixed.program.constant, 10) << "without a set";
  const auto maximum = read(file("RHS\n R c -10\n", "OBJSENSE MAX\nNAME T\n"));
  EXPECT_TRUE(maximum.maximise);
  EXPECT_EQ(maximum.mixed.program.constant, -10) << "to be minimised";
  EXPECT_EQ(maximum.mixed.program.columns[0].cost, -2);
}

TEST(Mps, ReadsTheSenseInItsSectionAndBehindIt) {
  for (const char* head :
       {"OBJSENSE MAX\nNAME\n", "OBJSENSE\n    MAX\n", "OBJSENSE\n MAXIMIZE\nNAME T\n",
        "OBJSENSE\nMAX\n", "objsense\n maximise\n"}) {
    EXPECT_TRUE(read(file("", head)).maximise) << head;
  }
  for (const char* head : {"OBJSENSE MIN\n", "OBJSENSE\n MINIMIZE\n", "NAME T\n"}) {
    EXPECT_FALSE(read(file("", head)).maximise) << head;
  }
  EXPECT_THAT(refusal(file("", "OBJSENSE\n MOST\n")),
              HasSubstr("t.mps:2: the sense \"MOST\"; expected MAX or MIN"));
  EXPECT_THAT(refusal(file("", "OBJSENSE MAX\n MIN\n")), HasSubstr("t.mps:2: a second sense"));
}

TEST(Mps, ReadsTheFirstOrTheNamedRowOfTypeNAsTheObjective) {
  const std::string rows =
      "ROWS\n N a\n N b\n L l\nCOLUMNS\n x a 1 b 5\n x l 1\nRHS\n R b 7 l 1\nENDATA\n";
  const auto first = read(rows);
  EXPECT_EQ(first.mixed.program.columns[0].cost, 1);
  EXPECT_EQ(first.mixed.program.constant, 0);
  EXPECT_THAT(first.mixed.program.rows, SizeIs(1)) << "others are left out";
  const auto named = read("OBJNAME\n b\n" + rows);
  EXPECT_EQ(named.mixed.program.columns[0].cost, 5);
  EXPECT_EQ(named.mixed.program.constant, -7);
  EXPECT_THAT(refusal("OBJNAME l\n" + rows), HasSubstr("\"l\", which is not a row of type N"));
  EXPECT_THAT(refusal("ROWS\n L l\nCOLUMNS\n x l 1\nENDATA\n"),
              HasSubstr("no row of type N, the objective"));
}

TEST(Mps, ReadsRangesByTheirSign) {
  const std::string right = "RHS\n R l 4 g 1\n R e 2\n";
  const auto positive = read(file(right + "RANGES\n R l 3 g 3\n R e 3\n"));
  EXPECT_EQ(ends(positive, 0), Ends(1, 4));
  EXPECT_EQ(ends(positive, 1), Ends(1, 4));
  EXPECT_EQ(ends(positive, 2), Ends(2, 5));
  const auto negative = read(file("RANGES\n R l -3 g -3\n R e -3\n" + right));
  EXPECT_EQ(ends(negative, 0), Ends(1, 4)) << "its size alone; and before RHS";
  EXPECT_EQ(ends(negative, 1), Ends(1, 4));
  EXPECT_EQ(ends(negative, 2), Ends(-1, 2));
  EXPECT_EQ(ends(read(file(right + "RANGES\n R e 0\n")), 2), Ends(2, 2));
  EXPECT_EQ(ends(read(file(right + "RANGES\n R g 1e30\n")), 1), Ends(1, infinity));
  EXPECT_THAT(refusal(file("RANGES\n R c 3\n")),
              HasSubstr("a range of row \"c\", which is of type N; expected"));
  EXPECT_THAT(refusal(file("RANGES\n R e 3\n R e 3\n")), HasSubstr("a second range of row"));
}
// Bounds of the first column under a section of bounds.
auto of(const std::string& lines) {
  return bounds(read(file("BOUNDS\n" + lines)), 0);
}

TEST(Mps, ReadsBoundsOfAllTypes) {
  EXPECT_EQ(of(" LO B x 2\n"), Ends(2, infinity));
  EXPECT_EQ(of(" UP B x 2\n"), Ends(0, 2));
  EXPECT_EQ(of(" UP x 2\n"), Ends(0, 2)) << "without a set";
  EXPECT_EQ(of(" FX B x -2\n"), Ends(-2, -2));
  EXPECT_EQ(of(" FR B x\n"), Ends(-infinity, infinity));
  EXPECT_EQ(of(" FR x\n"), Ends(-infinity, infinity));
  EXPECT_EQ(of(" FR B x 0\n"), Ends(-infinity, infinity));
  EXPECT_EQ(of(" MI B x\n"), Ends(-infinity, infinity)) << "the upper bound stays";
  EXPECT_EQ(of(" MI B x\n UP B x -4\n"), Ends(-infinity, -4));
  EXPECT_EQ(of(" UP B x 4\n MI B x\n"), Ends(-infinity, 4));
  EXPECT_EQ(of(" PL B x\n"), Ends(0, infinity));
  EXPECT_EQ(of(" LO B x -5\n UP B x -1\n"), Ends(-5, -1));
  EXPECT_EQ(of(" UP B x 1e30\n"), Ends(0, infinity));
  EXPECT_EQ(of(" LO B x -1e30\n"), Ends(-infinity, infinity));
  EXPECT_EQ(of(" LO B x -inf\n UP B x +Infinity\n"), Ends(-infinity, infinity));
  EXPECT_EQ(of(" UP B x 1e400\n"), Ends(0, infinity));
  EXPECT_EQ(of(" UP B x 99999999999999999999\n"), Ends(0, infinity)) << "1e20, almost";
  EXPECT_EQ(of(" UP B x 1e19\n"), Ends(0, 1e19));
}

TEST(Mps, ReadsDecimalPointsInALocaleWithCommas) {
  if (std::setlocale(LC_ALL, "de_DE.UTF-8") == nullptr) GTEST_SKIP() << "no such locale here";
  EXPECT_EQ(of(" LO B x -2.5\n UP B x 1.5\n"), Ends(-2.5, 1.5));
  EXPECT_EQ(of(" LO B x 1.5e-400\n UP B x 1.5e400\n"), Ends(0, infinity));
  std::setlocale(LC_ALL, "C");
}

TEST(Mps, ReadsNumbersBeyondTheRangeOfDoubles) {
  EXPECT_EQ(of(" LO B x 1.5e-400\n UP B x 1.5e400\n"), Ends(0, infinity));
  EXPECT_EQ(of(" LO B x -1e5000\n UP B x 1e-5000\n"), Ends(-infinity, 0));
}

TEST(Mps, WarnsThatANegativeUpperBoundRemovesTheLowerBound) {
  const auto program = read(file("BOUNDS\n UP B x -2\n"));
  EXPECT_EQ(bounds(program, 0), Ends(-infinity, -2));
  EXPECT_THAT(program.warnings,
              ElementsAre(HasSubstr("t.mps:13: column \"x\" has the upper bound -2")));
  EXPECT_THAT(refusal(file("BOUNDS\n LO B x 0\n UP B x -2\n")),
              HasSubstr("column \"x\" has a lower bound of 0 and an upper bound of -2"));
  EXPECT_THAT(read(file("BOUNDS\n UP B x 0\n")).warnings, IsEmpty());
}

TEST(Mps, RecognisesBinaryColumns) {
  const auto integers = [](const std::string& lines) {
    return "ROWS\n N c\n L l\nCOLUMNS\n M1 'MARKER' 'INTORG'\n x c 2 l 1\n M2 'MARKER' 'INTEND'\n"
           " y c 3 l 1\nBOUNDS\n" +
           lines + "ENDATA\n";
  };
  EXPECT_THAT(read(integers(" UP B x 1\n")).mixed.binaries, ElementsAre(0));
  EXPECT_THAT(read(integers(" BV B x\n BV B y\n")).mixed.binaries, ElementsAre(0, 1));
  EXPECT_THAT(read(integers(" UI B x 1\n")).mixed.binaries, ElementsAre(0));
  // Integers also end with the section.
  EXPECT_THAT(read("ROWS\n N c\nCOLUMNS\n y c 1\n M 'MARKER' 'INTORG'\n x c 2\nRHS\n"
                   "BOUNDS\n UP B x 1\nENDATA\n")
                  .mixed.binaries,
              ElementsAre(1));
  EXPECT_THAT(read(integers(" LI B x 0\n UI B x 1\n")).mixed.binaries, ElementsAre(0));
  EXPECT_THAT(read(integers(" FX B x 3\n")).mixed.binaries, IsEmpty()) << "but fixed";
  EXPECT_THAT(read(integers(" FX B x 1\n UI B y 1\n")).mixed.binaries, ElementsAre(0, 1));
  EXPECT_THAT(refusal(integers(" UP B y 1\n")),
              HasSubstr("t.mps:6: integer column \"x\" has no bounds"));
  EXPECT_THAT(refusal(integers(" UP B x 7\n")),
              HasSubstr("t.mps:6: column \"x\" is a general integer, 0 to 7; expected"));
  EXPECT_THAT(refusal(integers(" PL B x\n")), HasSubstr("is a general integer, 0 to inf"));
}

TEST(Mps, ReadsFixedColumnsWithBlanksInNames) {
  const std::string fixed =
      "NAME          TWO WORDS\n"
      "ROWS\n"
      " N  COST\n"
      " L  ROW 1\n"
      "COLUMNS\n"
      "    THE X     COST               2.0   ROW 1              1.0\n"
      "    THE Y     COST               3.0   ROW 1             -1.0\n"
      "RHS\n"
      "    THE RHS   ROW 1              4.0\n"
      "BOUNDS\n"
      " UP THE BND   THE X              9.0\n"
      "ENDATA\n";
  const auto program = read(fixed);
  EXPECT_EQ(program.mixed.program.name, "TWO WORDS");
  EXPECT_EQ(program.mixed.program.columns[0].name, "THE X");
  EXPECT_EQ(bounds(program, 0), Ends(0, 9));
  EXPECT_EQ(ends(program, 0), Ends(-infinity, 4));
  auto wrong = fixed;
  wrong.replace(wrong.find("-1.0"), 4, "-1,0");
  EXPECT_THAT(refusal(wrong), HasSubstr("t.mps:7: \"-1,0\" is not a number"));
}

TEST(Mps, AcceptsByteOrderMarksCarriageReturnsCommentsTabsAndEmptyColumns) {
  const auto program = read(
      "\xEF\xBB\xBFNAME T\r\n* a comment\r\nROWS\r\n\tN\tc\r\n L l\r\n\r\nCOLUMNS\r\n x c 0\r\n"
      " y l 1 c 1\r\nRHS\r\n l 4\r\nENDATA\r\n");
  EXPECT_EQ(program.mixed.program.name, "T");
  ASSERT_THAT(program.mixed.program.columns, SizeIs(2));
  EXPECT_EQ(program.mixed.program.columns[0].cost, 0);
  EXPECT_EQ(ends(program, 0), Ends(-infinity, 4));
}

TEST(Mps, RefusesInvalidAndAmbiguousLinesByNumber) {
  const std::vector<std::pair<std::string, std::string>> wrong{
      {"", "t.mps:0: the file ends without ENDATA"},
      {"NAME T\nCOLUMNS\n x c 1\nENDATA\n", "t.mps:2: COLUMNS without a section ROWS before"},
      {"ROWS\n N c\nENDATA\n", "t.mps:3: ENDATA without a section COLUMNS before"},
      {"ROWS\n N c\nROWS\n", "t.mps:3: a second section ROWS"},
      {"ROWS\n X c\n", "t.mps:2: a row of type \"X\"; expected N, L, G or E"},
      {"ROWS\n N c d e\n", "t.mps:2: a row of another form"},
      {"ROWS\n N c\n N c\n", "t.mps:3: a second row \"c\""},
      {" N c\n", "t.mps:1: a line of no section"},
      {"ROWS more\n", "t.mps:1: \"more\" after ROWS"},
      {"PRIORITY\n", "t.mps:1: section \"PRIORITY\", which is not read"},
      {"SOS\n", "t.mps:1: \"SOS\": special ordered sets are not supported"},
      {file("QUADOBJ\n x x 1\n"), "t.mps:12: \"QUADOBJ\": quadratic terms are not supported"},
      {file("INDICATORS\n IF l y 1\n"), "t.mps:12: \"INDICATORS\": indicator constraints are"},
      {file(" x c 1\n"), "t.mps:12: column \"x\" comes again after another"},
      {file(" y c 1\n"), "t.mps:12: a second entry of column \"y\" in row \"c\""},
      {file(" z no 1\n"), "t.mps:12: \"no\" is not a row"},
      {file(" z c 1D3\n"), "t.mps:12: \"1D3\" is not a number"},
      {file(" z c 0x10\n"), "t.mps:12: \"0x10\" is not a number"},
      {file(" z c nan\n"), "t.mps:12: \"nan\" is not a number"},
      {file(" z c inf\n"), "t.mps:12: an entry that is not finite"},
      {file(" z c\n"), "t.mps:12: a column of another form"},
      {file(" M 'MARKER' 'INTEND'\n"), "t.mps:12: 'INTEND' without 'INTORG'"},
      {file(" M 'MARKER' 'SOSORG'\n"), "t.mps:12: \"SOSORG\": special ordered sets"},
      {file("RHS\n R l 4\n S g 1\n"), "t.mps:14: a second set \"S\" after \"R\""},
      {file("RHS\n R l 4\n R l 4\n"), "t.mps:14: a second right-hand side of row \"l\""},
      {file("RHS\n R g 1e30\n"), "t.mps:13: the right-hand side 1e+30 of row \"g\""},
      {file("BOUNDS\n SC B x 4\n"), "t.mps:13: \"SC\": semi-continuous columns are not supported"},
      {file("BOUNDS\n XX B x 4\n"), "t.mps:13: a bound of type \"XX\"; expected LO, UP"},
      {file("BOUNDS\n UP B z 4\n"), "t.mps:13: \"z\" is not a column"},
      {file("BOUNDS\n UP B x\n"), "t.mps:13: "},
      {file("BOUNDS\n UP B x 4\n UP C y 4\n"), "t.mps:14: a second set \"C\" after \"B\""},
      {file("BOUNDS\n UP B x 4\n UP B x 5\n"), "t.mps:14: a second upper bound of column \"x\""},
      {file("BOUNDS\n LO B x 1e30\n"), "t.mps:13: the bound 1e+30 leaves no value for column"},
      {file("BOUNDS\n LO B x 5\n UP B x 4\n"), "has a lower bound of 5 and an upper bound of 4"},
  };
  for (const auto& [text, message] : wrong) {
    const auto said = refusal(text);
    EXPECT_THAT(said, HasSubstr(message)) << text;
    EXPECT_THAT(said, HasSubstr("; expected ")) << text;
  }
}

TEST(Mps, ReadsCompressedFilesAndRefusesDamagedOnes) {
  const auto path = std::filesystem::temp_directory_path() / "kusabi-packed.mps.gz";
  const std::string text = file("RHS\n R l 4\n");
  auto* const packed = gzopen(path.c_str(), "wb");
  gzwrite(packed, text.data(), static_cast<unsigned>(text.size()));
  gzclose(packed);
  EXPECT_EQ(ends(read_program(path), 0), Ends(-infinity, 4));
  std::filesystem::resize_file(path, std::filesystem::file_size(path) - 10);
  EXPECT_THROW(read_program(path), support::InputError);
  std::filesystem::remove(path);
}

}  // namespace
}  // namespace kusabi::linear
