// Nodes and members of space trusses.
#include "problems/families/space_truss.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include <fmt/format.h>

#include "problems/families/rounded_place.hpp"
#include "problems/structure/checks/structure_check.hpp"

namespace kusabi::problems {
namespace {

constexpr double width = 10;
constexpr double row_distance = 2.5;
constexpr double plane_distance = 4;
constexpr double lean = std::numbers::pi / 6;  // of the obstacle's surface, from the vertical

// Nodes in the order of their numbers: by planes, rows and columns.
class Grid {
 public:
  explicit Grid(const SpaceTrussSize& size) : size_(size) {}

  [[nodiscard]] int last_column() const { return size_.bays; }
  [[nodiscard]] int nodes() const { return size_.depth * size_.rows * (size_.bays + 1); }
  [[nodiscard]] int node(int plane, int row, int column) const {
    return (plane * size_.rows + row) * (size_.bays + 1) + column;
  }

  template <class Visit>
  void for_each(Visit visit) const {
    for (int plane = 0; plane < size_.depth; ++plane) {
      for (int row = 0; row < size_.rows; ++row) {
        for (int column = 0; column <= size_.bays; ++column) visit(plane, row, column);
      }
    }
  }

  [[nodiscard]] bool has(int plane, int row, int column) const {
    return plane >= 0 && plane < size_.depth && row >= 0 && row < size_.rows && column >= 0 &&
           column <= size_.bays;
  }

 private:
  SpaceTrussSize size_;
};

std::vector<Member> members(const Grid& grid) {
  std::vector<Member> members;
  const auto last = grid.last_column();
  grid.for_each([&](int plane, int row, int column) {
    const auto join = [&](int other_plane, int other_row, int other_column) {
      if (!grid.has(other_plane, other_row, other_column)) return;
      members.push_back(
          {grid.node(plane, row, column), grid.node(other_plane, other_row, other_column), 1.0});
    };
    join(plane, row, column + 1);
    if ((row + column) % 2 == 0) {  // Every second node of a plane has the diagonals.
      join(plane, row + 1, column - 1);
      join(plane, row + 1, column + 1);
    }
    const int above = plane + 1;
    if (column != 0 && column != last) join(above, row, column);
    for (const int side : {-1, 1}) {
      join(above, row, column + side);         // across, within the row
      join(above, row + side, column + side);  // across the block between two rows
      if (column == last) join(above, row + side, column);
    }
  });
  std::sort(members.begin(), members.end(), [](const Member& a, const Member& b) {
    return std::pair(a.first, a.second) < std::pair(b.first, b.second);
  });
  return members;
}

void check(const SpaceTrussSize& size) {
  if (size.rows < 2 || size.depth < 2 || size.bays < 1) {
    throw std::invalid_argument(
        fmt::format("a space truss of {} rows, {} planes and {} bays; expected at least 2, 2 and 1",
                    size.rows, size.depth, size.bays));
  }
  if (size.bays > size.rows) {
    throw std::invalid_argument(fmt::format(
        "{} bays and {} rows; expected no more bays than rows, or some nodes could move freely",
        size.bays, size.rows));
  }
  if (size.rows > max_contact_candidates / size.depth) {
    throw std::invalid_argument(fmt::format("{} rows in {} planes; expected at most {} candidates",
                                            size.rows, size.depth, max_contact_candidates));
  }
}

}  // namespace

Structure space_truss(const SpaceTrussSize& size) {
  check(size);
  const Grid grid(size);
  Structure truss;
  truss.name = fmt::format("space truss, {} x {} contact candidates, {} {}", size.rows, size.depth,
                           size.bays, size.bays == 1 ? "bay" : "bays");
  truss.dimension = 3;
  truss.units = {"m", "kN"};
  truss.coordinates.resize(3, grid.nodes());
  grid.for_each([&](int plane, int row, int column) {
    const bool leaning = column == grid.last_column();
    const double height = plane_distance * plane;
    const double x = width * column / size.bays + (leaning ? height * std::tan(lean) : 0);
    truss.coordinates.col(grid.node(plane, row, column)) << rounded_place(x), row_distance * row,
        height;
    truss.node_names.push_back(fmt::format("p{}r{}c{}", plane + 1, row + 1, column));
    truss.fixed.push_back(column == 0 ? std::array{true, true, true} : std::array<bool, 3>{});
  });
  truss.members = members(grid);
  const Eigen::Vector3d normal(-std::cos(lean), 0, std::sin(lean));
  const Eigen::Vector3d up(std::sin(lean), 0, std::cos(lean));
  for (int row = 0; row < size.rows; ++row) {
    for (int plane = 0; plane < size.depth; ++plane) {
      truss.contact.push_back({grid.node(plane, row, grid.last_column()), normal, up});
    }
  }
  return truss;
}

}  // namespace kusabi::problems
