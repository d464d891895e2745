// Stiffness matrices from files: a brick by CalculiX compared with the same mesh here, in all
// formats of matrices; and the keys of [[stiffness]].
#include <functional>
#include <sstream>
#include <string>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "problems/files/matrices/matrix_market.hpp"
#include "problems/files/problem_text.hpp"
#include "problems/files/structure_file.hpp"
#include "problems/structure/assembly/solid_element.hpp"
#include "problems/structure/model/truss.hpp"
#include "problems/wedged/wedged_problem.hpp"
#include "tests/problems/files/mesh_problems.hpp"
#include "tests/problems/trusses.hpp"

namespace kusabi::problems {
namespace {

using testing::HasSubstr;

/// CalculiX writes 13 digits, and its own K has lost one more.
constexpr double calculix_rounding = 1e-10;

/// The order of summation.
constexpr double summation_rounding = 1e-13;

const std::string touches_right =
    "[[contact]]\nnodes = [\"m.right\"]\nexcept = [\"m.bottom\"]\nnormal = \"surface\"\n";
const std::string clamped_below = "[[supports]]\nnodes = [\"m.bottom\"]\n";

std::string brick(const std::string& stiffness) {
  return test::head(3) + "[[mesh]]\nname = \"m\"\nfile = \"box-hex8-41.msh\"\n" + stiffness +
         touches_right;
}

ProblemText with_rows(const std::string& toml) {
  auto problem = test::with_meshes(toml);
  problem.meshes["box-hex8-stored.dof"] = test::content("tests/meshes/box-hex8-stored.dof");
  return problem;
}

WedgedProblem own_brick() {
  return wedged_problem(checked(test::read(test::head(3) + test::mesh_of("box-hex8-41.msh", 3) +
                                           clamped_below + touches_right)));
}

WedgedProblem own_brick_held_but_for_6_and_7() {
  return wedged_problem(checked(test::read(
      test::head(3) + test::mesh_of("box-hex8-41.msh", 3) +
      "[[supports]]\nnodes = [\"m.box\"]\nexcept = [\"m.6\", \"m.7\"]\n" + touches_right)));
}

TEST(StiffnessFile, OfCalculiXEqualsTheStiffnessOfTheMesh) {
  for (const char* name : {"box-hex8-substructure.mtx", "box-hex8-stored.sti"}) {
    const Structure structure = read_structure(
        with_rows(brick(fmt::format("[[stiffness]]\nmesh = \"m\"\nfile = \"{}\"\n", name))),
        "test.toml");
    const bool is_stored = name == std::string("box-hex8-stored.sti");
    // In its substructures all nodes except the retained ones, 6 and 7, are fixed: see the warning.
    const auto expected = is_stored ? own_brick() : own_brick_held_but_for_6_and_7();
    EXPECT_EQ(structure.warnings.size(), is_stored ? 0U : 1U);
    const auto found = wedged_problem(checked(structure));
    EXPECT_TRUE(found.compliance.matrix.isApprox(expected.compliance.matrix, calculix_rounding))
        << name;
    EXPECT_TRUE(
        found.compliance.stiffness.isApprox(expected.compliance.stiffness, calculix_rounding))
        << name;
    EXPECT_EQ(found.contact_names, expected.contact_names);
    EXPECT_EQ(structure.superelements.front().rounding, is_stored ? 0.5e-13 : 0.5e-12);
  }
}

TEST(StiffnessFile, WithUnknownNodesIsCondensedToTheKnownOnes) {
  // Only the places of the two candidates of the brick are given.
  const auto toml = test::head(3) +
                    "[nodes]\n6 = [2, 0, 1]\n7 = [2, 1, 1]\n[[stiffness]]\nfile = "
                    "\"box-hex8-stored.sti\"\nothers = \"free\"\n[[contact]]\nnodes = [\"6\", "
                    "\"7\"]\nnormal = [-1, 0, 0]\n";
  const auto found = wedged_problem(read_structure(with_rows(toml), "test.toml"));
  EXPECT_TRUE(found.compliance.matrix.isApprox(own_brick().compliance.matrix, calculix_rounding));
}

// The claim of the first lines of the example.
TEST(StiffnessFile, OfTheExampleEqualsTheStiffnessOfItsMesh) {
  const auto name = test::source_path("examples/brick-by-calculix.toml");
  const Structure given = load_structure(name);
  EXPECT_TRUE(given.elements.empty());
  auto problem = problem_text(name);
  const auto replace = [&](const std::string& old, const std::string& by) {
    const auto at = problem.toml.find(old);
    ASSERT_NE(at, std::string::npos) << old;
    problem.toml.replace(at, old.size(), by);
  };
  replace("file = \"brick-by-calculix.msh\"\n",
          "file = \"brick-by-calculix.msh\"\nE = 210000\nnu = 0.3\n");
  replace("[[stiffness]]\nfile = \"brick-by-calculix.sti\"\nmesh = \"brick\"\n",
          "[[supports]]\nnodes = [\"brick.clamped\"]\n");
  const auto own = wedged_problem(read_structure(problem, name));
  const auto found = wedged_problem(checked(given));
  EXPECT_EQ(found.contact_names.size(), 6U);
  EXPECT_TRUE(found.compliance.matrix.isApprox(own.compliance.matrix, calculix_rounding));
}

/// The stiffness of the whole brick without supports, in the order of its nodes.
Eigen::MatrixXd unconstrained_stiffness() {
  const auto structure =
      test::read(test::head(3) + test::mesh_of("box-hex8-41.msh", 3) + touches_right);
  const Eigen::MatrixXd matrix = element_stiffness(structure, free_degrees(structure));
  return (matrix + matrix.transpose()) / 2;
}

/// A line for each selected entry.
std::string lines(const Eigen::MatrixXd& matrix, const std::string& form,
                  const std::function<bool(Eigen::Index, Eigen::Index)>& wanted, bool with_places) {
  std::string text;
  int count = 0;
  for (Eigen::Index column = 0; column < matrix.cols(); ++column) {
    for (Eigen::Index row = 0; row < matrix.rows(); ++row) {
      if (!wanted(row, column)) continue;
      if (with_places) text += fmt::format("{} {} ", row + 1, column + 1);
      text += fmt::format("{}\n", matrix(row, column));
      ++count;
    }
  }
  return fmt::format("%%MatrixMarket matrix {}\n% by hand\n\n{} {}{}\n{}", form, matrix.rows(),
                     matrix.cols(), with_places ? fmt::format(" {}", count) : "", text);
}

Structure with_matrix(const std::string& keys, const std::string& matrix,
                      const std::string& more = "") {
  auto problem =
      test::with_meshes(brick("[[stiffness]]\nfile = \"k.mtx\"\nmesh = \"m\"\n" + keys + more));
  problem.meshes["k.mtx"] = matrix;
  return read_structure(problem, "test.toml");
}

TEST(StiffnessFile, IsReadInEveryFormOfMatrixMarket) {
  const auto expected = own_brick();
  const Eigen::MatrixXd k = unconstrained_stiffness();
  const auto all = [](auto, auto) { return true; };
  const auto lower = [](auto row, auto column) { return row >= column; };
  const auto upper = [](auto row, auto column) { return row <= column; };
  const auto nonzero = [&](auto row, auto column) { return k(row, column) != 0; };
  std::ostringstream ours;
  write_matrix_market(ours, k, std::vector<std::string>{"ours"});
  for (const std::string& matrix :
       {lines(k, "array real general", all, false), lines(k, "array real symmetric", lower, false),
        lines(k, "coordinate real general", nonzero, true),
        lines(k, "coordinate double symmetric", lower, true),
        lines(k, "Coordinate Real Symmetric", upper, true), ours.str()}) {
    const auto found = wedged_problem(checked(with_matrix("", matrix, clamped_below)));
    EXPECT_TRUE(found.compliance.matrix.isApprox(expected.compliance.matrix, summation_rounding))
        << matrix.substr(0, 60);
  }
}

TEST(StiffnessFile, HasItsListedNodesAndRows) {
  // Two nodes with a free rotation, and a fixed one.
  const std::string matrix =
      "%%MatrixMarket matrix array integer symmetric\n8 8\n"
      "5\n0\n-1\n9\n0\n0\n0\n9\n"  // x of b, then y, free, fixed
      "6\n0\n9\n0\n0\n0\n9\n4\n9\n0\n0\n0\n9\n9\n0\n0\n0\n9\n"
      "7\n0\n0\n9\n8\n0\n9\n3\n9\n9\n";
  ProblemText problem{test::head(2) +
                          "[nodes]\na = [0, 0]\nb = [1, 0]\n[[stiffness]]\nfile = \"k.mtx\"\n"
                          "nodes = [\"b\", \"a\"]\nrows = [\"x\", \"y\", \"free\", \"held\"]\n",
                      {}};
  problem.meshes["k.mtx"] = matrix;
  const Structure structure = read_structure(problem, "test.toml");
  const auto& [rows, stiffness, own_rounding] = structure.superelements.front();
  EXPECT_EQ(own_rounding, 0);
  ASSERT_EQ(rows.size(), 6U);
  EXPECT_EQ(rows[0].node, 1);
  EXPECT_EQ(rows[2].node, -1);
  EXPECT_EQ(rows[4].node, 0);
  EXPECT_EQ(rows[4].axis, 1);
  Eigen::MatrixXd expected = Eigen::VectorXd{{5, 6, 4, 7, 8, 3}}.asDiagonal();
  expected(0, 2) = expected(2, 0) = -1;
  EXPECT_EQ(Eigen::MatrixXd(stiffness), expected);
}

TEST(StiffnessFile, IsMadeSymmetricWithAWarning) {
  Eigen::MatrixXd k = unconstrained_stiffness();
  k(3, 5) += 1e-14;
  const auto all = [](auto, auto) { return true; };
  const auto structure = with_matrix("", lines(k, "array real general", all, false), clamped_below);
  ASSERT_EQ(structure.warnings.size(), 1U);
  EXPECT_THAT(structure.warnings.front(),
              HasSubstr("k.mtx: the matrix deviates from symmetry by "));
  const auto& matrix = structure.superelements.front().stiffness;
  EXPECT_EQ(matrix.coeff(3, 5), matrix.coeff(5, 3));
}

std::string error_with(const std::string& keys, const std::string& more = "") {
  auto problem = test::with_meshes(test::head(3) + test::mesh_of("box-hex8-41.msh", 3) +
                                   "[[stiffness]]\nfile = \"k.mtx\"\n" + keys + more);
  problem.meshes["k.mtx"] = lines(
      unconstrained_stiffness(), "array real general", [](auto, auto) { return true; }, false);
  return test::error_of(problem);
}

TEST(StiffnessFile, RefusesNodesThatDoNotMatchItsRows) {
  EXPECT_THAT(error_with(""), HasSubstr("test.toml:9:1: a [[stiffness]] group has no nodes"));
  EXPECT_THAT(error_with("nodes = [\"m.1\"]\n"),
              HasSubstr("k.mtx:4:1: the matrix has 36 rows; expected 3: 1 nodes with 3 each"));
  EXPECT_THAT(error_with("nodes = [\"m.1\", \"m.77\"]\n"),
              HasSubstr("test.toml:11:17: node \"m.77\" does not exist"));
  EXPECT_THAT(error_with("nodes = [\"m.bottom\", \"m.right\", \"m.3\", \"m.4\"]\n"),
              HasSubstr("test.toml:11:22: node \"m.2\" is listed twice"));
  EXPECT_THAT(error_with("mesh = \"n\"\n"),
              HasSubstr("test.toml:11:8: no [[mesh]] is named \"n\""));
  EXPECT_THAT(error_with("mesh = \"m\"\nothers = \"free\"\n"),
              HasSubstr("test.toml:12:10: others is"));
  EXPECT_THAT(error_with("mesh = \"m\"\nrows = [\"x\", \"y\", \"y\"]\n"),
              HasSubstr("test.toml:12:19: rows has \"y\" twice"));
  EXPECT_THAT(error_with("mesh = \"m\"\nrows = [\"x\", \"y\", \"turn\"]\n"),
              HasSubstr("test.toml:12:19: a row is \"turn\"; expected \"x\", \"y\", \"z\", "
                        "\"free\" or \"held\""));
}

TEST(StiffnessFile, RefusesACandidateWithoutARow) {
  const auto toml = brick(
      "[[stiffness]]\nmesh = \"m\"\nfile = \"box-hex8-substructure.mtx\"\n[[contact]]\nnodes = "
      "[\"m.5\"]\nnormal = [0, 0, -1]\n");
  EXPECT_THAT(test::error_of(with_rows(toml)),
              HasSubstr("contact candidate \"m.5\" has no row in a [[stiffness]]"));
}

TEST(StiffnessFile, OfAnUnconstrainedBodyIsRefusedWithTheNamesOfItsNodes) {
  const auto all = [](auto, auto) { return true; };
  const auto structure =
      with_matrix("", lines(unconstrained_stiffness(), "array real general", all, false));
  try {
    wedged_problem(checked(structure));
    FAIL() << "a loose body was accepted";
  } catch (const support::InputError& error) {
    EXPECT_THAT(error.what(),
                HasSubstr("can move: a [[stiffness]] resists it only by the rounding"));
  }
}

}  // namespace
}  // namespace kusabi::problems
