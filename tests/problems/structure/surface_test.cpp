// Faces of elements, the surface of bodies, and its normals.
#include "problems/structure/geometry/surface.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "problems/structure/geometry/element_faces.hpp"
#include "problems/structure/geometry/face_geometry.hpp"
#include "problems/structure/model/element_shape.hpp"

namespace kusabi::problems {
namespace {

constexpr std::array shapes{
    ElementShape::triangle3,      ElementShape::triangle6,    ElementShape::quadrilateral4,
    ElementShape::quadrilateral8, ElementShape::tetrahedron4, ElementShape::tetrahedron10,
    ElementShape::hexahedron8,    ElementShape::hexahedron20, ElementShape::prism6,
    ElementShape::prism15,        ElementShape::pyramid5};

/// A structure of the element of which all others are images.
Structure reference_element(ElementShape shape) {
  const ShapeTraits& traits = shape_traits(shape);
  Structure structure;
  structure.dimension = traits.dimension;
  structure.coordinates.resize(traits.dimension, static_cast<Eigen::Index>(traits.nodes.size()));
  Element element{{}, 1, 0, 1, PlaneState::stress, shape};
  for (std::size_t node = 0; node < traits.nodes.size(); ++node) {
    for (int axis = 0; axis < traits.dimension; ++axis) {
      structure.coordinates(axis, static_cast<Eigen::Index>(node)) =
          traits.nodes[node][static_cast<std::size_t>(axis)];
    }
    element.nodes.push_back(static_cast<int>(node));
    structure.node_names.push_back(std::to_string(node));
  }
  structure.elements.push_back(element);
  return structure;
}

Eigen::MatrixXd places(const Structure& structure, const std::vector<int>& nodes) {
  Eigen::MatrixXd result(structure.dimension, static_cast<Eigen::Index>(nodes.size()));
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    result.col(static_cast<Eigen::Index>(i)) = structure.coordinates.col(nodes[i]);
  }
  return result;
}

std::vector<ElementShape> quadratic_shapes() {
  std::vector<ElementShape> found;
  std::ranges::copy_if(shapes, std::back_inserter(found),
                       [](ElementShape shape) { return shape_traits(shape).quadratic; });
  return found;
}

class Faces : public testing::TestWithParam<ElementShape> {};

// By the divergence theorem, from the faces alone: no part of the element is missing, no face has
// the opposite orientation.
TEST_P(Faces, EncloseTheElement) {
  const Structure structure = reference_element(GetParam());
  const int dimension = structure.dimension;
  double volume = 0;
  Eigen::VectorXd sum = Eigen::VectorXd::Zero(dimension);
  for (const auto& face : element_faces(GetParam())) {
    const Eigen::MatrixXd vertices = places(structure, face);
    const Eigen::VectorXd vector = face_size(vertices) * face_normal(vertices, 0);
    volume += face_centre(vertices).dot(vector) / dimension;
    sum += vector;
  }
  const auto family = shape_traits(GetParam()).family;
  const bool simplex = family == ShapeFamily::simplex;
  const double solid = family == ShapeFamily::prism     ? 1
                       : family == ShapeFamily::pyramid ? 4.0 / 3
                       : simplex                        ? 1.0 / 6
                                                        : 8;
  EXPECT_NEAR(volume, dimension == 2 ? (simplex ? 0.5 : 4) : solid, 1e-14);
  EXPECT_LT(sum.norm(), 1e-14);
}

class QuadraticFaces : public Faces {};

TEST_P(QuadraticFaces, HaveMidpointsAfterVertices) {
  const Structure structure = reference_element(GetParam());
  for (const auto& face : element_faces(GetParam())) {
    const Eigen::MatrixXd own = places(structure, face);
    const Eigen::Index vertices = structure.dimension == 2 ? 2 : own.cols() / 2;
    for (Eigen::Index side = 0; vertices + side < own.cols(); ++side) {
      const Eigen::VectorXd middle = (own.col(side) + own.col((side + 1) % vertices)) / 2;
      EXPECT_LT((own.col(vertices + side) - middle).norm(), 1e-14);
    }
  }
}

// For either orientation of the nodes, and at every node of a face.
TEST_P(Faces, PointOutwardsEvenIfTheElementIsMirrored) {
  for (const double mirror : {1.0, -1.0}) {
    Structure structure = reference_element(GetParam());
    structure.coordinates.row(0) *= mirror;
    const Surface surface(structure);
    ASSERT_EQ(surface.faces().size(), element_faces(GetParam()).size());
    const Eigen::VectorXd centre = structure.coordinates.rowwise().mean();
    for (std::size_t face = 0; face < surface.faces().size(); ++face) {
      const auto& nodes = surface.faces()[face].nodes;
      const Eigen::VectorXd out = face_centre(places(structure, nodes)) - centre;
      for (const int node : nodes) {
        EXPECT_GT(surface.normal(static_cast<int>(face), node).dot(out), 0);
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Shapes, Faces, testing::ValuesIn(shapes));
INSTANTIATE_TEST_SUITE_P(Shapes, QuadraticFaces, testing::ValuesIn(quadratic_shapes()));

// A quadratic edge is a parabola: y = x^2 here, with the slope 2x and a known length.
TEST(FaceGeometry, OfACurvedEdgeIsThatOfTheCurve) {
  Eigen::MatrixXd edge(2, 3);
  edge << -1, 1, 0, 1, 1, 0;
  EXPECT_LT((face_normal(edge, 0) - Eigen::Vector2d(-2, -1).normalized()).norm(), 1e-15);
  EXPECT_LT((face_normal(edge, 1) - Eigen::Vector2d(2, -1).normalized()).norm(), 1e-15);
  EXPECT_LT((face_normal(edge, 2) - Eigen::Vector2d(0, -1)).norm(), 1e-15);
  EXPECT_NEAR(face_size(edge), std::sqrt(5) + std::asinh(2) / 2, 0.03);  // three points
}

// z = x^2 + y^2 / 2 is in the space of both.
TEST(FaceGeometry, OfACurvedFaceIsThatOfTheSurface) {
  for (const auto shape : {ElementShape::triangle6, ElementShape::quadrilateral8}) {
    const Structure flat = reference_element(shape);
    Eigen::MatrixXd face(3, flat.coordinates.cols());
    face.topRows(2) = flat.coordinates;
    face.row(2) = face.row(0).cwiseAbs2() + face.row(1).cwiseAbs2() / 2;
    for (int node = 0; node < face.cols(); ++node) {
      const Eigen::Vector3d normal(-2 * face(0, node), -face(1, node), 1);
      EXPECT_LT((face_normal(face, node) - normal.normalized()).norm(), 1e-14) << node;
    }
  }
}

TEST(AngleFromCone, IsThatToTheNearestDirectionBetweenTheNormals) {
  const Eigen::VectorXd right = Eigen::Vector2d(1, 0);
  const Eigen::VectorXd up = Eigen::Vector2d(0, 1);
  const auto at = [](double degrees) -> Eigen::VectorXd {
    const double angle = degrees * std::acos(-1.0) / 180;
    return Eigen::Vector2d(std::cos(angle), std::sin(angle));
  };
  EXPECT_NEAR(angle_from_cone({right}, at(11)), 11, 1e-6);
  EXPECT_NEAR(angle_from_cone({right, up}, at(45)), 0, 1e-5);
  EXPECT_NEAR(angle_from_cone({right, up}, at(110)), 20, 1e-6);
  EXPECT_NEAR(angle_from_cone({right, up}, at(-70)), 70, 1e-6);
  EXPECT_NEAR(angle_from_cone({right}, at(180)), 180, 1e-5);
}

TEST(AngleFromCone, InSpaceMayBeToAFaceAnEdgeOrTheInsideOfTheCone) {
  const std::vector<Eigen::VectorXd> axes{Eigen::Vector3d::UnitX(), Eigen::Vector3d::UnitY(),
                                          Eigen::Vector3d::UnitZ()};
  EXPECT_NEAR(angle_from_cone(axes, Eigen::Vector3d(1, 2, 3).normalized()), 0, 1e-5);
  EXPECT_NEAR(angle_from_cone(axes, Eigen::Vector3d(1, 1, -std::sqrt(2)).normalized()), 45, 1e-6);
  EXPECT_NEAR(angle_from_cone(axes, Eigen::Vector3d(1, -1, -1).normalized()),
              std::acos(1 / std::sqrt(3)) * 180 / std::acos(-1.0), 1e-6);
}

// Two adjacent squares: their common face is inside, for any order of its nodes.
TEST(Surface, ExcludesFacesSharedByTwoElements) {
  Structure structure;
  structure.dimension = 2;
  structure.coordinates.resize(2, 6);
  structure.coordinates << 0, 1, 2, 0, 1, 2, 0, 0, 0, 1, 1, 1;
  structure.node_names = {"a", "b", "c", "d", "e", "f"};
  structure.elements = {{{0, 1, 4, 3}, 1, 0, 1, PlaneState::stress},
                        {{1, 4, 5, 2}, 1, 0, 1, PlaneState::stress}};
  const Surface surface(structure);
  EXPECT_EQ(surface.faces().size(), 6U);
  const auto all = [](const SurfaceFace&) { return true; };
  EXPECT_LT((*surface.mean_normal(1, all) - Eigen::Vector2d(0, -1)).norm(), 1e-15);
  EXPECT_LT((*surface.mean_normal(2, all) - Eigen::Vector2d(1, -1).normalized()).norm(), 1e-15);
}

}  // namespace
}  // namespace kusabi::problems
