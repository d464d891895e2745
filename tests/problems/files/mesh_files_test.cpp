// Meshes written by Gmsh (tests/meshes/make): the resulting structures in all formats.
#include <algorithm>
#include <iterator>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "problems/files/structure_file.hpp"
#include "problems/structure/geometry/element_faces.hpp"
#include "problems/structure/geometry/face_geometry.hpp"
#include "problems/structure/geometry/surface.hpp"
#include "problems/structure/model/element_shape.hpp"
#include "problems/wedged/wedged_problem.hpp"
#include "tests/problems/files/mesh_problems.hpp"

namespace kusabi::problems {
namespace {

struct Written {
  const char* name;
  int dimension;
  std::size_t nodes;
  ElementShape shape;
  std::size_t elements;
};

// Nodes and elements where they can be counted by hand.
const std::vector<Written> all_written{{"plate-t3", 2, 0, ElementShape::triangle3, 0},
                                       {"plate-t6", 2, 0, ElementShape::triangle6, 0},
                                       {"quads-q4", 2, 20, ElementShape::quadrilateral4, 12},
                                       {"quads-q8", 2, 51, ElementShape::quadrilateral8, 12},
                                       {"box-tet4", 3, 0, ElementShape::tetrahedron4, 0},
                                       {"box-tet10", 3, 0, ElementShape::tetrahedron10, 0},
                                       {"box-hex8", 3, 12, ElementShape::hexahedron8, 2},
                                       {"box-hex20", 3, 32, ElementShape::hexahedron20, 2}};

std::string with_supports(const std::string& file, int dimension) {
  return test::head(dimension) + test::mesh_of(file, dimension) + "[[supports]]\nnodes = [\"m." +
         (dimension == 2 ? "left" : "bottom") + "\"]\n";
}

template <class Predicate>
std::vector<Written> written_where(Predicate predicate) {
  std::vector<Written> found;
  std::ranges::copy_if(all_written, std::back_inserter(found), predicate);
  return found;
}

std::string name_of(const testing::TestParamInfo<Written>& written) {
  std::string name = written.param.name;
  std::ranges::replace(name, '-', '_');
  return name;
}

class MeshFiles : public testing::TestWithParam<Written> {};
class CountedMeshFiles : public MeshFiles {};
class StraightMeshFiles : public MeshFiles {};

TEST_P(MeshFiles, OfBothVersionsGiveTheSameStructure) {
  const auto& [name, dimension, nodes, shape, elements] = GetParam();
  const std::string file = name;
  const Structure old = test::read(with_supports(file + "-22.msh", dimension));
  const Structure now = test::read(with_supports(file + "-41.msh", dimension));
  EXPECT_EQ(old.node_names, now.node_names);
  EXPECT_EQ(old.coordinates, now.coordinates);
  EXPECT_EQ(old.fixed, now.fixed);
  ASSERT_EQ(old.elements.size(), now.elements.size());
  for (std::size_t i = 0; i < old.elements.size(); ++i) {
    EXPECT_EQ(old.elements[i].nodes, now.elements[i].nodes);
    EXPECT_EQ(old.elements[i].shape, shape);
    EXPECT_EQ(now.elements[i].shape, shape);
  }
}

TEST_P(CountedMeshFiles, HaveAllNodesAndElements) {
  const auto& [name, dimension, nodes, shape, elements] = GetParam();
  const Structure structure = test::read(with_supports(std::string(name) + "-22.msh", dimension));
  EXPECT_EQ(structure.node_names.size(), nodes);
  EXPECT_EQ(structure.elements.size(), elements);
}

// Gmsh converts to the order of Abaqus when it writes .inp, this reader when it reads .msh.
TEST_P(MeshFiles, OfAbaqusGiveTheSameStructure) {
  const auto& [name, dimension, nodes, shape, elements] = GetParam();
  const std::string file = name;
  const Structure gmsh = test::read(with_supports(file + "-41.msh", dimension));
  const Structure abaqus = test::read(with_supports(file + ".inp", dimension));
  EXPECT_EQ(gmsh.node_names, abaqus.node_names);
  EXPECT_LT((gmsh.coordinates - abaqus.coordinates).cwiseAbs().maxCoeff(), 1e-12);
  EXPECT_EQ(gmsh.fixed, abaqus.fixed);
  ASSERT_EQ(gmsh.elements.size(), abaqus.elements.size());
  for (std::size_t i = 0; i < gmsh.elements.size(); ++i) {
    EXPECT_EQ(gmsh.elements[i].nodes, abaqus.elements[i].nodes);
  }
}

// In straight elements midpoint nodes are at midpoints up to Gmsh's error of 1e-12, which shows
// that their order is right.
TEST_P(StraightMeshFiles, HaveMidpointNodesAtTheMidpoints) {
  const auto& [name, dimension, nodes, shape, elements] = GetParam();
  const std::string file = name;
  for (const char* end : {"-22.msh", "-41.msh", ".inp"}) {
    const Structure structure = test::read(with_supports(file + end, dimension));
    for (const Element& element : structure.elements) {
      for (const auto& face : element_faces(shape)) {
        const auto vertices = static_cast<std::size_t>(std::ranges::count_if(
            face, [&, of = shape_traits(shape).vertices](int node) { return node < of; }));
        const auto place = [&](std::size_t node) -> Eigen::VectorXd {
          return structure.coordinates.col(element.nodes[static_cast<std::size_t>(face[node])]);
        };
        for (std::size_t side = 0; vertices + side < face.size(); ++side) {
          const Eigen::VectorXd middle = (place(side) + place((side + 1) % vertices)) / 2;
          EXPECT_LT((place(vertices + side) - middle).norm(), 1e-11) << file << end;
        }
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Gmsh, MeshFiles, testing::ValuesIn(all_written), name_of);
INSTANTIATE_TEST_SUITE_P(
    Gmsh, CountedMeshFiles,
    testing::ValuesIn(written_where([](const auto& each) { return each.nodes > 0; })), name_of);
INSTANTIATE_TEST_SUITE_P(Gmsh, StraightMeshFiles,
                         testing::ValuesIn(written_where([](const auto& each) {
                           return shape_traits(each.shape).quadratic &&
                                  !std::string(each.name).starts_with("plate");  // curved
                         })),
                         name_of);

TEST(MeshFile, OfABoxHasItsSurface) {
  for (const char* file : {"box-tet4", "box-tet10", "box-hex8", "box-hex20"}) {
    const Structure structure = test::read(with_supports(std::string(file) + "-41.msh", 3));
    double area = 0;
    const Surface surface(structure);
    for (const SurfaceFace& face : surface.faces()) {
      Eigen::MatrixXd places(3, static_cast<Eigen::Index>(face.nodes.size()));
      for (std::size_t i = 0; i < face.nodes.size(); ++i) {
        places.col(static_cast<Eigen::Index>(i)) = structure.coordinates.col(face.nodes[i]);
      }
      area += face_size(places);
    }
    EXPECT_NEAR(area, 10, 1e-12) << file;
  }
}

// The plate of the [[mesh]] of the same vertices and divisions, compared by its compliance.
TEST(MeshFile, OfQuadrilateralsIsTheStructuredMesh) {
  const std::string rest =
      "[[supports]]\nnodes = [\"m.left\"]\n[[contact]]\nnodes = [\"m.right\"]\n"
      "normal = [-2.0, 0.2]\n";
  const auto own = wedged_problem(read_structure(
      test::head(2) +
          "[[mesh]]\nname = \"m\"\ncorners = [[0, 0], [1.8, 0], [2, 2], [0, 2]]\n"
          "divisions = [4, 3]\nE = 1.0\nnu = 0.25\nthickness = 1.0\nplane = \"stress\"\n" +
          rest,
      "own"));
  for (const char* file : {"quads-q4-22.msh", "quads-q4-41.msh", "quads-q4.inp"}) {
    const auto read =
        wedged_problem(checked(test::read(test::head(2) + test::mesh_of(file, 2) + rest)));
    // From bottom to top in both: Gmsh's curve goes up.
    ASSERT_EQ(read.compliance.matrix.rows(), own.compliance.matrix.rows());
    EXPECT_LT((read.compliance.matrix - own.compliance.matrix).norm(),
              1e-12 * own.compliance.matrix.norm())
        << file;
  }
}

TEST(MeshFile, NamesNodesByTagAndGroupsByName) {
  const Structure structure = test::read(
      test::head(2) + test::mesh_of("plate-t3-41.msh", 2) +
      "[[supports]]\nnodes = [\"m.left\"]\n[[contact]]\nnodes = [\"m.curve.9\"]\n"
      "normal = [-1.0, 0.0]\n[[loads]]\nkind = \"dead\"\nnodes = [\"m.corner\"]\nforce = [1, 0]\n");
  EXPECT_EQ(structure.node_names.front(), "m.1");
  const auto place = [&](int node) -> Eigen::Vector2d { return structure.coordinates.col(node); };
  ASSERT_FALSE(structure.contact.empty());
  for (const auto& candidate : structure.contact) EXPECT_EQ(place(candidate.node).x(), 2);
  ASSERT_EQ(structure.loads.size(), 1U);
  EXPECT_EQ(place(structure.loads[0].node), Eigen::Vector2d(0, 0));
  for (std::size_t node = 0; node < structure.fixed.size(); ++node) {
    EXPECT_EQ(structure.fixed[node][0], place(static_cast<int>(node)).x() == 0);
  }
}

// A curve is listed in its own order, for any tags of its nodes.
TEST(MeshFile, ListsTheNodesOfACurveAlongIt) {
  for (const char* file : {"plate-t3-22.msh", "plate-t6-41.msh", "plate-t6.inp"}) {
    const Structure structure =
        test::read(test::head(2) + test::mesh_of(file, 2) +
                   "[[contact]]\nnodes = [\"m.bottom\"]\nexcept = [\"m.left\"]\n"
                   "normal = [0.0, 1.0]\n[[supports]]\nnodes = [\"m.left\"]\n");
    double before = 0;
    for (const auto& candidate : structure.contact) {
      EXPECT_GT(structure.coordinates(0, candidate.node), before);
      before = structure.coordinates(0, candidate.node);
    }
    EXPECT_EQ(before, 2);
  }
}

}  // namespace
}  // namespace kusabi::problems
