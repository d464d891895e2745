// Floors from below, with the storey below each.
#include "problems/families/tower.hpp"

#include <array>
#include <stdexcept>

#include <fmt/format.h>

#include "problems/families/rounded_place.hpp"

namespace kusabi::problems {
namespace {

constexpr int floor_corners = 4;
constexpr double leg_yield = 200;  // kN, at the top
constexpr double more_per_storey = 10;
constexpr double brace_yield = 60;
constexpr double top_force = 1;
constexpr double floor_weight = 2;
constexpr double wind_below = 0.05;
constexpr double wind_above = 0.2;
constexpr double ice_force = 0.3;
constexpr double crane_force = 4;

int corner_node(int floor, int corner) {
  return floor * floor_corners + corner % floor_corners;
}

void check_tower(const TowerSize& size) {
  if (size.storeys < 1 || size.storeys > max_storeys) {
    throw std::invalid_argument(
        fmt::format("a tower of {} storeys; expected 1 to {}", size.storeys, max_storeys));
  }
  if (!(size.height > 0) || !(size.base > 0) || !(size.top > 0)) {
    throw std::invalid_argument(
        fmt::format("a tower with storeys of height {} and widths {} and {}; expected positive "
                    "lengths",
                    size.height, size.base, size.top));
  }
}

void add_floors(const TowerSize& size, Structure& truss) {
  constexpr std::array<std::array<int, 2>, floor_corners> sides{
      {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}};
  truss.coordinates.resize(3, floor_corners * (size.storeys + 1));
  for (int floor = 0; floor <= size.storeys; ++floor) {
    const double share = static_cast<double>(floor) / size.storeys;
    const double half = (size.base + share * (size.top - size.base)) / 2;
    for (int k = 0; k < floor_corners; ++k) {
      const auto [x, y] = sides.at(static_cast<std::size_t>(k));
      truss.coordinates.col(corner_node(floor, k)) << rounded_place(half * x),
          rounded_place(half * y), rounded_place(size.height * floor);
      truss.node_names.push_back(fmt::format("{}.{}", floor, k));
      truss.fixed.push_back({floor == 0, floor == 0, floor == 0});
    }
  }
}

void add_storeys(const TowerSize& size, Structure& truss) {
  const auto join = [&](int first, int second, double strength) {
    truss.members.push_back(
        {.first = first, .second = second, .yield = YieldForces{strength, strength / 2}});
  };
  for (int floor = 1; floor <= size.storeys; ++floor) {
    for (int k = 0; k < floor_corners; ++k) {
      join(corner_node(floor - 1, k), corner_node(floor, k),
           leg_yield + more_per_storey * (size.storeys - floor));
      join(corner_node(floor - 1, k), corner_node(floor, k + 1), brace_yield);
      join(corner_node(floor - 1, k + 1), corner_node(floor, k), brace_yield);
      join(corner_node(floor, k), corner_node(floor, k + 1), brace_yield);
    }
    join(corner_node(floor, 0), corner_node(floor, 2), brace_yield);
  }
}

void add_tower_loads(const TowerSize& size, Structure& truss) {
  std::vector<UncertainParameter> loads{{.name = "wind x", .components = {}},
                                        {.name = "wind y", .components = {}},
                                        {.name = "ice", .components = {}},
                                        {.name = "crane", .components = {}}};
  for (int floor = 1; floor <= size.storeys; ++floor) {
    const double share = static_cast<double>(floor) / size.storeys;
    const double wind = wind_below + share * (wind_above - wind_below);
    for (int k = 0; k < floor_corners; ++k) {
      const int at = corner_node(floor, k);
      if (floor == size.storeys)
        truss.loads.push_back({Load::Kind::reference, at, Eigen::Vector3d(top_force, 0, 0)});
      truss.loads.push_back({Load::Kind::dead, at, Eigen::Vector3d(0, 0, -floor_weight)});
      loads[0].components.push_back({at, 0, wind});
      loads[1].components.push_back({at, 1, wind});
      loads[2].components.push_back({at, 2, -ice_force});
      if (floor == size.storeys && k < 2) loads[3].components.push_back({at, 2, -crane_force});
    }
  }
  truss.uncertain = std::move(loads);
}

}  // namespace

Structure tower(const TowerSize& size) {
  check_tower(size);
  Structure truss;
  truss.name = fmt::format("tower of {} storeys", size.storeys);
  truss.dimension = 3;
  truss.units = {"m", "kN"};
  add_floors(size, truss);
  add_storeys(size, truss);
  add_tower_loads(size, truss);
  return truss;
}

}  // namespace kusabi::problems
