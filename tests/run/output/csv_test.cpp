// Cells of CSV files: quotes, and texts that spreadsheets would compute.
#include "run/output/csv.hpp"

#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace kusabi::run {
namespace {

TEST(Csv, TextsAreInQuotes) {
  EXPECT_EQ(csv_cell("a, b"), "\"a, b\"");
  EXPECT_EQ(csv_cell("a \"b\""), "\"a \"\"b\"\"\"");
  EXPECT_EQ(csv_cell(""), "\"\"");
}

TEST(Csv, EscapesTextsThatAreFormulas) {
  EXPECT_EQ(csv_cell("=1+1"), "\"'=1+1\"");
  EXPECT_EQ(csv_cell("+a"), "\"'+a\"");
  EXPECT_EQ(csv_cell("-a"), "\"'-a\"");
  EXPECT_EQ(csv_cell("@a b"), "\"'@a b\"");
  EXPECT_EQ(csv_cell("a=1"), "\"a=1\"");
  std::ostringstream out;
  CsvWriter csv(out);
  csv.names(std::vector<std::string>{"=a", "=b"}).number(-1.5).end_row();
  EXPECT_EQ(out.str(), "\"'=a =b\",-1.5\n");
}

}  // namespace
}  // namespace kusabi::run
