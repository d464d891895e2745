// `kusabi export` as a user calls it, with its files read by other programs: glpsol (Debian
// glpk-utils), python3-cvxopt and python3-scipy if installed.
#include <algorithm>
#include <cmath>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "shell.hpp"
#include "solvers/linear/program_file.hpp"
#include "solvers/linear/simplex.hpp"

namespace {

using kusabi::linear::LinearProgram;
using kusabi::linear::LinearStatus;
using kusabi::test::command;
using kusabi::test::content;
using kusabi::test::quoted;
using kusabi::test::ranks;
using kusabi::test::shell;
using nlohmann::json;
using testing::HasSubstr;
using testing::StartsWith;

const std::string python = "/usr/bin/python3";

bool has(const std::string& call) {
  return shell(call).exit_code == 0;
}

class ExportCommand : public kusabi::test::Command {
 protected:
  static std::string example(const std::string& name) {
    return quoted(std::string(KUSABI_SOURCE_DIR) + "/examples/" + name);
  }

  // Path of the exported file. @param call after `kusabi export`
  [[nodiscard]] std::string exported(const std::string& call, const std::string& name) const {
    const auto run =
        shell(command + " export " + call + " --output " + argument(name) + " --serial");
    EXPECT_EQ(run.exit_code, 0) << run.output;
    return in_folder(name);
  }

  [[nodiscard]] json result(const std::string& call) const {
    const auto run = shell(command + " " + call + " --output " + argument("result.json"));
    EXPECT_EQ(run.exit_code, 0) << run.output;
    return json::parse(content(in_folder("result.json")))["result"];
  }

  // Optimum by glpsol.
  [[nodiscard]] double by_glpsol(const std::string& file) const {
    const auto solved =
        shell("glpsol --freemps " + quoted(file) + " --tmlim 60 -w " + argument("glpsol.txt"));
    const auto text = content(in_folder("glpsol.txt"));
    const auto at = text.find(" = ", text.find("c Objective:"));
    EXPECT_NE(at, std::string::npos) << solved.output << text;
    EXPECT_THAT(text, HasSubstr("OPTIMAL"));
    return at == std::string::npos ? NAN : std::stod(text.substr(at + 3));
  }
};

int row_called(const LinearProgram& program, const std::string& name) {
  const auto at = std::ranges::find(program.rows, name, &kusabi::linear::LinearRow::name);
  return static_cast<int>(at - program.rows.begin());
}

// Least load factor over all vertices of the uncertain loads: a linear program (5) for each.
double min_over_corners(const LinearProgram& statics, const std::vector<std::string>& uncertain,
                        double alpha) {
  kusabi::linear::Simplex simplex(statics);
  double minimum = kusabi::linear::infinity;
  for (unsigned corner = 0; corner < 1U << uncertain.size(); ++corner) {
    for (std::size_t j = 0; j < uncertain.size(); ++j) {
      const int row = row_called(statics, "equilibrium." + uncertain[j]);
      EXPECT_LT(row, simplex.rows());
      const double nominal = statics.rows[static_cast<std::size_t>(row)].lower;
      const double load = nominal + ((corner >> j & 1) != 0 ? alpha : -alpha);
      simplex.set_row_bounds(row, load, load);
    }
    simplex.use_slack_basis();
    EXPECT_EQ(simplex.solve_robustly(), LinearStatus::optimal);
    minimum = std::min(minimum, -simplex.objective());
  }
  return minimum;
}

std::vector<std::string> uncertain_of(const LinearProgram& worst_case) {
  std::vector<std::string> names;
  const std::string before = "gamma.";
  for (const auto& column : worst_case.columns) {
    if (column.name.starts_with(before)) names.push_back(column.name.substr(before.size()));
  }
  return names;
}

TEST_F(ExportCommand, ZeroOneProgramHasTheFactorOfTheWorstVertex) {
  const auto truss = example("static-gap.toml");
  const auto worst = exported("mps " + truss + " --alpha 0.45", "worst.mps");
  const auto statics = exported("mps " + truss + " --program static", "static.mps");
  EXPECT_THAT(content(worst), HasSubstr("half-widths of 0.45 "));
  const auto uncertain = uncertain_of(kusabi::linear::read_program(worst).mixed.program);
  ASSERT_EQ(uncertain.size(), 7U);
  const double minimum =
      min_over_corners(kusabi::linear::read_program(statics).mixed.program, uncertain, 0.45);
  EXPECT_NEAR(result("mip " + quoted(worst))["objective"], minimum, 1e-8);
  EXPECT_NEAR(result("limit " + truss + " --alpha 0.45")["maximum"]["upper"]["value"], minimum,
              1e-8);
  if (!has("glpsol --version")) GTEST_SKIP() << "glpsol is not installed";
  EXPECT_NEAR(by_glpsol(worst), minimum, 1e-6);
}

// A named group of loads is multiplied by alpha, which has no unit then.
TEST_F(ExportCommand, GivesTheHalfWidthOfGroupsWithoutAUnit) {
  const auto file = exported("mps " + example("truss-bridge.toml") + " --alpha 1", "bridge.mps");
  EXPECT_THAT(content(file), HasSubstr("half-widths of 1 times their weights."));
}

// Truss and figure of the paper.
TEST_F(ExportCommand, ProgramOfThePaperHasItsPrintedOptimum) {
  const auto truss = example("paper/limit-3x3.toml");
  const auto worst = exported("mps " + truss + " --alpha 40", "worst.mps");
  EXPECT_NEAR(result("mip " + quoted(worst))["objective"], 37.0120, 5e-5);
}

TEST_F(ExportCommand, StaticAndKinematicProgramHaveTheLoadFactor) {
  const auto truss = example("paper/limit-3x3.toml");
  const auto statics = exported("mps " + truss + " --program static", "static.mps");
  const auto kinematic = exported("mps " + truss + " --program kinematic", "kinematic.mps");
  EXPECT_NEAR(result("mip " + quoted(statics))["objective"], -48.3662, 5e-5);
  EXPECT_NEAR(result("mip " + quoted(kinematic))["objective"], 48.3662, 5e-5);
  if (!has("glpsol --version")) GTEST_SKIP() << "glpsol is not installed";
  EXPECT_NEAR(by_glpsol(statics), -48.3662, 5e-5);
  EXPECT_NEAR(by_glpsol(kinematic), 48.3662, 5e-5);
}

TEST_F(ExportCommand, IsTheSameOnAnyNumberOfRanks) {
  const auto call = " export mps " + example("static-gap.toml") + " --alpha 0.45 --output ";
  EXPECT_EQ(shell(command + call + argument("alone.mps")).exit_code, 0);
  EXPECT_EQ(shell(ranks(2) + command + call + argument("both.mps")).exit_code, 0);
  EXPECT_EQ(content(in_folder("alone.mps")), content(in_folder("both.mps")));
}

class ExportCbf : public ExportCommand {
 protected:
  [[nodiscard]] double by_cvxopt(const std::string& file) const {
    const auto run = shell(
        python + " " + quoted(std::string(KUSABI_SOURCE_DIR) + "/tests/reference/cvxopt_cbf.py") +
        " " + quoted(file));
    EXPECT_EQ(run.exit_code, 0) << run.output;
    return run.exit_code == 0 ? std::stod(run.output) : NAN;
  }

