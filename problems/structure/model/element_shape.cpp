// Table of shapes, in the order of ElementShape.
#include "problems/structure/model/element_shape.hpp"

#include <cstddef>

namespace kusabi::problems {
namespace {

using Points = std::span<const NaturalPoint<double>>;

// The vertices, and the midpoints of 1-2, 2-3, 3-1.
constexpr std::array<NaturalPoint<double>, 6> triangle{
    {{0, 0}, {1, 0}, {0, 1}, {0.5, 0}, {0.5, 0.5}, {0, 0.5}}};

// The vertices, and the midpoints of 1-2, 2-3, 3-4, 4-1.
constexpr std::array<NaturalPoint<double>, 8> quadrilateral{
    {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}, {0, -1}, {1, 0}, {0, 1}, {-1, 0}}};

// The vertices, and the midpoints of 1-2, 2-3, 3-1, 1-4, 2-4, 3-4.
constexpr std::array<NaturalPoint<double>, 10> tetrahedron{{{0, 0, 0},
                                                            {1, 0, 0},
                                                            {0, 1, 0},
                                                            {0, 0, 1},
                                                            {0.5, 0, 0},
                                                            {0.5, 0.5, 0},
                                                            {0, 0.5, 0},
                                                            {0, 0, 0.5},
                                                            {0.5, 0, 0.5},
                                                            {0, 0.5, 0.5}}};

// The vertices of the face zeta = -1 and of the face zeta = 1, the midpoints of the edges of both
// from vertex 1 on, and those of the edges between them.
constexpr std::array<NaturalPoint<double>, 20> hexahedron{
    {{-1, -1, -1}, {1, -1, -1}, {1, 1, -1},  {-1, 1, -1}, {-1, -1, 1}, {1, -1, 1}, {1, 1, 1},
     {-1, 1, 1},   {0, -1, -1}, {1, 0, -1},  {0, 1, -1},  {-1, 0, -1}, {0, -1, 1}, {1, 0, 1},
     {0, 1, 1},    {-1, 0, 1},  {-1, -1, 0}, {1, -1, 0},  {1, 1, 0},   {-1, 1, 0}}};

// The vertices of the faces zeta = -1 and zeta = 1, the midpoints of the edges of both from vertex
// 1 on, and those of the edges between them.
constexpr std::array<NaturalPoint<double>, 15> prism{{{0, 0, -1},
                                                      {1, 0, -1},
                                                      {0, 1, -1},
                                                      {0, 0, 1},
                                                      {1, 0, 1},
                                                      {0, 1, 1},
                                                      {0.5, 0, -1},
                                                      {0.5, 0.5, -1},
                                                      {0, 0.5, -1},
                                                      {0.5, 0, 1},
                                                      {0.5, 0.5, 1},
                                                      {0, 0.5, 1},
                                                      {0, 0, 0},
                                                      {1, 0, 0},
                                                      {0, 1, 0}}};

// Vertices of the base, then the apex, with which all points with zeta = 0 coincide.
constexpr std::array<NaturalPoint<double>, 5> pyramid{
    {{-1, -1, -1}, {1, -1, -1}, {1, 1, -1}, {-1, 1, -1}, {0, 0, 0}}};

constexpr std::array<ShapeTraits, 11> shapes{
    {{"three-node triangle", 2, ShapeFamily::simplex, false, 3, Points(triangle).first<3>()},
     {"six-node triangle", 2, ShapeFamily::simplex, true, 3, Points(triangle)},
     {"four-node quadrilateral", 2, ShapeFamily::product, false, 4,
      Points(quadrilateral).first<4>()},
     {"eight-node quadrilateral", 2, ShapeFamily::product, true, 4, Points(quadrilateral)},
     {"four-node tetrahedron", 3, ShapeFamily::simplex, false, 4, Points(tetrahedron).first<4>()},
     {"ten-node tetrahedron", 3, ShapeFamily::simplex, true, 4, Points(tetrahedron)},
     {"eight-node hexahedron", 3, ShapeFamily::product, false, 8, Points(hexahedron).first<8>()},
     {"twenty-node hexahedron", 3, ShapeFamily::product, true, 8, Points(hexahedron)},
     {"six-node prism", 3, ShapeFamily::prism, false, 6, Points(prism).first<6>()},
     {"fifteen-node prism", 3, ShapeFamily::prism, true, 6, Points(prism)},
     {"five-node pyramid", 3, ShapeFamily::pyramid, false, 5, Points(pyramid)}}};

}  // namespace

const ShapeTraits& shape_traits(ElementShape shape) {
  return shapes.at(static_cast<std::size_t>(shape));
}

std::optional<ElementShape> shape_of(int dimension, std::size_t nodes) {
  for (std::size_t shape = 0; shape < shapes.size(); ++shape) {
    if (shapes[shape].dimension == dimension && shapes[shape].nodes.size() == nodes) {
      return static_cast<ElementShape>(shape);
    }
  }
  return {};
}

}  // namespace kusabi::problems
