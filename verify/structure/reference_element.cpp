// Nodes, monomials and integration rules as tables; interpolation by the inverse of Vandermonde's
// matrix in rational numbers.
#include "verify/structure/reference_element.hpp"

#include <map>
#include <stdexcept>
#include <utility>

namespace kusabi::verify {
namespace {

using Exponents = std::array<int, 3>;
using Place = std::array<int, 3>;  // twice the natural coordinates
using Rationals = std::vector<std::vector<mpq_class>>;

struct Shape {
  std::size_t dimension;
  bool simplex;
  bool quadratic;
  bool prism;
  bool pyramid;
  std::vector<Place> nodes;
};

// Vertices first, then midpoints of edges, as in docs/problem-files.md.
Shape shape_of(std::size_t dimension, std::size_t count) {
  const std::vector<Place> triangle{{0, 0, 0}, {2, 0, 0}, {0, 2, 0},
                                    {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  const std::vector<Place> square{{-2, -2, 0}, {2, -2, 0}, {2, 2, 0}, {-2, 2, 0},
                                  {0, -2, 0},  {2, 0, 0},  {0, 2, 0}, {-2, 0, 0}};
  const std::vector<Place> tetrahedron{{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {0, 0, 2}, {1, 0, 0},
                                       {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {0, 1, 1}};
  const std::vector<Place> cube{{-2, -2, -2}, {2, -2, -2}, {2, 2, -2}, {-2, 2, -2}, {-2, -2, 2},
                                {2, -2, 2},   {2, 2, 2},   {-2, 2, 2}, {0, -2, -2}, {2, 0, -2},
                                {0, 2, -2},   {-2, 0, -2}, {0, -2, 2}, {2, 0, 2},   {0, 2, 2},
                                {-2, 0, 2},   {-2, -2, 0}, {2, -2, 0}, {2, 2, 0},   {-2, 2, 0}};
  const std::vector<Place> wedge{{0, 0, -2}, {2, 0, -2}, {0, 2, -2}, {0, 0, 2},  {2, 0, 2},
                                 {0, 2, 2},  {1, 0, -2}, {1, 1, -2}, {0, 1, -2}, {1, 0, 2},
                                 {1, 1, 2},  {0, 1, 2},  {0, 0, 0},  {2, 0, 0},  {0, 2, 0}};
  const std::vector<Place> pyramid{{-2, -2, -2}, {2, -2, -2}, {2, 2, -2}, {-2, 2, -2}, {0, 0, 0}};
  const auto cut = [&](const std::vector<Place>& all, bool simplex, bool quadratic) -> Shape {
    return {dimension,  simplex,
            quadratic,  count == 15 || (dimension == 3 && count == 6),
            count == 5, {all.begin(), all.begin() + static_cast<std::ptrdiff_t>(count)}};
  };
  if (dimension == 2 && (count == 3 || count == 6)) return cut(triangle, true, count == 6);
  if (dimension == 2 && (count == 4 || count == 8)) return cut(square, false, count == 8);
  if (dimension == 3 && (count == 4 || count == 10)) return cut(tetrahedron, true, count == 10);
  if (dimension == 3 && (count == 8 || count == 20)) return cut(cube, false, count == 20);
  if (dimension == 3 && (count == 6 || count == 15)) return cut(wedge, false, count == 15);
  if (dimension == 3 && count == 5) return cut(pyramid, false, false);
  throw std::invalid_argument("no element has so many nodes");
}

// Monomials of degree at most 1 or 2 on simplices; on prisms products of those in xi and eta with
// those in zeta, without those of degree 2 in both; on pyramids 1, and zeta times those linear in
// xi and in eta, which have one value at the apex, zeta = 0; otherwise those of superlinear degree
// at most 1 or 2 (serendipity space of Arnold and Awanou).
std::vector<Exponents> monomials(const Shape& shape) {
  const int last = shape.dimension == 3 ? 2 : 0;
  std::vector<Exponents> all;
  for (int i = 0; i <= 2; ++i) {
    for (int j = 0; j <= 2; ++j) {
      for (int k = 0; k <= last; ++k) {
        int degree = i + j + k;
        int superlinear = 0;
        for (const int exponent : {i, j, k}) superlinear += exponent > 1 ? exponent : 0;
        const int maximum = shape.quadratic ? 2 : 1;
        const bool has = shape.simplex   ? degree <= maximum
                         : shape.prism   ? i + j <= maximum && k <= maximum && i + j + k < 4
                         : shape.pyramid ? superlinear == 0 && (k == 1 || degree == 0)
                                         : superlinear <= (shape.quadratic ? 2 : 0);
        if (has) all.push_back({i, j, k});
      }
    }
  }
  return all;
}

// Inverse by Gaussian elimination with pivoting. @pre invertible
Rationals inverse(Rationals matrix) {
  const auto size = matrix.size();
  Rationals result(size, std::vector<mpq_class>(size));
  for (std::size_t i = 0; i < size; ++i) result[i][i] = 1;
  for (std::size_t column = 0; column < size; ++column) {
    auto pivot = column;
    while (matrix.at(pivot)[column] == 0) ++pivot;
    std::swap(matrix[pivot], matrix[column]);
    std::swap(result[pivot], result[column]);
    const mpq_class scale = 1 / matrix[column][column];
    for (std::size_t j = 0; j < size; ++j) {
      matrix[column][j] *= scale;
      result[column][j] *= scale;
    }
    for (std::size_t row = 0; row < size; ++row) {
      const mpq_class factor = matrix[row][column];
      if (row == column || factor == 0) continue;
      for (std::size_t j = 0; j < size; ++j) {
        matrix[row][j] -= factor * matrix[column][j];
        result[row][j] -= factor * result[column][j];
      }
    }
  }
  return result;
}

// Column a: coefficients of the shape function of node a.
Rationals coefficients(const Shape& shape, const std::vector<Exponents>& powers) {
  Rationals values;
  for (const auto& node : shape.nodes) {
    auto& row = values.emplace_back();
    for (const auto& exponents : powers) {
      mpq_class value = 1;
      for (std::size_t k = 0; k < 3; ++k) {
        for (int e = 0; e < exponents[k]; ++e) value *= mpq_class(node[k], 2);
      }
      row.push_back(value);
    }
  }
  for (auto& row : values) {
    for (auto& value : row) value.canonicalize();
  }
  return inverse(std::move(values));
}

Enclosure power(const Enclosure& base, int exponent) {
  Enclosure result(1);
  for (int e = 0; e < exponent; ++e) result = result * base;
  return result;
}

Enclosure enclosed(const mpq_class& value) {
  // The numerators and denominators are small integers or powers of two.
  return Enclosure(value.get_num().get_d()) / Enclosure(value.get_den().get_d());
}

using Point = std::array<Enclosure, 3>;

std::vector<std::pair<Point, Enclosure>> simplex_rule(const Shape& shape) {
  const auto d = static_cast<double>(shape.dimension);
  const auto volume = Enclosure(1) / Enclosure(shape.dimension == 2 ? 2 : 6);
  if (!shape.quadratic) {
    const auto centre = Enclosure(1) / Enclosure(d + 1);
    return {{{centre, centre, centre}, volume}};
  }
  // 1/6 and 2/3 in a triangle; (5 - sqrt 5) / 20 and (5 + 3 sqrt 5) / 20 in a tetrahedron.
  const auto root = sqrt(Enclosure(5));
  const bool plane = shape.dimension == 2;
  const auto small = plane ? Enclosure(1) / Enclosure(6) : (Enclosure(5) - root) / Enclosure(20);
  const auto large =
      plane ? Enclosure(2) / Enclosure(3) : (Enclosure(5) + Enclosure(3) * root) / Enclosure(20);
  std::vector<std::pair<Point, Enclosure>> rule;
  for (std::size_t at = 0; at <= shape.dimension; ++at) {
    Point point{small, small, small};
    if (at < shape.dimension) point[at] = large;
    rule.emplace_back(point, volume / Enclosure(d + 1));
  }
  return rule;
}

// Places and weights from -1 to 1.
std::vector<std::pair<Enclosure, Enclosure>> line_rule(bool quadratic) {
  if (!quadratic) {
    const auto place = sqrt(Enclosure(3)) / Enclosure(3);
    return {{-place, Enclosure(1)}, {place, Enclosure(1)}};
  }
  const auto place = sqrt(Enclosure(15)) / Enclosure(5);
  const auto weight = Enclosure(5) / Enclosure(9);
  return {{-place, weight}, {Enclosure(0), Enclosure(8) / Enclosure(9)}, {place, weight}};
}

// 1/6 and 2/3 in the triangle.
std::vector<std::pair<Point, Enclosure>> prism_rule(const Shape& shape) {
  std::vector<std::pair<Point, Enclosure>> rule;
  const auto sixth = Enclosure(1) / Enclosure(6);
  for (const auto& [z, weight] : line_rule(shape.quadratic)) {
    for (std::size_t at = 0; at < 3; ++at) {
      Point point{sixth, sixth, z};
      if (at < 2) point[at] = Enclosure(2) / Enclosure(3);
      rule.emplace_back(point, sixth * weight);
    }
  }
  return rule;
}

std::vector<std::pair<Point, Enclosure>> product_rule(const Shape& shape) {
  const auto line = line_rule(shape.quadratic);
  const std::vector<std::pair<Enclosure, Enclosure>> none{{Enclosure(0), Enclosure(1)}};
  std::vector<std::pair<Point, Enclosure>> rule;
  for (const auto& [x, along_x] : line) {
    for (const auto& [y, along_y] : line) {
      for (const auto& [z, along_z] : shape.dimension == 3 ? line : none)
        rule.push_back({{x, y, z}, along_x * along_y * along_z});
    }
  }
  return rule;
}

// That of the cube, with zeta from -1 to 0.
std::vector<std::pair<Point, Enclosure>> pyramid_rule(const Shape& shape) {
  auto rule = product_rule(shape);
  for (auto& [point, weight] : rule) {
    point[2] = (point[2] - Enclosure(1)) / Enclosure(2);
    weight = weight / Enclosure(2);
  }
  return rule;
}

std::vector<ReferencePoint> points_of(const Shape& shape) {
  const auto powers = monomials(shape);
  const auto factors = coefficients(shape, powers);
  std::vector<ReferencePoint> points;
  const auto rule = shape.simplex   ? simplex_rule(shape)
                    : shape.prism   ? prism_rule(shape)
                    : shape.pyramid ? pyramid_rule(shape)
                                    : product_rule(shape);
  for (const auto& [place, weight] : rule) {
    auto& point = points.emplace_back();
    point.weight = weight;
    point.slopes.resize(shape.nodes.size());
    for (std::size_t k = 0; k < shape.dimension; ++k) {
      for (std::size_t term = 0; term < powers.size(); ++term) {
        auto exponents = powers[term];
        const int own = exponents[k];
        if (own == 0) continue;
        --exponents[k];
        Enclosure slope(own);
        for (std::size_t l = 0; l < 3; ++l) slope = slope * power(place[l], exponents[l]);
        for (std::size_t node = 0; node < shape.nodes.size(); ++node) {
          if (factors[term][node] == 0) continue;
          point.slopes[node][k] += enclosed(factors[term][node]) * slope;
        }
      }
    }
  }
  return points;
}

}  // namespace

const std::vector<ReferencePoint>& reference_points(std::size_t dimension, std::size_t nodes) {
  static std::map<std::pair<std::size_t, std::size_t>, std::vector<ReferencePoint>> known;
  auto& points = known[{dimension, nodes}];
  if (points.empty()) points = points_of(shape_of(dimension, nodes));
  return points;
}

}  // namespace kusabi::verify