  static std::string joined(const json& names) {
    std::string text;
    for (const auto& name : names) text += (text.empty() ? "" : ",") + name.get<std::string>();
    return kusabi::test::quoted(text);
  }
};

TEST_F(ExportCbf, HasTheMarginsOfPatternsByAnotherSolver) {
  if (!has(python + " -c 'import cvxopt'")) GTEST_SKIP() << "python3-cvxopt is not installed";
  for (const std::string& of :
       {example("plane-truss.toml") + " --mu 0.9", example("space-truss.toml") + " --mu 0.65"}) {
    const auto patterns = result("patterns " + of)["patterns"];
    ASSERT_GT(patterns.size(), 2U);
    for (std::size_t k = 0; k < std::min<std::size_t>(patterns.size(), 6); ++k) {
      const auto file =
          exported(fmt::format("cbf {} --contact {} --separated {}", of,
                               joined(patterns[k]["contact"]), joined(patterns[k]["separated"])),
                   "leaf.cbf");
      EXPECT_NEAR(by_cvxopt(file), patterns[k]["margin"], 1e-7) << content(file).substr(0, 300);
    }
    // The margin of every pattern is at most the margin of the root.
    const double root = by_cvxopt(exported("cbf " + of, "root.cbf"));
    for (const auto& pattern : patterns) EXPECT_GE(root, pattern["margin"].get<double>() - 1e-7);
  }
}

TEST_F(ExportCbf, RefusesInvalidNodes) {
  const auto refusal = [&](const std::string& options) {
    const auto run =
        shell(command + " export cbf " + example("plane-truss.toml") + " --mu 0.5 " + options);
    EXPECT_EQ(run.exit_code, 2) << run.output;
    return run.output;
  };
  EXPECT_THAT(refusal("--contact r1,r9"), HasSubstr("has no contact candidate 'r9'"));
  EXPECT_THAT(refusal("--contact r1,r9"), HasSubstr("'r9'; expected r1 or r2"));
  EXPECT_THAT(refusal("--contact r1 --separated r2,r1"),
              HasSubstr("--separated: r1 is also in --contact"));
  EXPECT_THAT(refusal("--separated r1,r2,r3,r4,r5"), HasSubstr("--separated: all candidates"));
}

class ExportMatrix : public ExportCommand {
 protected:
  using Rows = std::vector<std::vector<long double>>;

