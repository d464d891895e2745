// Unconstrained bodies, from the problem file to the proved critical coefficient, compared with
// statics: a block in a groove, a peg at two points, a bar across a corner, a plug.
#include <cmath>
#include <numbers>
#include <string>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "engine/transport/single_process.hpp"
#include "nodes/wedged/critical_search.hpp"
#include "problems/files/problem_text.hpp"
#include "problems/files/structure_file.hpp"
#include "problems/wedged/wedged_problem.hpp"
#include "wheel.hpp"

namespace kusabi::wedged {
namespace {

constexpr double degree = std::numbers::pi / 180;

CriticalFindings critical(const problems::Structure& structure) {
  engine::SingleProcess alone;
  engine::Analysis analysis(alone, {});
  const auto own = checked(structure);
  return find_critical_friction(analysis, own, problems::wedged_problem(own), {.width = 1e-8});
}

/// A trapezoid of height 1 whose sides lie on the walls of a groove.
problems::Structure in_groove(double theta, int across, int along, double ratio = 0.3) {
  const double top = 0.5 + std::tan(theta);
  const double c = std::cos(theta), s = std::sin(theta);
  return problems::read_structure(
      fmt::format("name = \"groove\"\ndimension = 2\nunits = {{ length = \"mm\", force = \"N\" }}\n"
                  "[[mesh]]\nname = \"b\"\ncorners = [[-0.5, 0], [0.5, 0], [{0}, 1], [-{0}, 1]]\n"
                  "divisions = [{1}, {2}]\nE = 1e3\nnu = {3}\nthickness = 1\nplane = \"strain\"\n"
                  "[[contact]]\nnodes = [\"b.left\"]\nnormal = [{4}, {5}]\n"
                  "[[contact]]\nnodes = [\"b.right\"]\nnormal = [-{4}, {5}]\n",
                  top, across, along, ratio, c, s),
      "groove.toml");
}

void expect_from(const CriticalFindings& found, double mu) {
  ASSERT_TRUE(found.bracket.upper);
  EXPECT_LT(found.bracket.at_least(), mu + 1e-12);
  EXPECT_GT(found.bracket.at_most(), mu - 1e-12);
  EXPECT_LE(found.bracket.at_most() - found.bracket.at_least(), 2.5e-8);
}

TEST(UnconstrainedBodies, WedgeInAGrooveFromTheTangentOfItsHalfAngle) {
  for (const double theta : {5 * degree, 15 * degree, 30 * degree}) {
    for (const int elements : {1, 2, 4}) {
      const auto found = critical(in_groove(theta, elements, elements));
      expect_from(found, std::tan(theta));
      EXPECT_TRUE(is_proved(found.bracket.lower) && is_proved(found.bracket.upper))
          << theta << " " << elements;
    }
  }
  // The coefficient does not depend on the material and the proportions.
  expect_from(critical(in_groove(20 * degree, 2, 5, 0.45)), std::tan(20 * degree));
  expect_from(critical(in_groove(20 * degree, 5, 2, 0.0)), std::tan(20 * degree));
}

// Whitney's two points: the line through both must be in both friction cones.
TEST(UnconstrainedBodies, PegJamsAtTwoPoints) {
  const auto found = critical(problems::read_structure(
      "name = \"peg\"\ndimension = 2\nunits = { length = \"mm\", force = \"N\" }\n"
      "[[mesh]]\nname = \"p\"\ncorners = [[0, 0], [1, 0], [1, 2], [0, 2]]\ndivisions = [2, 8]\n"
      "E = 1e3\nnu = 0.3\nthickness = 1\nplane = \"stress\"\n"
      "[[contact]]\nnodes = [\"p.0,0\"]\nnormal = [1, 0]\n"
      "[[contact]]\nnodes = [\"p.2,3\"]\nnormal = [-1, 0]\n",
      "peg.toml"));
  expect_from(found, 0.75);
}

TEST(UnconstrainedBodies, BarStandsAcrossACorner) {
  const auto found = critical(problems::read_structure(
      "name = \"bar\"\ndimension = 2\nunits = { length = \"m\", force = \"kN\" }\n"
      "[nodes]\nfloor = [0.8, 0]\nwall = [0, 0.6]\n"
      "[[members]]\nEA = 1\nbetween = [[\"floor\", \"wall\"]]\n"
      "[[contact]]\nnodes = [\"floor\"]\nnormal = [0, 1]\n"
      "[[contact]]\nnodes = [\"wall\"]\nnormal = [1, 0]\n",
      "bar.toml"));
  expect_from(found, 4.0 / 3);
}

TEST(UnconstrainedBodies, PlugStaysInAConeFromTheTangentOfItsHalfAngle) {
  const std::string file = std::string(KUSABI_SOURCE_DIR) + "/examples/morse-taper.toml";
  const auto structure = problems::read_structure(problems::problem_text(file), file);
  expect_from(critical(structure), std::tan(1.5 * degree));
}

// Two neighbours p, q of a wheel with three spokes in contact: with tangential displacements that
// differ by d, bar p-q has the force -d / (2 sqrt 3), and both other rim bars (2 - sqrt 3) times its
// opposite, so |r_t| = r_n. All three can have no reaction, since rim forces sum to zero.
TEST(UnconstrainedBodies, WheelOnAPinWedgesFromOneInAnyDirectionOfTheAxes) {
  for (const double turn : {0.0, 0.1, 0.7, 1.234}) {
    SCOPED_TRACE(turn);
    expect_from(critical(testing::wheel(3, turn)), 1);
  }
}

// Bodies supported from one side only are not wedged, however far they can move.
TEST(UnconstrainedBodies, OnAFloorDoNotWedge) {
  const auto structure = problems::read_structure(
      "name = \"floor\"\ndimension = 2\nunits = { length = \"mm\", force = \"N\" }\n"
      "[[mesh]]\nname = \"p\"\ncorners = [[0, 0], [1, 0], [1, 1], [0, 1]]\ndivisions = [3, 2]\n"
      "E = 1e3\nnu = 0.3\nthickness = 1\nplane = \"stress\"\n"
      "[[contact]]\nnodes = [\"p.bottom\"]\nnormal = [0, 1]\n",
      "floor.toml");
  const auto found = critical(structure);
  EXPECT_FALSE(found.bracket.upper);
}

}  // namespace
}  // namespace kusabi::wedged
