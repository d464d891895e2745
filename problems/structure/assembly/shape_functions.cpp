// Shape functions: barycentric on simplices, products of linear functions on the others
// (serendipity if quadratic).
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
  const auto corners = static_cast<std::size_t>(traits.corners);
  std::vector<Scalar> level(corners);
  NaturalSlopes<Scalar> rise(corners);  // gradients of L
  level[0] = 1.0;
  for (std::size_t k = 0; k < d; ++k) {
    level[0] -= at[k];
    level[k + 1] = at[k];
    rise[0][k] = -1.0;
    rise[k + 1][k] = 1.0;
  }
  if (!traits.quadratic) return rise;
  NaturalSlopes<Scalar> slopes(traits.nodes.size());
  for (std::size_t node = 0; node < corners; ++node) {
    for (std::size_t k = 0; k < d; ++k)
      slopes[node][k] = (Scalar(4.0) * level[node] - Scalar(1.0)) * rise[node][k];
  }
  for (std::size_t node = corners; node < slopes.size(); ++node) {
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
    const bool has_middles = traits.quadratic && static_cast<int>(node) < traits.corners;
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

template <class Scalar>
struct WeightedPoint {
  NaturalPoint<Scalar> at{};
  Scalar weight;
};

template <class Scalar>
std::vector<WeightedPoint<Scalar>> simplex_rule(const ShapeTraits& traits) {
  using std::sqrt;
  const auto d = static_cast<std::size_t>(traits.dimension);
  const Scalar size = Scalar(1.0) / Scalar(d == 2 ? 2.0 : 6.0);
  const auto points = traits.quadratic ? d + 1 : 1;
  // Points symmetric about the centre: L = far at one vertex, L = near at all others.
  Scalar near = Scalar(1.0) / Scalar(static_cast<double>(d + 1));
  Scalar far = near;
  if (traits.quadratic) {
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

/// Gauss rule of two or three points along each axis, the first axis fastest.
template <class Scalar>
std::vector<WeightedPoint<Scalar>> product_rule(const ShapeTraits& traits) {
  using std::sqrt;
  const Scalar outer =
      traits.quadratic ? sqrt(Scalar(3.0) / Scalar(5.0)) : Scalar(1.0) / sqrt(Scalar(3.0));
  std::vector<WeightedPoint<Scalar>> line{{{-outer}, 1.0}, {{outer}, 1.0}};
  if (traits.quadratic) {
    const Scalar outer_weight = Scalar(5.0) / Scalar(9.0);
    line = {{{-outer}, outer_weight},
            {{Scalar(0.0)}, Scalar(8.0) / Scalar(9.0)},
            {{outer}, outer_weight}};
  }
  std::vector<WeightedPoint<Scalar>> rule{{{}, 1.0}};
  for (std::size_t k = 0; k < static_cast<std::size_t>(traits.dimension); ++k) {
    std::vector<WeightedPoint<Scalar>> next;
    for (const auto& on_line : line) {
      for (auto point : rule) {
        point.at[k] = on_line.at[0];
        point.weight *= on_line.weight;
        next.push_back(point);
      }
    }
    rule = std::move(next);
  }
  return rule;
}

template <class Scalar>
std::vector<IntegrationPoint<Scalar>> points_of(ElementShape shape) {
  const auto& traits = shape_traits(shape);
  std::vector<IntegrationPoint<Scalar>> points;
  for (const auto& [at, weight] :
       traits.simplex ? simplex_rule<Scalar>(traits) : product_rule<Scalar>(traits)) {
    points.push_back({at, weight, natural_slopes<Scalar>(shape, at)});
  }
  return points;
}

}  // namespace

template <class Scalar>
NaturalSlopes<Scalar> natural_slopes(ElementShape shape, const NaturalPoint<Scalar>& at) {
  const auto& traits = shape_traits(shape);
  return traits.simplex ? simplex_slopes(traits, at) : product_slopes(traits, at);
}

template <class Scalar>
const std::vector<IntegrationPoint<Scalar>>& integration_points(ElementShape shape) {
  static const auto all = [] {
    std::array<std::vector<IntegrationPoint<Scalar>>, 8> rules;
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
