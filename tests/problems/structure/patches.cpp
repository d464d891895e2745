// Vertices on a grid, simplices by permutations of the axes, midpoints by the edges of each shape.
#include "patches.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <numeric>

#include "tests/problems/trusses.hpp"

namespace kusabi::problems::test {
namespace {

using Cell = std::array<int, 3>;  // place on the grid, in halves of a cell
constexpr int cells = 3;

double random_part(std::mt19937& bits) {
  return static_cast<double>(bits()) * 0x1p-31 - 1;
}

bool is_simplex(ElementShape shape) {
  return corners_of(shape) == dimension_of(shape) + 1;
}

/// Vertices of the elements of one cell, as places on the grid.
std::vector<std::vector<Cell>> elements_of(ElementShape shape, const Cell& cell) {
  const int d = dimension_of(shape);
  std::vector<std::vector<Cell>> elements;
  const auto at = [&](int i, int j, int k) {
    return Cell{2 * (cell[0] + i), 2 * (cell[1] + j), d == 3 ? 2 * (cell[2] + k) : 0};
  };
  if (shape == ElementShape::prism6 || shape == ElementShape::prism15) {
    for (const auto& [a, b] : {std::pair(0, 1), {1, 0}}) {  // both halves of the square
      auto& own = elements.emplace_back();
      for (int k = 0; k < 2; ++k) {
        for (const auto& [i, j] : {std::pair(0, 0), {b, a}, {1, 1}}) own.push_back(at(i, j, k));
      }
    }
    return elements;
  }
  if (shape == ElementShape::pyramid5) {  // from the centre of the cell to each of its faces
    for (const std::size_t axis : {0U, 1U, 2U}) {
      for (const int side : {-1, 1}) {
        auto& own = elements.emplace_back(5, at(0, 0, 0));
        for (auto& place : own) {
          for (int& component : place) ++component;
        }
        for (std::size_t vertex = 0; vertex < 4; ++vertex) {
          own[vertex][axis] += side;
          own[vertex][(axis + 1) % 3] += vertex == 1 || vertex == 2 ? side : -side;
          own[vertex][(axis + 2) % 3] += vertex < 2 ? 1 : -1;
        }
      }
    }
    return elements;
  }
  if (!is_simplex(shape)) {
    auto& own = elements.emplace_back();
    for (int k = 0; k < d - 1; ++k) {
      for (const auto& [i, j] : {std::pair(0, 0), {1, 0}, {1, 1}, {0, 1}})
        own.push_back(at(i, j, k));
    }
    return elements;
  }
  std::vector<int> axes(static_cast<std::size_t>(d));
  std::iota(axes.begin(), axes.end(), 0);
  do {  // from one vertex of the cell to the opposite one, axis by axis
    auto& own = elements.emplace_back();
    Cell place = at(0, 0, 0);
    own.push_back(place);
    for (const int axis : axes) {
      place[static_cast<std::size_t>(axis)] += 2;
      own.push_back(place);
    }
  } while (std::ranges::next_permutation(axes).found);
  return elements;
}

class PatchMaker {
 public:
  PatchMaker(ElementShape shape, double moved, std::mt19937& bits)
      : shape_(shape),
        moved_(moved / cells / (shape == ElementShape::pyramid5 ? 2 : 1)),
        bits_(bits),
        body_(empty_structure(dimension_of(shape))) {}

  Structure made() {
    const int layers = body_.dimension == 3 ? cells : 1;
    for (int k = 0; k < layers; ++k) {
      for (int j = 0; j < cells; ++j) {
        for (int i = 0; i < cells; ++i) {
          for (const auto& vertices : elements_of(shape_, {i, j, k})) add(vertices);
        }
      }
    }
    return std::move(body_);
  }

 private:
  void add(const std::vector<Cell>& vertices) {
    Element element{{}, 200.0, 0.3, 0.5, PlaneState::stress, shape_};
    for (const auto& vertex : vertices) element.nodes.push_back(corner_node(vertex));
    for (const auto& [a, b] : edges_of(shape_)) {
      element.nodes.push_back(middle_node(element.nodes[static_cast<std::size_t>(a)],
                                          element.nodes[static_cast<std::size_t>(b)]));
    }
    body_.elements.push_back(std::move(element));
  }

