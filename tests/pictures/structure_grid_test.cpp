// Tests of structure grids, cell by cell and node by node.
#include "pictures/vtu/structure_grid.hpp"

#include <cmath>
#include <map>
#include <numeric>
#include <stdexcept>
#include <string>
#include <variant>
#include <vector>

#include <gtest/gtest.h>

#include "problems/structure/model/element_shape.hpp"

namespace {

using namespace kusabi::pictures;
using kusabi::problems::ElementShape;
using kusabi::problems::Structure;

// Two bars from a support to a tip that may have a load, and an unconnected node.
Structure corner() {
  Structure structure;
  structure.name = "corner";
  structure.dimension = 2;
  structure.node_names = {"foot", "side", "tip", "far"};
  structure.coordinates.resize(2, 4);
  structure.coordinates << 0, 4, 4, 9,  //
      0, 0, 3, 9;
  structure.members = {{0, 2, 2.0, {{7, 5}}}, {1, 2}};
  structure.fixed = {{true, true, false}, {false, true, false}, {}, {}};
  auto& candidate = structure.contact.emplace_back();
  candidate.node = 2;
  candidate.normal = Eigen::Vector2d(0.6, -0.8);
  candidate.friction = 0.5;
  return structure;
}

const Field& field(const std::vector<Field>& fields, const std::string& name) {
  for (const auto& each : fields) {
    if (each.name == name) return each;
  }
  throw std::runtime_error("no field " + name);
}

template <class Values = Eigen::MatrixXd>
const Values& values(const std::vector<Field>& fields, const std::string& name) {
  return std::get<Values>(field(fields, name).values);
}

TEST(StructureGrid, HasBarsFollowedByNodesWithoutBars) {
  const auto grid = structure_grid(corner());
  ASSERT_EQ(grid.cells.size(), 3U);
  EXPECT_EQ(grid.cells[1].type, CellType::line);
  EXPECT_EQ(grid.cells[1].points, (std::vector<int>{1, 2}));
  EXPECT_EQ(grid.cells[2].type, CellType::vertex);
  EXPECT_EQ(grid.cells[2].points, (std::vector<int>{3}));
  EXPECT_EQ(grid.points.col(2), Eigen::Vector3d(4, 3, 0));
}

TEST(StructureGrid, MarksSupportsAndCandidates) {
  const auto grid = structure_grid(corner());
  SmallNumbers fixed(3, 4);
  fixed << 1, 0, 0, 0,  //
      1, 1, 0, 0,       //
      0, 0, 0, 0;
  EXPECT_EQ(values<SmallNumbers>(grid.point_data, "fixed"), fixed);
  SmallNumbers candidate(1, 4);
  candidate << 0, 0, 1, 0;
  EXPECT_EQ(values<SmallNumbers>(grid.point_data, "candidate"), candidate);
  const auto& normal = values(grid.point_data, "normal");
  EXPECT_EQ(normal.col(2), Eigen::Vector3d(0.6, -0.8, 0));
  EXPECT_TRUE(normal.leftCols(2).isZero(0));
}

TEST(StructureGrid, HasContactStatesOfCandidatesOnly) {
  const auto states = contact_states(corner(), std::vector{ContactState::separated});
  SmallNumbers wanted(1, 4);
  wanted << 0, 0, 2, 0;
  EXPECT_EQ(std::get<SmallNumbers>(states.values), wanted);
}

TEST(StructureGrid, HasInclinedSupportsSpringsAndConstraints) {
  auto structure = corner();
  structure.inclined = {{2, Eigen::Vector2d(3, 4)}};
  structure.springs = {{1, 0, 5.0}, {1, 0, 2.0}};
  structure.ties = {{3, {{0, 0.5}, {1, 0.5}}}};
  const auto grid = structure_grid(structure);
  EXPECT_EQ(values(grid.point_data, "inclined_support").col(2), Eigen::Vector3d(0.6, 0.8, 0));
  EXPECT_EQ(values(grid.point_data, "spring").col(1), Eigen::Vector3d(7, 0, 0));
  SmallNumbers tied(1, 4);
  tied << 0, 0, 0, 1;
  EXPECT_EQ(values<SmallNumbers>(grid.point_data, "tied"), tied);
  EXPECT_THROW(field(structure_grid(corner()).point_data, "tied"), std::runtime_error);
}

TEST(StructureGrid, NumbersElementsBetweenBarsAndNodes) {
  auto structure = corner();
  structure.elements = {{.nodes = {0, 1, 2},
                         .modulus = 1,
                         .ratio = 0,
                         .thickness = 1,
                         .state = kusabi::problems::PlaneState::stress,
                         .shape = ElementShape::triangle3}};
  structure.outlines = structure.elements;
  const auto grid = structure_grid(structure);
  ASSERT_EQ(grid.cells.size(), 5U);
  const auto field = element_numbers(grid, structure, "pair", Eigen::Vector2d(7, 8));
  const auto& numbers = std::get<Eigen::MatrixXd>(field.values);
  for (Eigen::Index cell = 0; cell < 5; ++cell) {
    if (cell == 2) continue;
    EXPECT_TRUE(std::isnan(numbers(0, cell)) && std::isnan(numbers(1, cell))) << cell;
  }
  EXPECT_EQ(numbers.col(2), Eigen::Vector2d(7, 8));
}

TEST(UnsolvedGrid, HasLoadsAndStrengths) {
  using kusabi::problems::Load;
  auto structure = corner();
  structure.loads = {{Load::Kind::dead, 2, Eigen::Vector2d(0, -3)},
                     {Load::Kind::reference, 2, Eigen::Vector2d(1, 0)},
                     {Load::Kind::dead, 2, Eigen::Vector2d(0, -1)}};
  const auto grid = unsolved_grid(structure);
  EXPECT_EQ(values(grid.point_data, "dead_load").col(2), Eigen::Vector3d(0, -4, 0));
  EXPECT_EQ(values(grid.point_data, "reference_load").col(2), Eigen::Vector3d(1, 0, 0));
  EXPECT_EQ(values(grid.point_data, "friction")(0, 2), 0.5);
  // Components neither fixed nor loaded: x of "side", and both of "far".
  Eigen::MatrixXd uncertain(3, 4);
  uncertain << 0, 1, 0, 1,  //
      0, 0, 0, 1,           //
      0, 0, 0, 0;
  EXPECT_EQ(values(grid.point_data, "uncertain_load"), uncertain);
  const auto& stiffness = values(grid.cell_data, "axial_stiffness");
  EXPECT_EQ(stiffness(0, 0), 2);
  EXPECT_TRUE(std::isnan(stiffness(0, 1)));
  EXPECT_TRUE(std::isnan(stiffness(0, 2)));
  EXPECT_EQ(values(grid.cell_data, "yield_compression")(0, 0), 5);
}

// The type numbers are those of the VTK file formats (vtkCellType.h); the orders of nodes are
// tested with VTK itself.
TEST(StructureGrid, HasTheVtkTypeOfEveryShape) {
  const std::map<ElementShape, int> types{
      {ElementShape::triangle3, 5},      {ElementShape::triangle6, 22},
      {ElementShape::quadrilateral4, 9}, {ElementShape::quadrilateral8, 23},
      {ElementShape::tetrahedron4, 10},  {ElementShape::tetrahedron10, 24},
      {ElementShape::hexahedron8, 12},   {ElementShape::hexahedron20, 25},
      {ElementShape::prism6, 13},        {ElementShape::prism15, 26},
      {ElementShape::pyramid5, 14}};
  for (const auto& [shape, type] : types) {
    const auto& traits = kusabi::problems::shape_traits(shape);
    Structure structure;
    structure.dimension = traits.dimension;
    std::vector<int> nodes(traits.nodes.size());
    std::iota(nodes.begin(), nodes.end(), 0);
    structure.node_names.resize(nodes.size());
    structure.coordinates.setZero(traits.dimension, static_cast<Eigen::Index>(nodes.size()));
    structure.fixed.resize(nodes.size());
    structure.outlines = {{.nodes = nodes,
                           .modulus = 1,
                           .ratio = 0,
                           .thickness = 1,
                           .state = kusabi::problems::PlaneState::stress,
                           .shape = shape}};
    const auto grid = structure_grid(structure);
    ASSERT_EQ(grid.cells.size(), 1U) << traits.name;
    EXPECT_EQ(static_cast<int>(grid.cells[0].type), type) << traits.name;
    EXPECT_EQ(grid.cells[0].points, nodes) << traits.name;
  }
}

}  // namespace
