// Prisms and pyramids of Gmsh and Abaqus. Prisms: one element of 15 nodes whose middle nodes are at
// the middles of its edges, in the orders of both manuals.
#include <string>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "problems/files/structure_file.hpp"
#include "tests/problems/files/mesh_problems.hpp"
#include "tests/problems/structure/patches.hpp"

namespace kusabi::problems::prism_mesh_test {
namespace {

using Edges = std::vector<std::pair<int, int>>;

/// The corners, and the middles of `edges`: "TAG X Y Z" with a separator.
std::vector<std::string> nodes(const Edges& edges, const std::string& separator) {
  const double places[6][3] = {{0, 0, 0}, {2, 0, 0}, {0, 4, 0}, {0, 0, 6}, {2, 0, 6}, {0, 4, 6}};
  std::vector<std::string> lines;
  const auto add = [&](auto place) {
    std::string line = std::to_string(lines.size() + 1);
    for (int axis = 0; axis < 3; ++axis) line += separator + std::to_string(place(axis));
    lines.push_back(line);
  };
  for (const auto& own : places) add([&](int axis) { return own[axis]; });
  for (const auto& [a, b] : edges)
    add([&, a = a, b = b](int axis) { return (places[a][axis] + places[b][axis]) / 2; });
  return lines;
}

std::string joined(const std::vector<std::string>& lines) {
  std::string text;
  for (const auto& line : lines) text += line + "\n";
  return text;
}

void expect_prism(const std::string& name, const std::string& text) {
  const ProblemText problem{test::head(3) + test::mesh_of(name, 3), {{name, text}}};
  const Structure structure = read_structure(problem, "test.toml");
  ASSERT_EQ(structure.elements.size(), 1U);
  const Element& element = structure.elements[0];
  ASSERT_EQ(element.shape, ElementShape::prism15);
  const auto place = [&](int number) {
    return structure.coordinates.col(element.nodes[static_cast<std::size_t>(number)]);
  };
  int middle = 6;
  for (const auto& [a, b] : test::edges_of(ElementShape::prism15))
    EXPECT_EQ(place(middle++), (place(a) + place(b)) / 2) << a << b;
}

TEST(Prism, OfGmshHasItsNodesInOrder) {
  const Edges edges{{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 4}, {2, 5}, {3, 4}, {3, 5}, {4, 5}};
  expect_prism("a.msh", "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n15\n" +
                            joined(nodes(edges, " ")) +
                            "$EndNodes\n$Elements\n1\n1 18 2 1 1 1 2 3 4 5 6 7 8 9 10 11 12 13 14 "
                            "15\n$EndElements\n");
}

TEST(Prism, OfAbaqusHasItsNodesInOrder) {
  const Edges edges{{0, 1}, {1, 2}, {2, 0}, {3, 4}, {4, 5}, {5, 3}, {0, 3}, {1, 4}, {2, 5}};
  expect_prism("a.inp", "*NODE\n" + joined(nodes(edges, ", ")) +
                            "*ELEMENT, TYPE=C3D15\n1, 1, 2, 3, 4, 5, 6, 7, 8, 9,\n10, 11, 12, 13, "
                            "14, 15\n");
}

/// Nodes of a face of the only element, which has these corners.
std::vector<std::string> nodes_of_face(const std::string& vertices, const std::string& type,
                                       const std::string& face) {
  const ProblemText problem{test::head(3) + test::mesh_of("a.inp", 3) +
                                "[[contact]]\nnodes = [\"m.s\"]\nnormal = \"surface\"\n",
                            {{"a.inp", "*NODE\n" + vertices + "*ELEMENT, TYPE=" + type +
                                           "\n*SURFACE, NAME=s\n1, " + face + "\n"}}};
  std::vector<std::string> names;
  const Structure structure = read_structure(problem, "test.toml");
  for (const auto& candidate : structure.contact)
    names.push_back(structure.node_names[static_cast<std::size_t>(candidate.node)]);
  return names;
}

// Faces as Abaqus numbers them: S1 and S2 are the triangles, S4 the one of nodes 2, 3, 6, 5.
TEST(Prism, HasTheFacesOfAbaqus) {
  const auto group = [](const std::string& face) {
    return nodes_of_face("1, 0, 0, 0\n2, 2, 0, 0\n3, 0, 4, 0\n4, 0, 0, 6\n5, 2, 0, 6\n6, 0, 4, 6\n",
                         "C3D6\n1, 1, 2, 3, 4, 5, 6", face);
  };
  EXPECT_THAT(group("S1"), testing::ElementsAre("m.1", "m.2", "m.3"));
  EXPECT_THAT(group("S2"), testing::ElementsAre("m.4", "m.5", "m.6"));
  EXPECT_THAT(group("S3"), testing::ElementsAre("m.1", "m.2", "m.4", "m.5"));
  EXPECT_THAT(group("S4"), testing::ElementsAre("m.2", "m.3", "m.5", "m.6"));
  EXPECT_THAT(group("S5"), testing::ElementsAre("m.1", "m.3", "m.4", "m.6"));
}

// S1 is the base, S2 the triangle on the edge of nodes 1 and 2, the others follow around it.
TEST(Pyramid, HasTheFacesOfAbaqus) {
  const auto group = [](const std::string& face) {
    return nodes_of_face("1, 0, 0, 0\n2, 2, 0, 0\n3, 2, 4, 0\n4, 0, 4, 0\n5, 1, 1, 3\n",
                         "C3D5\n1, 1, 2, 3, 4, 5", face);
  };
  EXPECT_THAT(group("S1"), testing::ElementsAre("m.1", "m.2", "m.3", "m.4"));
  EXPECT_THAT(group("S2"), testing::ElementsAre("m.1", "m.2", "m.5"));
  EXPECT_THAT(group("S3"), testing::ElementsAre("m.2", "m.3", "m.5"));
  EXPECT_THAT(group("S4"), testing::ElementsAre("m.3", "m.4", "m.5"));
  EXPECT_THAT(group("S5"), testing::ElementsAre("m.1", "m.4", "m.5"));
}

TEST(Pyramid, OfGmshHasItsNodesInOrder) {
  const ProblemText problem{
      test::head(3) + test::mesh_of("a.msh", 3),
      {{"a.msh",
        "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n5\n1 0 0 0\n2 2 0 0\n3 2 4 0\n4 0 4 0\n5 1 "
        "1 3\n$EndNodes\n$Elements\n1\n1 7 2 1 1 1 2 3 4 5\n$EndElements\n"}}};
  const Structure structure = read_structure(problem, "test.toml");
  ASSERT_EQ(structure.elements.size(), 1U);
  EXPECT_EQ(structure.elements[0].shape, ElementShape::pyramid5);
  EXPECT_EQ(structure.elements[0].nodes, (std::vector{0, 1, 2, 3, 4}));
}

}  // namespace
}  // namespace kusabi::problems::prism_mesh_test