  // For `array real symmetric`.
  [[nodiscard]] static Rows read(const std::string& name) {
    std::ifstream file(name);
    std::string line;
    std::getline(file, line);
    EXPECT_EQ(line, "%%MatrixMarket matrix array real symmetric");
    while (file.peek() == '%') std::getline(file, line);
    std::size_t size = 0;
    std::size_t columns = 0;
    file >> size >> columns;
    EXPECT_EQ(size, columns);
    Rows rows(size, std::vector<long double>(size));
    for (std::size_t j = 0; j < size; ++j) {
      for (std::size_t i = j; i < size; ++i) {
        file >> rows[i][j];
        rows[j][i] = rows[i][j];
      }
    }
    EXPECT_TRUE(file) << "numbers are missing";
    std::string more;
    EXPECT_FALSE(file >> more) << more;
    return rows;
  }
};

// Bars of stiffness k = EA / l from the tip to the ground, at right angles: see the file. By hand.
TEST_F(ExportMatrix, HasTheStiffnessOfTwoBars) {
  const auto stiffness = read(exported("matrix " + example("two-bars.toml"), "K.mtx"));
  EXPECT_EQ(stiffness, (Rows{{2, 1}, {1, 2}}));
}

TEST_F(ExportMatrix, StiffnessAndComplianceAreInverse) {
  for (const char* const name : {"plane-truss.toml", "space-truss.toml", "elastic-body.toml"}) {
    const auto stiffness = read(exported("matrix " + example(name), "K.mtx"));
    const auto compliance =
        read(exported("matrix " + example(name) + " --matrix compliance", "F.mtx"));
    ASSERT_EQ(stiffness.size(), compliance.size());
    for (std::size_t i = 0; i < stiffness.size(); ++i) {
      for (std::size_t j = 0; j < stiffness.size(); ++j) {
        long double sum = 0;
        long double size = 0;
        for (std::size_t k = 0; k < stiffness.size(); ++k) {
          sum += stiffness[i][k] * compliance[k][j];
          size += std::abs(stiffness[i][k] * compliance[k][j]);
        }
        // Both are accurate to the last digit; the error of the sum is that of its terms.
        EXPECT_LE(std::abs(sum - (i == j ? 1 : 0)), 4e-16L * std::max(size, 1.0L)) << name;
      }
    }
  }
}

TEST_F(ExportMatrix, IsReadByScipy) {
  if (!has(python + " -c 'import scipy.io'")) GTEST_SKIP() << "python3-scipy is not installed";
  const auto file =
      exported("matrix " + example("two-bars.toml") + " --matrix compliance", "F.mtx");
  const auto run = shell(python +
                         " -c 'import sys, scipy.io; print((3 * scipy.io.mmread(sys.argv[1]))"
                         ".round(12).tolist())' " +
                         quoted(file));
  EXPECT_EQ(run.output, "[[2.0, -1.0], [-1.0, 2.0]]\n");
}

TEST_F(ExportCommand, PrintsUnlessGivenAFile) {
  const auto run = shell(command + " export matrix " + example("two-bars.toml") + " --serial");
  EXPECT_EQ(run.exit_code, 0);
  EXPECT_THAT(run.output, StartsWith("%%MatrixMarket"));
  EXPECT_THAT(run.output, HasSubstr("in kN/m"));
}

TEST_F(ExportCommand, RefusesIncompatibleOptions) {
  const auto refusal = [&](const std::string& options) {
    const auto run = shell(command + " export mps " + example("static-gap.toml") + options);
    EXPECT_EQ(run.exit_code, 2) << run.output;
    return run.output;
  };
  EXPECT_THAT(refusal(""), HasSubstr("requires --alpha"));
  EXPECT_THAT(refusal(" --program static --alpha 1"), HasSubstr("require --program worst-case"));
  EXPECT_THAT(refusal(" --big-m 5"), HasSubstr("--alpha"));
  // There is no least load factor: the load is not carried at any factor.
  EXPECT_THAT(refusal(" --alpha 1"), HasSubstr("or --big-m"));
}

}  // namespace
