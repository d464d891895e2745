// Shape functions: barycentric on simplices, products of linear functions on squares and cubes, and
// of both on prisms (serendipity if quadratic); on pyramids those of a hexahedron of which one face
// is a point.
#include "problems/structure/assembly/shape_functions.hpp"

#include <cmath>
#include <cstddef>

namespace kusabi::problems {
namespace {

/// L_0 = 1 - xi - eta - zeta, L_1 = xi, ...: linear functions L; with midpoint nodes 4 L_a L_b at a
/// midpoint and L (2 L - 1) at a vertex.
template <class Scalar>
NaturalSlopes<Scalar> simplex_slopes(const ShapeTraits& traits, const NaturalPoint<Scalar>& at) {
  const auto d = static_cast<std::size_t>(traits.dimension);
  const auto vertices = static_cast<std::size_t>(traits.vertices);
  std::vector<Scalar> level(vertices);
  NaturalSlopes<Scalar> rise(vertices);  // gradients of L
  level[0] = 1.0;
  for (std::size_t k = 0; k < d; ++k) {
    level[0] -= at[k];
    level[k + 1] = at[k];
    rise[0][k] = -1.0;
    rise[k + 1][k] = 1.0;
  }
  if (!traits.quadratic) return rise;
  NaturalSlopes<Scalar> slopes(traits.nodes.size());
  for (std::size_t node = 0; node < vertices; ++node) {
    for (std::size_t k = 0; k < d; ++k)
      slopes[node][k] = (Scalar(4.0) * level[node] - Scalar(1.0)) * rise[node][k];
  }
  for (std::size_t node = vertices; node < slopes.size(); ++node) {
    // The vertices of the edge, at which L is one half of its sum at the midpoint.
    std::vector<std::size_t> ends;
    double first_level = 1;
    for (std::size_t k = 0; k < d; ++k) {
      first_level -= traits.nodes[node][k];
      if (traits.nodes[node][k] != 0) ends.push_back(k + 1);
    }
    if (first_level != 0) ends.push_back(0);
    const auto a = ends[0];
    const auto b = ends[1];
    for (std::size_t k = 0; k < d; ++k)
      slopes[node][k] = Scalar(4.0) * (level[a] * rise[b][k] + level[b] * rise[a][k]);
  }
  return slopes;
}

/// With the node's own coordinates s: a factor (1 + s_k x_k) / 2 for each axis, (1 - x_k^2) for an
/// axis on whose middle the node is, and (sum s_k x_k - (d - 1)) at a vertex of a quadratic
/// element.
template <class Scalar>
NaturalSlopes<Scalar> product_slopes(const ShapeTraits& traits, const NaturalPoint<Scalar>& at) {
  const auto d = static_cast<std::size_t>(traits.dimension);
  NaturalSlopes<Scalar> slopes(traits.nodes.size());
  for (std::size_t node = 0; node < slopes.size(); ++node) {
    const auto& own = traits.nodes[node];
    std::array<Scalar, 3> factor{};
    std::array<Scalar, 3> slope{};
    Scalar corner_factor = 1.0 - static_cast<double>(d);
    for (std::size_t k = 0; k < d; ++k) {
      const Scalar side = own[k];
      factor[k] =
          own[k] == 0 ? Scalar(1.0) - at[k] * at[k] : Scalar(0.5) * (Scalar(1.0) + side * at[k]);
      slope[k] = own[k] == 0 ? Scalar(-2.0) * at[k] : Scalar(0.5) * side;
      corner_factor += side * at[k];
    }
    const bool has_middles = traits.quadratic && static_cast<int>(node) < traits.vertices;
    for (std::size_t k = 0; k < d; ++k) {
      Scalar others = 1.0;
      for (std::size_t l = 0; l < d; ++l) {
        if (l != k) others *= factor[l];
      }
      slopes[node][k] =
          others * (has_middles ? slope[k] * corner_factor + factor[k] * Scalar(own[k]) : slope[k]);
    }
  }
  return slopes;
}

/// With L of the triangle and the node's own zeta, s: L (1 + s zeta) / 2; with midpoint nodes
/// L (1 + s zeta) (2 L - 2 + s zeta) / 2 at a vertex, 2 L_a L_b (1 + s zeta) at the midpoint of an
/// edge of a triangle, and L (1 - zeta^2) between the triangles.
template <class Scalar>
NaturalSlopes<Scalar> prism_slopes(const ShapeTraits& traits, const NaturalPoint<Scalar>& at) {
  const std::array<Scalar, 3> level{Scalar(1.0) - at[0] - at[1], at[0], at[1]};
  constexpr std::array<std::array<double, 2>, 3> rise{{{-1, -1}, {1, 0}, {0, 1}}};
  const Scalar half = 0.5;
  const Scalar one = 1.0;
  const Scalar two = 2.0;
  NaturalSlopes<Scalar> slopes(traits.nodes.size());
  for (std::size_t node = 0; node < slopes.size(); ++node) {
    const auto& own = traits.nodes[node];
    const std::array<double, 3> own_level{1 - own[0] - own[1], own[0], own[1]};
    std::vector<std::size_t> ends;  // the vertex, or both of an edge
    for (std::size_t k = 0; k < 3; ++k)
      if (own_level[k] != 0) ends.push_back(k);
    const auto a = ends.front();
    const auto b = ends.back();
    const Scalar side = own[2];
    const Scalar along = side * at[2];
    const Scalar axial = own[2] == 0 ? one - at[2] * at[2] : half * (one + along);
    const Scalar axial_slope = own[2] == 0 ? -two * at[2] : half * side;
    for (std::size_t k = 0; k < 2; ++k) {
      if (a != b) {
        slopes[node][k] =
            Scalar(4.0) * axial * (level[a] * Scalar(rise[b][k]) + level[b] * Scalar(rise[a][k]));
      } else if (traits.quadratic && own[2] != 0) {
        slopes[node][k] = axial * (Scalar(4.0) * level[a] - two + along) * Scalar(rise[a][k]);
      } else {
        slopes[node][k] = axial * Scalar(rise[a][k]);
      }
    }
    if (a != b) {
      slopes[node][2] = Scalar(4.0) * level[a] * level[b] * axial_slope;
    } else if (traits.quadratic && own[2] != 0) {
      slopes[node][2] = level[a] * axial_slope * (two * level[a] - one + two * along);
    } else {
      slopes[node][2] = level[a] * axial_slope;
    }
  }
  return slopes;
}

/// With the node's own xi and eta, s and t: -zeta (1 + s xi) (1 + t eta) / 4 at the base; 1 + zeta
/// at the apex.
template <class Scalar>
NaturalSlopes<Scalar> pyramid_slopes(const ShapeTraits& traits, const NaturalPoint<Scalar>& at) {
  const Scalar quarter = 0.25;
  const Scalar one = 1.0;
  NaturalSlopes<Scalar> slopes(traits.nodes.size());
  for (std::size_t node = 0; node < 4; ++node) {
    const Scalar side = traits.nodes[node][0];
    const Scalar other = traits.nodes[node][1];
    const Scalar along = one + side * at[0];
    const Scalar across = one + other * at[1];
    slopes[node] = {-quarter * at[2] * side * across, -quarter * at[2] * along * other,
                    -quarter * along * across};
  }
  slopes[4] = {Scalar(0.0), Scalar(0.0), one};
  return slopes;
}

template <class Scalar>
struct WeightedPoint {
  NaturalPoint<Scalar> at{};
  Scalar weight;
};

/// One point, or one for each vertex.
template <class Scalar>
std::vector<WeightedPoint<Scalar>> simplex_rule(std::size_t d, bool of_vertices) {
  using std::sqrt;
  const Scalar size = Scalar(1.0) / Scalar(d == 2 ? 2.0 : 6.0);
  const auto points = of_vertices ? d + 1 : 1;
  // Points symmetric about the centre: L = far at one vertex, L = near at all others.
  Scalar near = Scalar(1.0) / Scalar(static_cast<double>(d + 1));
  Scalar far = near;
  if (of_vertices) {
    near = d == 2 ? Scalar(1.0) / Scalar(6.0) : (Scalar(5.0) - sqrt(Scalar(5.0))) / Scalar(20.0);
    far = Scalar(1.0) - Scalar(static_cast<double>(d)) * near;
  }
  std::vector<WeightedPoint<Scalar>> rule(points);
  for (std::size_t point = 0; point < points; ++point) {
    for (std::size_t k = 0; k < d; ++k) rule[point].at[k] = point == k + 1 ? far : near;
    rule[point].weight = size / Scalar(static_cast<double>(points));
  }
  return rule;
}

/// Gauss rule of two or three points from -1 to 1.
template <class Scalar>
std::vector<WeightedPoint<Scalar>> line_rule(bool quadratic) {
  using std::sqrt;
  const Scalar outer =
      quadratic ? sqrt(Scalar(3.0) / Scalar(5.0)) : Scalar(1.0) / sqrt(Scalar(3.0));
  if (!quadratic) return {{{-outer}, 1.0}, {{outer}, 1.0}};
  const Scalar outer_weight = Scalar(5.0) / Scalar(9.0);
  return {{{-outer}, outer_weight},
          {{Scalar(0.0)}, Scalar(8.0) / Scalar(9.0)},
          {{outer}, outer_weight}};
}

/// The product of a rule with a Gauss rule along one more axis.
template <class Scalar>
std::vector<WeightedPoint<Scalar>> with_axis(const std::vector<WeightedPoint<Scalar>>& rule,
                                             std::size_t axis, bool quadratic) {
  std::vector<WeightedPoint<Scalar>> result;
  for (const auto& on_line : line_rule<Scalar>(quadratic)) {
    for (auto point : rule) {
      point.at[axis] = on_line.at[0];
      point.weight *= on_line.weight;
      result.push_back(point);
    }
  }
  return result;
}

template <class Scalar>
std::vector<WeightedPoint<Scalar>> rule_of(const ShapeTraits& traits) {
  const auto d = static_cast<std::size_t>(traits.dimension);
  switch (traits.family) {
    case ShapeFamily::simplex:
      return simplex_rule<Scalar>(d, traits.quadratic);
    case ShapeFamily::prism:
      return with_axis(simplex_rule<Scalar>(2, true), 2, traits.quadratic);
    case ShapeFamily::pyramid:
    case ShapeFamily::product:
      break;
  }
  std::vector<WeightedPoint<Scalar>> rule{{{}, 1.0}};  // the first axis fastest
  for (std::size_t axis = 0; axis < d; ++axis) rule = with_axis(rule, axis, traits.quadratic);
  if (traits.family == ShapeFamily::pyramid) {
    for (auto& [at, weight] : rule) {  // from -1 to 0 along zeta
      at[2] = Scalar(0.5) * (at[2] - Scalar(1.0));
      weight *= Scalar(0.5);
    }
  }
  return rule;
}

template <class Scalar>
std::vector<IntegrationPoint<Scalar>> points_of(ElementShape shape) {
  const auto& traits = shape_traits(shape);
  std::vector<IntegrationPoint<Scalar>> points;
  for (const auto& [at, weight] : rule_of<Scalar>(traits))
    points.push_back({at, weight, natural_slopes<Scalar>(shape, at)});
  return points;
}

}  // namespace

template <class Scalar>
NaturalSlopes<Scalar> natural_slopes(ElementShape shape, const NaturalPoint<Scalar>& at) {
  const auto& traits = shape_traits(shape);
  switch (traits.family) {
    case ShapeFamily::simplex:
      return simplex_slopes(traits, at);
    case ShapeFamily::prism:
      return prism_slopes(traits, at);
    case ShapeFamily::pyramid:
      return pyramid_slopes(traits, at);
    case ShapeFamily::product:
      break;
  }
  return product_slopes(traits, at);
}

template <class Scalar>
const std::vector<IntegrationPoint<Scalar>>& integration_points(ElementShape shape) {
  static const auto all = [] {
    std::array<std::vector<IntegrationPoint<Scalar>>, 11> rules;
    for (std::size_t each = 0; each < rules.size(); ++each)
      rules[each] = points_of<Scalar>(static_cast<ElementShape>(each));
    return rules;
  }();
  return all.at(static_cast<std::size_t>(shape));
}

template NaturalSlopes<double> natural_slopes(ElementShape, const NaturalPoint<double>&);
template const std::vector<IntegrationPoint<double>>& integration_points<double>(ElementShape);
template NaturalSlopes<numbers::Precise> natural_slopes(ElementShape,
                                                        const NaturalPoint<numbers::Precise>&);
template const std::vector<IntegrationPoint<numbers::Precise>>&
    integration_points<numbers::Precise>(ElementShape);
template NaturalSlopes<numbers::RunningError> natural_slopes(
    ElementShape, const NaturalPoint<numbers::RunningError>&);
template const std::vector<IntegrationPoint<numbers::RunningError>>&
    integration_points<numbers::RunningError>(ElementShape);

}  // namespace kusabi::problems