  int corner_node(const Cell& cell) {
    const auto found = corners_.find(cell);
    if (found != corners_.end()) return found->second;
    Eigen::VectorXd place(body_.dimension);
    for (Eigen::Index axis = 0; axis < place.size(); ++axis)
      place(axis) = cell[static_cast<std::size_t>(axis)] / (2 * double{cells});
    return corners_[cell] = add_moved(place, moved_);
  }

  int middle_node(int a, int b) {
    const auto edge = std::minmax(a, b);
    const auto found = middles_.find(edge);
    if (found != middles_.end()) return found->second;
    const Eigen::VectorXd place = (body_.coordinates.col(a) + body_.coordinates.col(b)) / 2;
    const bool straight = shape_ == ElementShape::tetrahedron10 || shape_ == ElementShape::prism15;
    return middles_[edge] = add_moved(place, straight ? 0 : moved_ / 3);
  }

  int add_moved(Eigen::VectorXd place, double by) {
    const bool within = (place.array() > 1e-9).all() && (place.array() < 1 - 1e-9).all();
    for (double& component : place) {
      if (within) component += by * random_part(bits_);
    }
    return add_node(body_, place);
  }

  ElementShape shape_;
  double moved_;
  std::mt19937& bits_;
  Structure body_;
  std::map<Cell, int> corners_;
  std::map<std::pair<int, int>, int> middles_;
};

}  // namespace

std::string name_of(ElementShape shape) {
  constexpr std::array names{"T3",   "T6",    "Q4",   "Q8",    "Tet4", "Tet10",
                             "Hex8", "Hex20", "Pri6", "Pri15", "Pyr5"};
  return names.at(static_cast<std::size_t>(shape));
}

int dimension_of(ElementShape shape) {
  return shape < ElementShape::tetrahedron4 ? 2 : 3;
}

bool is_quadratic(ElementShape shape) {
  return !edges_of(shape).empty();
}

int corners_of(ElementShape shape) {
  constexpr std::array vertices{3, 3, 4, 4, 4, 4, 8, 8, 6, 6, 5};
  return vertices.at(static_cast<std::size_t>(shape));
}

const std::vector<std::array<int, 2>>& edges_of(ElementShape shape) {
  using Edges = std::vector<std::array<int, 2>>;
  static const std::map<ElementShape, Edges> all{
      {ElementShape::triangle6, {{0, 1}, {1, 2}, {2, 0}}},
      {ElementShape::quadrilateral8, {{0, 1}, {1, 2}, {2, 3}, {3, 0}}},
      {ElementShape::tetrahedron10, {{0, 1}, {1, 2}, {2, 0}, {0, 3}, {1, 3}, {2, 3}}},
      {ElementShape::hexahedron20,
       {{0, 1},
        {1, 2},
        {2, 3},
        {3, 0},
        {4, 5},
        {5, 6},
        {6, 7},
        {7, 4},
        {0, 4},
        {1, 5},
        {2, 6},
        {3, 7}}},
      {ElementShape::prism15,
       {{0, 1}, {1, 2}, {2, 0}, {3, 4}, {4, 5}, {5, 3}, {0, 3}, {1, 4}, {2, 5}}}};
  static const Edges none;
  const auto found = all.find(shape);
  return found == all.end() ? none : found->second;
}

Structure patch(ElementShape shape, double moved, std::mt19937& bits) {
  return PatchMaker(shape, moved, bits).made();
}

Structure one_element(ElementShape shape, double moved, std::mt19937& bits) {
  const auto whole = patch(shape, moved, bits);
  auto element = whole.elements[whole.elements.size() / 2];
  Structure body = empty_structure(whole.dimension);
  for (int& node : element.nodes) node = add_node(body, whole.coordinates.col(node));
  body.elements = {element};
  return body;
}

bool on_surface(const Structure& structure, int node) {
  const auto place = structure.coordinates.col(node).array();
  return (place < 1e-9).any() || (place > 1 - 1e-9).any();
}

}  // namespace kusabi::problems::test
