// Nodes, members and loads of a grid truss.
#include "problems/families/grid_truss.hpp"

#include <cmath>
#include <stdexcept>

#include <fmt/format.h>

#include "problems/families/rounded_place.hpp"

namespace kusabi::problems {
namespace {

constexpr double bay_width = 0.35;      // m
constexpr double bay_height = 0.50;     // m
constexpr YieldForces yield{800, 800};  // kN: 400 MPa times 20 cm^2
constexpr double dead_load = -800;
constexpr double lowest_reference_load = 52;
constexpr double highest_reference_load = 28;

}  // namespace

Structure grid_truss(int bays) {
  if (bays < 2 || bays > max_grid_bays) {
    throw std::invalid_argument(
        fmt::format("a grid of {} bays; expected 2 to {}", bays, max_grid_bays));
  }
  const auto node = [&](int column, int row) { return row * (bays + 1) + column; };
  Structure truss;
  truss.name = fmt::format("{0} x {0} grid", bays);
  truss.dimension = 2;
  truss.units = {"m", "kN"};
  truss.coordinates.resize(2, (bays + 1) * (bays + 1));
  for (int row = 0; row <= bays; ++row) {
    for (int column = 0; column <= bays; ++column) {
      truss.coordinates.col(node(column, row)) << rounded_place(bay_width * column),
          rounded_place(bay_height * row);
      truss.node_names.push_back(fmt::format("{},{}", column, row));
      truss.fixed.push_back({row == 0, row == 0, false});
    }
  }
  const auto join = [&](int first, int second) {
    truss.members.push_back({.first = first, .second = second, .yield = yield});
  };
  for (int row = 1; row <= bays; ++row) {
    for (int column = 0; column < bays; ++column) join(node(column, row), node(column + 1, row));
  }
  for (int row = 0; row < bays; ++row) {
    for (int column = 0; column <= bays; ++column) join(node(column, row), node(column, row + 1));
  }
  for (int row = 0; row < bays; ++row) {
    for (int column = 0; column < bays; ++column) {
      join(node(column, row), node(column + 1, row + 1));
      join(node(column + 1, row), node(column, row + 1));
    }
  }
  for (int row = 2; row <= bays; ++row) {
    const double share = bays == 2 ? 0 : static_cast<double>(row - 2) / (bays - 2);
    const double force =
        lowest_reference_load + share * (highest_reference_load - lowest_reference_load);
    truss.loads.push_back({Load::Kind::reference, node(0, row), Eigen::Vector2d(force, 0)});
  }
  for (int column = 2; column <= bays; ++column) {
    truss.loads.push_back({Load::Kind::dead, node(column, bays), Eigen::Vector2d(0, dead_load)});
  }
  return truss;
}

}  // namespace kusabi::problems
