// Nodes and members of plane trusses.
#include "problems/families/plane_truss.hpp"

#include <cmath>
#include <numbers>
#include <stdexcept>

#include <fmt/format.h>

#include "problems/structure/checks/structure_check.hpp"

namespace kusabi::problems {
namespace {

constexpr double steepest = 80;  // degrees; steeper walls would make the upper rows extremely long

void check(const PlaneTrussSize& size) {
  if (size.rows < 2 || size.bays < 1) {
    throw std::invalid_argument(fmt::format(
        "a plane truss of {} rows and {} bays; expected at least 2 and 1", size.rows, size.bays));
  }
  if (size.rows > max_contact_candidates) {
    throw std::invalid_argument(
        fmt::format("{} rows; expected at most {} candidates", size.rows, max_contact_candidates));
  }
  if (size.bays > max_bays) {
    throw std::invalid_argument(fmt::format("{} bays; expected at most {}", size.bays, max_bays));
  }
  // The condition is false for NaN.
  if (!(size.width >= 1e-3 && size.width <= 1e6)) {
    throw std::invalid_argument(
        fmt::format("a width of {}; expected 0.001 to 1000000 m", size.width));
  }
  if (!(size.lean >= 0 && size.lean <= steepest)) {
    throw std::invalid_argument(
        fmt::format("a lean of {}; expected 0 to {} degrees", size.lean, steepest));
  }
}

std::vector<Member> members(const PlaneTrussSize& size) {
  std::vector<Member> members;
  const auto node = [&](int row, int column) { return row * (size.bays + 1) + column; };
  const auto join = [&](int first, int second) { members.push_back({first, second, 1.0}); };
  for (int row = 0; row < size.rows; ++row) {
    for (int column = 0; column < size.bays; ++column)
      join(node(row, column), node(row, column + 1));
  }
  const int last_vertical = size.verticals == Verticals::all ? size.bays : size.bays - 1;
  for (int row = 0; row + 1 < size.rows; ++row) {
    if (size.verticals != Verticals::none) {
      for (int column = 1; column <= last_vertical; ++column) {
        join(node(row, column), node(row + 1, column));
      }
    }
    for (int column = 0; column < size.bays; ++column) {
      join(node(row, column), node(row + 1, column + 1));
      join(node(row, column + 1), node(row + 1, column));
    }
  }
  return members;
}

}  // namespace

Structure plane_truss(const PlaneTrussSize& size) {
  check(size);
  Structure truss;
  truss.name = fmt::format("plane truss, {} rows, {} {}", size.rows, size.bays,
                           size.bays == 1 ? "bay" : "bays");
  truss.dimension = 2;
  truss.units = {"m", "kN"};
  truss.coordinates.resize(2, size.rows * (size.bays + 1));
  const double lean = size.lean * std::numbers::pi / 180;
  const Eigen::Vector2d normal(-std::cos(lean), std::sin(lean));
  const Eigen::Vector2d up(std::sin(lean), std::cos(lean));
  int node = 0;
  for (int row = 0; row < size.rows; ++row) {
    const double length = size.width + row * std::tan(lean);
    for (int column = 0; column <= size.bays; ++column, ++node) {
      truss.coordinates.col(node) << length * column / size.bays, row;
      truss.node_names.push_back(fmt::format("r{}c{}", row + 1, column));
      truss.fixed.push_back(column == 0 ? std::array{true, true, false} : std::array<bool, 3>{});
    }
    truss.contact.push_back({node - 1, normal, up});
  }
  truss.members = members(size);
  return truss;
}

Structure paper_plane_truss(int rows) {
  auto truss = plane_truss({.rows = rows, .bays = 1, .verticals = Verticals::all});
  truss.name = fmt::format("plane truss of METR 2009-28, 7.2, N = {}", rows);
  for (Member& bar : truss.members) {
    bar.axial_stiffness =
        (truss.coordinates.col(bar.first) - truss.coordinates.col(bar.second)).norm();
  }
  const double lean = PlaneTrussSize{}.lean * std::numbers::pi / 180;
  for (ContactCandidate& candidate : truss.contact) {
    candidate.normal = Eigen::Vector2d(-std::cos(lean), -std::sin(lean));
    candidate.tangent.reset();
  }
  return truss;
}

}  // namespace kusabi::problems
