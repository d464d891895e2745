// Table of types; letters after the name of one denote another formulation of the same nodes.
#include "problems/files/abaqus/abaqus_types.hpp"

#include <algorithm>
#include <array>
#include <iterator>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace kusabi::problems {
namespace {

struct Row {
  std::string_view name;
  MeshShape shape;
  std::optional<PlaneState> state;
};

constexpr auto stress = PlaneState::stress;
constexpr auto strain = PlaneState::strain;

constexpr std::array<Row, 19> of_bodies{{{"CPS3", MeshShape::triangle3, stress},
                                         {"CPS4", MeshShape::quadrilateral4, stress},
                                         {"CPS6", MeshShape::triangle6, stress},
                                         {"CPS8", MeshShape::quadrilateral8, stress},
                                         {"CPE3", MeshShape::triangle3, strain},
                                         {"CPE4", MeshShape::quadrilateral4, strain},
                                         {"CPE6", MeshShape::triangle6, strain},
                                         {"CPE8", MeshShape::quadrilateral8, strain},
                                         {"C3D4", MeshShape::tetrahedron4, std::nullopt},
                                         {"C3D5", MeshShape::pyramid5, std::nullopt},
                                         {"C3D6", MeshShape::prism6, std::nullopt},
                                         {"C3D8", MeshShape::hexahedron8, std::nullopt},
                                         {"C3D10", MeshShape::tetrahedron10, std::nullopt},
                                         {"C3D15", MeshShape::prism15, std::nullopt},
                                         {"C3D20", MeshShape::hexahedron20, std::nullopt},
                                         {"T2D2", MeshShape::line2, std::nullopt},
                                         {"T3D2", MeshShape::line2, std::nullopt},
                                         {"T2D3", MeshShape::line3, std::nullopt},
                                         {"T3D3", MeshShape::line3, std::nullopt}}};

/// Rigid elements and elements without stiffness, which only name surfaces.
constexpr std::array<Row, 7> of_surfaces{{{"R2D2", MeshShape::line2, std::nullopt},
                                          {"R3D3", MeshShape::triangle3, std::nullopt},
                                          {"R3D4", MeshShape::quadrilateral4, std::nullopt},
                                          {"SFM3D3", MeshShape::triangle3, std::nullopt},
                                          {"SFM3D4", MeshShape::quadrilateral4, std::nullopt},
                                          {"SFM3D6", MeshShape::triangle6, std::nullopt},
                                          {"SFM3D8", MeshShape::quadrilateral8, std::nullopt}}};

/// Beginnings of the names of types that connect or load single nodes.
constexpr std::array<std::string_view, 11> of_nodes{"MASS", "ROTARYI", "SPRING", "DASHPOT",
                                                    "GAP",  "CONN",    "DCOUP",  "HEATCAP",
                                                    "ITS",  "JOINTC",  "DISTRIB"};

/// Letters of other formulations: reduced, hybrid, incompatible modes, modified, with temperature,
/// improved stress.
constexpr std::string_view formulations = "RHIMTS";

}  // namespace

AbaqusType abaqus_type(std::string_view name) {
  using Use = AbaqusType::Use;
  for (const Row& row : of_surfaces) {
    if (row.name == name) return {Use::read, row.shape, row.state, {}};
  }
  const Row* best = nullptr;  // with the longest name
  for (const Row& row : of_bodies) {
    if (!name.starts_with(row.name)) continue;
    const auto rest = name.substr(row.name.size());
    if (rest.find_first_not_of(formulations) != std::string_view::npos) continue;
    if (best == nullptr || row.name.size() > best->name.size()) best = &row;
  }
  if (best != nullptr) {
    return {Use::read, best->shape, best->state,
            best->name == name ? std::string_view() : best->name};
  }
  const bool apart = std::ranges::any_of(
      of_nodes, [&](std::string_view start) { return name.starts_with(start); });
  return {apart ? Use::left_out : Use::refused, MeshShape::point, std::nullopt, {}};
}

std::string abaqus_types_read() {
  std::vector<std::string_view> names;
  names.reserve(std::size(of_bodies));
  for (const Row& row : of_bodies) names.push_back(row.name);
  names.resize(names.size() - 2);  // bars have two nodes
  const auto last = names.back();
  names.pop_back();
  return fmt::format("{} or {}", fmt::join(names, ", "), last);
}

}  // namespace kusabi::problems
