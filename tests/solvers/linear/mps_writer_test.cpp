// Tests of the MPS writer: round trips through the own reader (other readers: tests/run/export).
#include "solvers/linear/mps_writer.hpp"

#include <random>
#include <sstream>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "solvers/linear/mps_file.hpp"

namespace kusabi::linear {
namespace {

using testing::StartsWith;

std::string written(const MixedProgram& mixed, const std::vector<std::string>& comments = {}) {
  std::ostringstream out;
  write_mps(out, mixed, comments);
  return out.str();
}

void expect_same(const MixedProgram& read, const MixedProgram& mixed) {
  const auto& before = mixed.program;
  const auto& after = read.program;
  EXPECT_EQ(after.constant, before.constant);
  EXPECT_EQ(read.binaries, mixed.binaries);
  ASSERT_EQ(after.columns.size(), before.columns.size());
  for (std::size_t k = 0; k < before.columns.size(); ++k) {
    EXPECT_EQ(after.columns[k].cost, before.columns[k].cost);
    EXPECT_EQ(after.columns[k].lower, before.columns[k].lower);
    EXPECT_EQ(after.columns[k].upper, before.columns[k].upper);
    EXPECT_EQ(after.columns[k].name, before.columns[k].name);
  }
  ASSERT_EQ(after.rows.size(), before.rows.size());
  for (std::size_t i = 0; i < before.rows.size(); ++i) {
    EXPECT_EQ(after.rows[i].lower, before.rows[i].lower);
    EXPECT_EQ(after.rows[i].upper, before.rows[i].upper);
    EXPECT_EQ(after.rows[i].name, before.rows[i].name);
  }
  const auto dense = [](const LinearProgram& program) {
    std::vector<std::vector<double>> matrix(program.rows.size(),
                                            std::vector<double>(program.columns.size()));
    for (const auto& [row, column, value] : program.entries) {
      matrix[static_cast<std::size_t>(row)][static_cast<std::size_t>(column)] = value;
    }
    return matrix;
  };
  EXPECT_EQ(dense(after), dense(before));
}

// Every kind of bound and of row; bounds of ranges are dyadic, so that their difference is exact.
MixedProgram random_program(std::mt19937& random) {
  std::normal_distribution<double> number;
  const auto chance = [&](int one_in) { return random() % static_cast<unsigned>(one_in) == 0; };
  MixedProgram mixed;
  auto& program = mixed.program;
  program.constant = chance(2) ? number(random) : 0;
  for (int k = 0; k < 12; ++k) {
    LinearColumn column{.cost = chance(3) ? 0 : number(random) * 1e9,
                        .name = "x" + std::to_string(k)};
    if (chance(4)) {
      column.upper = 1;
      mixed.binaries.push_back(k);
    } else {
      const double from = number(random);
      column.lower = chance(3) ? -infinity : from;
      column.upper = chance(3) ? infinity : from + (chance(3) ? 0 : 1 / 3.0);
    }
    program.add_column(column);
  }
  for (int i = 0; i < 9; ++i) {
    std::vector<LinearTerm> terms;
    for (int k = 0; k < 12; ++k) {
      if (chance(3)) terms.push_back({k, number(random) * 1e-7});
    }
    const double from = static_cast<double>(random() % 64) / 8 - 4;
    const double infinite[][2] = {{-infinity, number(random)},
                                  {number(random), infinity},
                                  {from, from},
                                  {from, from + 0.375}};
    const auto& [lower, upper] = infinite[random() % 4];
    program.add_row({lower, upper, "r" + std::to_string(i)}, terms);
  }
  return mixed;
}

TEST(MpsWriter, IsReadBackToTheLastBit) {
  std::mt19937 random(14);
  for (int time = 0; time < 200; ++time) {
    const auto mixed = random_program(random);
    const auto text = written(mixed);
    SCOPED_TRACE(text);
    const auto read = parse_mps(text, "t.mps");
    EXPECT_TRUE(read.warnings.empty());
    EXPECT_FALSE(read.maximise);
    expect_same(read.mixed, mixed);
    if (HasFailure()) return;
  }
}

TEST(MpsWriter, KeepsColumnsWithoutEntries) {
  MixedProgram mixed;
  mixed.program.add_column({.name = "alone"});
  const auto read = parse_mps(written(mixed), "t.mps").mixed;
  ASSERT_EQ(read.program.columns.size(), 1U);
  EXPECT_EQ(read.program.columns[0].name, "alone");
}

TEST(MpsWriter, NumbersColumnsWithNamesThatSomeReadersRefuse) {
  for (const std::string name : {"", "two words", "\xe7\xaf\x80", "$x", "'x", "OBJECTIVE", "y"}) {
    MixedProgram mixed;
    mixed.program.add_column({.cost = 1, .name = "y"});
    mixed.program.add_column({.cost = 2, .name = name});
    const auto read = parse_mps(written(mixed), "t.mps").mixed.program;
    EXPECT_EQ(read.columns.at(0).name, "c1") << name;
    EXPECT_EQ(read.columns.at(1).name, "c2") << name;
  }
}

TEST(MpsWriter, BeginsWithTheComments) {
  MixedProgram mixed;
  mixed.program.name = "a name";
  EXPECT_THAT(written(mixed, {"first", "second"}), StartsWith("* first\n* second\nNAME a_name\n"));
}

}  // namespace
}  // namespace kusabi::linear
