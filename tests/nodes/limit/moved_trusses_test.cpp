// Load factors of trusses that are turned, moved or written in other units: directions that are to
// be zero are then about 1e-16, or 1e-13, and the factors stay the same. They are those of all
// vertices of the truss as it was, which are solved independently.
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <optional>
#include <random>
#include <string>
#include <vector>

#include "nodes/limit/guaranteed_interval.hpp"
#include "tests/nodes/limit/load_model.hpp"

namespace kusabi::limit {
namespace {

using problems::Load;
using problems::Structure;
using test::findings;
using test::near;
using test::PlainTruss;
using test::problem_of;

constexpr double half_width = 0.1;

// Bars along the lines of a square grid and their diagonals, and loads along its axes.
Structure truss_on_a_grid(unsigned seed) {
  std::mt19937 bits(seed);
  const auto below = [&](unsigned count) { return static_cast<int>(bits() % count); };
  const auto between = [&](double from, double to) {
    return from + (to - from) * (static_cast<double>(bits()) * 0x1p-32);
  };
  Structure truss;
  truss.name = "on a grid";
  truss.units = {"m", "kN"};
  truss.dimension = 2;
  constexpr int nodes = 5;
  truss.coordinates.resize(2, nodes);
  for (int node = 0; node < nodes; ++node) {
    // One node in each of five fields.
    truss.coordinates.col(node) << 2 * (node % 3) + below(2), 2 * (node / 3) + below(2);
    truss.node_names.push_back(std::to_string(node));
    truss.fixed.push_back(node < 2 ? std::array{true, true, true} : std::array<bool, 3>{});
  }
  for (int first = 0; first < nodes; ++first) {
    for (int second = std::max(2, first + 1); second < nodes; ++second) {
      if (below(8) == 0) continue;
      const double tension = between(0.3, 1);
      const double compression = tension * between(0.2, 1);
      truss.members.push_back(
          {.first = first, .second = second, .yield = problems::YieldForces{tension, compression}});
    }
  }
  const auto along = [&](int axis) {
    Eigen::VectorXd force = Eigen::VectorXd::Zero(2);
    force(axis) = between(-1, 1);
    return force;
  };
  truss.loads.push_back({Load::Kind::reference, 2 + below(3), along(below(2))});
  truss.loads.push_back({Load::Kind::dead, 2 + below(3), 0.2 * along(below(2))});
  truss.uncertain.emplace();
  for (int j = 0; j < 2; ++j) {
    const Eigen::VectorXd force = along(below(2));
    const int node = 2 + below(3);
    truss.uncertain->push_back(
        {"load " + std::to_string(j), {{node, 0, force(0)}, {node, 1, force(1)}}});
  }
  return truss;
}

// The truss in axes that are turned by an angle.
Structure turned(Structure truss, double angle) {
  Eigen::Matrix2d turn;
  turn << std::cos(angle), -std::sin(angle), std::sin(angle), std::cos(angle);
  truss.coordinates = turn * truss.coordinates;
  for (auto& load : truss.loads) load.force = turn * load.force;
  for (auto& parameter : *truss.uncertain) {
    auto& along_x = parameter.components[0].weight;
    auto& along_y = parameter.components[1].weight;
    const Eigen::Vector2d force = turn * Eigen::Vector2d(along_x, along_y);
    along_x = force(0);
    along_y = force(1);
  }
  return truss;
}

Structure moved(Structure truss) {
  truss.coordinates.colwise() += Eigen::Vector2d(1000.1, -317.7);
  return truss;
}

// Newton and millimetre instead of kilonewton and metre.
Structure in_small_units(Structure truss) {
  constexpr double thousand = 1000;
  truss.coordinates *= thousand;
  for (auto& load : truss.loads) load.force *= thousand;
  for (auto& member : truss.members) {
    member.yield->tension *= thousand;
    member.yield->compression *= thousand;
  }
  for (auto& parameter : *truss.uncertain) {
    for (auto& component : parameter.components) component.weight *= thousand;
  }
  return truss;
}

Structure with_noise(Structure truss) {
  std::mt19937 bits(1);
  for (double& each : truss.coordinates.reshaped())
    each += 1e-16 * (static_cast<double>(bits()) * 0x1p-31 - 1);
  return truss;
}

// Loads without components that are zero, as files have them.
Structure without_zeros(Structure truss) {
  for (auto& parameter : *truss.uncertain)
    std::erase_if(parameter.components, [](const auto& each) { return each.weight == 0; });
  return truss;
}

std::optional<double> least_over_vertices(Structure truss, double sign) {
  for (auto& load : truss.loads) {
    if (load.kind == Load::Kind::reference) load.force *= sign;
  }
  return PlainTruss(truss).min_over_corners(half_width);
}

class MovedTruss : public testing::TestWithParam<std::function<Structure(const Structure&)>> {};

TEST_P(MovedTruss, HasTheFactorsOfTheTrussAsItWas) {
  unsigned compared = 0;
  for (unsigned seed = 1; seed <= 60; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const auto corners = seed % 2 == 0 ? Corners::always : Corners::never;
    const auto truss = truss_on_a_grid(seed);
    if (!problem_of(without_zeros(truss))) continue;
    const auto largest = least_over_vertices(without_zeros(truss), 1);
    const auto least = least_over_vertices(without_zeros(truss), -1);
    const auto found =
        findings(without_zeros(GetParam()(truss)), {.alpha = half_width, .corners = corners})
            .answer;
    EXPECT_TRUE(found.whole());
    ASSERT_EQ(largest.has_value(), least.has_value());
    const auto interval = guaranteed_interval(found);
    EXPECT_EQ(interval.at_none == support::Standing::proved, !largest.has_value());
    if (!largest) continue;
    const double size = near * (1 + std::abs(*largest) + std::abs(*least));
    EXPECT_NEAR(interval.largest.at_least(), *largest, size);
    EXPECT_NEAR(interval.largest.at_most(), *largest, size);
    EXPECT_NEAR(interval.minimum.at_least(), -*least, size);
    EXPECT_NEAR(interval.minimum.at_most(), -*least, size);
    const auto nominal = PlainTruss(without_zeros(truss)).factor(Eigen::VectorXd::Zero(2));
    ASSERT_TRUE(nominal);
    EXPECT_NEAR(found.nominal_factors.largest.at_least(), *nominal, size);
    EXPECT_NEAR(found.nominal_factors.largest.at_most(), *nominal, size);
    ++compared;
  }
  EXPECT_GE(compared, 30U);
}

INSTANTIATE_TEST_SUITE_P(
    Limit, MovedTruss,
    testing::Values([](const Structure& truss) { return turned(truss, 0.1); },
                    [](const Structure& truss) { return turned(truss, std::numbers::pi / 2); },
                    [](const Structure& truss) {
                      return turned(turned(truss, std::numbers::pi / 2), std::numbers::pi / 2);
                    },
                    [](const Structure& truss) { return with_noise(truss); },
                    [](const Structure& truss) { return moved(truss); },
                    [](const Structure& truss) { return moved(turned(truss, std::numbers::pi)); },
                    [](const Structure& truss) { return in_small_units(truss); }));

}  // namespace
}  // namespace kusabi::limit
