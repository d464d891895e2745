// Keys `against`, [[ties]], `direction` and `join` of problem files: their results. A mesh that is
// divided into two bodies and joined again has the same compliance.
#include <string>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "problems/files/structure_file.hpp"
#include "problems/files/toml/structure_writer.hpp"
#include "problems/structure/geometry/surface_place.hpp"
#include "problems/structure/model/element_shape.hpp"
#include "problems/wedged/wedged_problem.hpp"
#include "tests/problems/bodies.hpp"

namespace kusabi::problems {
namespace {

std::string block(const std::string& name, const std::string& vertices,
                  const std::string& divisions, const std::string& rest = "") {
  return fmt::format(
      "[[mesh]]\nname = \"{}\"\ncorners = {}\ndivisions = {}\nE = 2\nnu = 0.25\nthickness = 1\n"
      "plane = \"strain\"\n{}\n",
      name, vertices, divisions, rest);
}

const std::string header = "name = \"t\"\ndimension = 2\nunits = {length = \"m\", force = \"N\"}\n";

// A tapered peg between two blocks of a hole, which meet below it.
std::string peg_in_hole(int peg_rows, const std::string& right, const std::string& left) {
  return header + block("left", "[[-2, 0], [-0.5, 0], [-1, 2], [-2, 2]]", "[2, 4]") +
         block("floor", "[[-0.5, -1], [0.5, -1], [0.5, 0], [-0.5, 0]]", "[2, 2]") +
         block("below left", "[[-2, -1], [-0.5, -1], [-0.5, 0], [-2, 0]]", "[2, 2]") +
         block("below right", "[[0.5, -1], [2, -1], [2, 0], [0.5, 0]]", "[2, 2]") +
         block("right", "[[0.5, 0], [2, 0], [2, 2], [1, 2]]", "[2, 4]") +
         block("peg", "[[-0.75, 1], [0.75, 1], [1, 2], [-1, 2]]", fmt::format("[3, {}]", peg_rows),
               "join = false") +
         "[[supports]]\nnodes = [\"left.left\", \"right.right\", \"floor.bottom\"]\n"
         "[[supports]]\nnodes = [\"peg.1," +
         std::to_string(peg_rows) + "\"]\n" + "[[supports]]\nnodes = [\"peg.2," +
         std::to_string(peg_rows) +
         "\"]\ndirection = [1, 3]\n"
         "[[contact]]\nnodes = [\"peg.0,0\", \"peg.0,1\"]\nagainst = " +
         left +
         "\nnormal = [4, 1]\n[[contact]]\nnodes = [\"peg.3,0\", \"peg.3,1\"]\nagainst = " + right +
         "\nnormal = [-4, 1]\n";
}

double difference(const Structure& structure) {
  const Eigen::MatrixXd expected = test::compliance_by_multipliers(structure);
  const auto problem = wedged_problem(checked(structure));
  return (problem.compliance.matrix - expected).norm() / expected.norm();
}

TEST(PegInHole, HasTheSumOfBothCompliances) {
  const Structure structure =
      read_structure(peg_in_hole(2, "\"right.left\"", "[\"left.right\"]"), "peg");
  ASSERT_EQ(structure.contact.size(), 4U);
  for (const auto& candidate : structure.contact) {  // the nodes coincide: no weights
    ASSERT_EQ(candidate.against.size(), 1U);
    EXPECT_EQ(candidate.against[0].weight, 1);
    EXPECT_EQ(structure.coordinates.col(candidate.against[0].node),
              structure.coordinates.col(candidate.node));
    EXPECT_NE(candidate.against[0].node, candidate.node);
  }
  EXPECT_EQ(structure.inclined.size(), 1U);
  EXPECT_LE(difference(structure), 1e-11);
  EXPECT_EQ(wedged_problem(checked(structure)).contact_names.front(), "peg.0,0|left.2,2");
}

TEST(PegInHole, MayHaveItsNodesBetweenThoseOfTheHole) {
  const Structure structure =
      read_structure(peg_in_hole(4, "\"right.left\"", "\"left.right\""), "peg");
  const auto& shares = structure.contact[1].against;  // at a quarter: half-way between two
  ASSERT_EQ(shares.size(), 2U);
  EXPECT_EQ(shares[0].weight, 0.5);
  EXPECT_EQ(shares[1].weight, 0.5);
  EXPECT_LE(difference(structure), 1e-11);
}

TEST(PegInHole, IsWrittenAndReadBack) {
  Structure structure = read_structure(peg_in_hole(5, "\"right.left\"", "\"left.right\""), "peg");
  structure.ties.push_back({1, {{7, 0.1}, {8, 0.9}}});
  const auto again = read_structure(structure_text(structure), "again");
  EXPECT_EQ(wedged_fingerprint(again), wedged_fingerprint(structure));
  EXPECT_EQ(structure_text(again), structure_text(structure));
}

// A strip in one piece, and in two connected by constraints: node to node, and edge to edge.
TEST(MultiPointConstraints, JoinMeshes) {
  const auto strip = [](const std::string& join, const std::string& ties, int rows) {
    return wedged_problem(read_structure(
        header + block("a", "[[0, 0], [2, 0], [2, 1], [0, 1]]", "[4, 2]") +
            block("b", "[[2, 0], [3, 0], [3, 1], [2, 1]]", fmt::format("[2, {}]", rows), join) +
            "[[supports]]\nnodes = [\"a.left\"]\n" + ties +
            "[[contact]]\nnodes = [\"b.right\"]\nnormal = [-1, 0]\n",
        "strip"));
  };
  const auto whole = strip("", "", 2);
  const std::string join = "join = false";
  const auto by_nodes = strip(join, "[[ties]]\nnodes = [\"b.left\"]\nto = [\"a.right\"]\n", 2);
  EXPECT_LE((by_nodes.compliance.matrix - whole.compliance.matrix).norm(),
            1e-15 * whole.compliance.matrix.norm());
  const auto by_edge = strip(join, "[[ties]]\nnodes = [\"b.left\"]\nto = \"a.right\"\n", 2);
  EXPECT_EQ(by_nodes.compliance.matrix, by_edge.compliance.matrix);
  // A finer one is softer, but would be stiffer without constraints: not far from the whole.
  const auto finer = strip(join, "[[ties]]\nnodes = [\"b.left\"]\nto = \"a.right\"\n", 6);
  EXPECT_NEAR(finer.compliance.matrix(0, 0) / whole.compliance.matrix(0, 0), 1, 0.15);
  EXPECT_NE(finer.compliance.matrix(0, 0), whole.compliance.matrix(0, 0));
}

TEST(InclinedSupport, AlongAnAxisIsReadAsARoller) {
  const auto text = [](const std::string& support) {
    return header + block("a", "[[0, 0], [2, 0], [2, 1], [0, 1]]", "[2, 2]") +
           "[[supports]]\nnodes = [\"a.left\"]\n[[supports]]\nnodes = [\"a.2,0\"]\n" + support +
           "\n[[contact]]\nnodes = [\"a.2,2\"]\nnormal = [0, -1]\n";
  };
  for (const std::string axis : {"x", "y"}) {
    const auto along = axis == "x" ? "direction = [-2, 0]" : "direction = [0, 5]";
    EXPECT_EQ(wedged_problem(read_structure(text(along), "a")).provenance.fingerprint,
              wedged_problem(read_structure(text("fixed = [\"" + axis + "\"]"), "a"))
                  .provenance.fingerprint);
  }
}

// Hexahedra, tetrahedra and prisms of 20, 10 and 15 nodes at random places: midpoint nodes are
// between the vertices of their edges.
TEST(SurfacePlace, IsSoughtOnAllFacesOfElements) {
  Structure structure;
  structure.dimension = 3;
  std::vector<int> all(20);
  for (int i = 0; i < 20; ++i) all[static_cast<std::size_t>(i)] = i;
  for (const auto shape :
       {ElementShape::hexahedron20, ElementShape::tetrahedron10, ElementShape::prism15}) {
    const auto& traits = shape_traits(shape);
    structure.elements = {{{all.begin(), all.begin() + static_cast<long>(traits.nodes.size())},
                           1,
                           0,
                           1,
                           PlaneState::stress,
                           shape}};
    Eigen::MatrixXd places(3, traits.nodes.size());
    for (std::size_t i = 0; i < traits.nodes.size(); ++i)
      places.col(static_cast<Eigen::Index>(i)) = Eigen::Vector3d(traits.nodes[i].data());
    const auto faces = faces_within(structure, all);
    EXPECT_EQ(faces.size(), traits.family == ShapeFamily::simplex ? 4U
                            : traits.family == ShapeFamily::prism ? 5U
                                                                  : 6U);
    for (const auto& face : faces) {
      const std::size_t vertices = face.size() / 2;
      for (std::size_t side = 0; side < vertices; ++side) {
        const Eigen::Vector3d middle =
            (places.col(face[side]) + places.col(face[(side + 1) % vertices])) / 2;
        EXPECT_EQ(middle, places.col(face[vertices + side]));
      }
      // The node of each vertex is the place of that vertex alone.
      const auto place = nearest_place(places, {face}, places.col(face[1]));
      EXPECT_LE(place->distance, 1e-12);
      const auto between = nearest_place(places, {face}, places.col(face[vertices + 1]));
      ASSERT_EQ(between->shares.size(), 1U);
      EXPECT_EQ(between->shares[0].node, face[vertices + 1]);
    }
  }
}

// The nearest place of a curved edge, and of faces in space.
TEST(SurfacePlace, IsTheNearestPlaceOfTheSurface) {
  Eigen::MatrixXd arc(2, 3);
  arc << -1, 1, 0, 0, 0, 0.5;  // y = (1 - x^2)/2
  const auto on_arc = nearest_place(arc, {{0, 1, 2}}, Eigen::Vector2d(0.5, 0.375));
  ASSERT_TRUE(on_arc);
  EXPECT_LE(on_arc->distance, 1e-14);
  EXPECT_NEAR(on_arc->shares[0].weight, -0.125, 1e-12);
  EXPECT_NEAR(on_arc->shares[1].weight, 0.375, 1e-12);
  EXPECT_NEAR(on_arc->shares[2].weight, 0.75, 1e-12);
  EXPECT_NEAR(nearest_place(arc, {{0, 1, 2}}, Eigen::Vector2d(0, 0.75))->distance, 0.25, 1e-12);

  Eigen::MatrixXd faces(3, 7);
  faces << 0, 1, 1, 0, 0, 1, 0,  //
      0, 0, 1, 1, 0, 0, 1,       //
      0, 0, 0, 0, 5, 5, 5;
  const auto on_face =
      nearest_place(faces, {{4, 5, 6}, {0, 1, 2, 3}}, Eigen::Vector3d(0.25, 0.5, -0.125));
  ASSERT_TRUE(on_face);
  EXPECT_DOUBLE_EQ(on_face->distance, 0.125);
  ASSERT_EQ(on_face->shares.size(), 4U);
  EXPECT_EQ(on_face->shares[0].weight, 0.375);
  EXPECT_EQ(on_face->shares[1].weight, 0.125);
  const auto on_triangle = nearest_place(faces, {{4, 5, 6}}, Eigen::Vector3d(0.25, 0.5, 6));
  EXPECT_DOUBLE_EQ(on_triangle->distance, 1);
  EXPECT_EQ(on_triangle->shares[0].weight, 0.25);
  // Weights sum to one exactly in all cases.
  for (const double x : {0.1, 0.3, 0.7}) {
    double sum = 0;
    const auto place = nearest_place(faces, {{4, 5, 6}}, Eigen::Vector3d(x, 0.21, 5));
    for (const auto& share : place->shares) sum += share.weight;
    EXPECT_EQ(sum, 1);
  }
}

}  // namespace
}  // namespace kusabi::problems
