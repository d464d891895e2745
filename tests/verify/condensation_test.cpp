// Enclosure of K from a structure: it contains the closed form, and its radius is tiny.
#include "verify/structure/condensation.hpp"

#include <cmath>
#include <string>
#include <variant>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "nodes/evidence/verified_structure.hpp"
#include "problems/wedged/wedged_problem.hpp"
#include "searched.hpp"

namespace kusabi::verify {
namespace {

using testing::HasSubstr;

EnclosedMatrix condensed(const Structure& structure) {
  const auto result = condensed_stiffness(structure);
  if (const auto* why = std::get_if<std::string>(&result)) {
    ADD_FAILURE() << *why;
    return {};
  }
  return std::get<EnclosedMatrix>(result);
}

mpq_class entry(const EnclosedMatrix& matrix, std::size_t i, std::size_t j) {
  return matrix.middle.entries[matrix.middle.size * i + j].rational();
}

// The true K, row by row, is within `matrix`, whose radius is small.
void expect_holds(const EnclosedMatrix& matrix, const std::vector<mpq_class>& truth) {
  ASSERT_EQ(matrix.middle.entries.size(), truth.size());
  mpq_class square_of_distance = 0;
  mpq_class square_of_size = 0;
  for (std::size_t at = 0; at < truth.size(); ++at) {
    const mpq_class difference = matrix.middle.entries[at].rational() - truth[at];
    square_of_distance += difference * difference;
    square_of_size += truth[at] * truth[at];
  }
  const auto radius = matrix.radius.rational();
  EXPECT_LE(square_of_distance, radius * radius);
  EXPECT_LT(radius.get_d(), 1e-35 * std::sqrt(square_of_size.get_d()));
}

// A tip on a horizontal chain of two bars, and on a vertical bar; the chain's middle is supported
// by a vertical bar as well.
Structure chain(double near, double far, double upright) {
  Structure structure;
  structure.dimension = 2;
  structure.names = {"wall", "middle", "tip", "below middle", "below tip"};
  structure.coordinates = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {1, -1, 0}, {2, -1, 0}};
  structure.fixed.assign(5, {true, true, false});
  structure.fixed[1] = structure.fixed[2] = {false, false, false};
  structure.bars = {
      {0, 1, far, 0, 0}, {1, 2, near, 0, 0}, {1, 3, upright, 0, 0}, {2, 4, upright, 0, 0}};
  ContactPoint tip;
  tip.node = 2;
  tip.normal = {-3, 0, 0};
  structure.contact = {tip};
  return structure;
}

TEST(Condensation, ContainsTheClosedFormOfTwoBars) {
  const auto structure = evidence::verified_structure(example_structure("two-bars.toml"));
  expect_holds(condensed(structure), {2, 1, 1, 2});
}

// The load is as small as it may be beside another one; K and E'f of the other are known.
TEST(Condensation, ContainsLoadsOfAnyRatio) {
  const auto structure = chain(1, 1, 0.75);
  const ForceList forces{{2, {0x1p40, 0, 0}}, {2, {0, 0x1p-1060, 0}}};
  const auto found = loaded_stiffness(structure, std::vector<ForceList>{forces});
  const auto& load = std::get<LoadedStiffness>(found).loads.front();
  const mpq_class error = load.error.rational();
  EXPECT_LE(abs(load.forces[0].rational() + mpq_class(0x1p40)), error);
  EXPECT_LE(abs(load.forces[1].rational()), error + mpq_class(0x1p-1060));
}

TEST(Condensation, ContainsTheStiffnessOfBarsInARowAtAnyContrast) {
  for (const double contrast : {1.0, 3.0, 1e3, 1e6, 1e9, 1e12}) {
    for (const bool stiff_at_the_tip : {false, true}) {
      const double near = stiff_at_the_tip ? contrast : 1;
      const double far = stiff_at_the_tip ? 1 : contrast;
      const mpq_class k1(near);
      const mpq_class k2(far);
      expect_holds(condensed(chain(near, far, 0.75)),
                   {mpq_class(k1 * k2 / (k1 + k2)), 0, 0, mpq_class(0.75)});
    }
  }
}

TEST(Condensation, DoesNotDependOnTheUnits) {
  for (const double unit : {1e-40, 1e-9, 1e9, 1e40}) {
    const mpq_class k1(unit);
    const mpq_class k2(3 * unit);
    expect_holds(condensed(chain(unit, 3 * unit, unit)),
                 {mpq_class(k1 * k2 / (k1 + k2)), 0, 0, k1});
  }
}

// A vertex of a square whose other vertices are fixed: the entries have closed forms.
TEST(Condensation, ContainsTheClosedFormOfASquareElement) {
  Structure structure;
  structure.dimension = 2;
  structure.names = {"a", "b", "c", "d"};
  structure.coordinates = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  structure.fixed.assign(4, {true, true, false});
  structure.fixed[0] = {false, false, false};
  ContactPoint corner;
  corner.normal = {1, 0, 0};
  corner.tangent = Vector{5, 7, 0};  // minus its component along n: (0, 1)
  structure.contact = {corner};
  Element square;
  square.nodes = {0, 1, 2, 3};
  square.ratio = 0.25;
  square.thickness = 2;
  square.modulus = 15;  // E t/(1 - nu^2) = 32; (3 - nu)/6 = 11/24; (1 + nu)/8 = 5/32
  structure.elements = {square};
  expect_holds(condensed(structure), {mpq_class(44, 3), 5, 5, mpq_class(44, 3)});
  // Plane strain: nu' = nu/(1 - nu) = 1/3, E' = E/(1 - nu^2); E' t/(1 - nu'^2) = 12.
  structure.elements[0].modulus = 5;
  structure.elements[0].plane_strain = true;
  expect_holds(condensed(structure), {mpq_class(16, 3), 2, 2, mpq_class(16, 3)});
  // With the opposite orientation, and as two halves, one upon the other.
  structure.elements[0].nodes = {3, 2, 1, 0};
  structure.elements[0].thickness = 1;
  structure.elements.push_back(structure.elements[0]);
  expect_holds(condensed(structure), {mpq_class(16, 3), 2, 2, mpq_class(16, 3)});
}

// Compared with the solver's own K in double precision: other code, other formulas.
TEST(Condensation, IsNearTheStiffnessOfTheSolver) {
  for (const auto* name : {"space-truss.toml", "plane-truss.toml", "elastic-body.toml"}) {
    const auto problem = example(name);
    const auto matrix = condensed(evidence::verified_structure(example_structure(name)));
    const double size = problem.compliance.stiffness.norm();
    ASSERT_EQ(matrix.middle.size, static_cast<std::size_t>(problem.compliance.stiffness.rows()));
    for (Eigen::Index i = 0; i < problem.compliance.stiffness.rows(); ++i) {
      for (Eigen::Index j = 0; j < problem.compliance.stiffness.cols(); ++j) {
        EXPECT_NEAR(entry(matrix, static_cast<std::size_t>(i), static_cast<std::size_t>(j)).get_d(),
                    problem.compliance.stiffness(i, j), 1e-11 * size);
      }
    }
    EXPECT_LT(matrix.radius.nearest(), 1e-35 * size);
  }
}

// Rotated by the angle of the triangle 3, 4, 5, coordinates are integers again and K is the same.
TEST(Condensation, DoesNotDependOnTheAxes) {
  const auto straight = chain(2, 7, 1);
  auto turned = straight;
  for (auto& place : turned.coordinates) {
    place = {3 * place[0] - 4 * place[1], 4 * place[0] + 3 * place[1], 0};
  }
  turned.contact[0].normal = {-6, -8, 0};
  // Five times as long, a fifth as stiff.
  expect_holds(condensed(turned), {mpq_class(14, 45), 0, 0, mpq_class(1, 5)});
}

TEST(Condensation, IsExactlyZeroBetweenPieces) {
  auto structure = chain(2, 7, 1);
  const auto other = chain(1e6, 5, 3);
  const auto shift = structure.coordinates.size();
  for (std::size_t node = 0; node < other.coordinates.size(); ++node) {
    structure.names.push_back("other " + other.names[node]);
    structure.coordinates.push_back(
        other.coordinates[node]);  // at the same place, but not connected
    structure.fixed.push_back(other.fixed[node]);
  }
  for (auto bar : other.bars) {
    bar.first += shift;
    bar.second += shift;
    structure.bars.push_back(bar);
  }
  structure.contact.push_back(other.contact[0]);
  structure.contact[1].node += shift;
  structure.contact[1].normal = {1, 1, 0};
  const auto matrix = condensed(structure);
  for (const std::size_t i : {0U, 1U}) {
    for (const std::size_t j : {2U, 3U}) EXPECT_EQ(entry(matrix, i, j), 0);
  }
  EXPECT_NE(entry(matrix, 2, 3), 0);
}

TEST(Condensation, RefusesAMechanismAndABarWithoutLength) {
  auto mechanism = chain(1, 1, 1);
  mechanism.bars.erase(mechanism.bars.begin() + 2);
  EXPECT_THAT(std::get<std::string>(condensed_stiffness(mechanism)), HasSubstr("mechanism"));
  auto pinned = chain(1, 1, 1);
  pinned.coordinates[3] = {1, 0, 0};  // the upright below the middle has length zero
  EXPECT_THAT(std::get<std::string>(condensed_stiffness(pinned)), HasSubstr("no length"));
  auto near = chain(1, 1, 1);
  near.bars[2].axial_stiffness = 1e-30;  // useless for supporting the middle, but not a mechanism
  const auto found = condensed_stiffness(near);
  EXPECT_TRUE(std::holds_alternative<EnclosedMatrix>(found));
}

}  // namespace
}  // namespace kusabi::verify
