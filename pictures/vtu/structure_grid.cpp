// Conversion of a structure to a VTK grid. VTK, Abaqus and Kusabi order the nodes of all these
// shapes alike: corners, then mid-edge nodes; for hexahedra and prisms those of the lower face, of
// the upper face, and those between.
#include "pictures/vtu/structure_grid.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

namespace kusabi::pictures {
namespace {

using problems::ElementShape;
using problems::Structure;

constexpr double nothing = std::numeric_limits<double>::quiet_NaN();

CellType cell_type(ElementShape shape) {
  switch (shape) {
    case ElementShape::triangle3:
      return CellType::triangle;
    case ElementShape::triangle6:
      return CellType::quadratic_triangle;
    case ElementShape::quadrilateral4:
      return CellType::quadrilateral;
    case ElementShape::quadrilateral8:
      return CellType::quadratic_quadrilateral;
    case ElementShape::tetrahedron4:
      return CellType::tetrahedron;
    case ElementShape::tetrahedron10:
      return CellType::quadratic_tetrahedron;
    case ElementShape::hexahedron8:
      return CellType::hexahedron;
    case ElementShape::prism6:
      return CellType::wedge;
    case ElementShape::prism15:
      return CellType::quadratic_wedge;
    case ElementShape::pyramid5:
      return CellType::pyramid;
    case ElementShape::hexahedron20:
      break;
  }
  return CellType::quadratic_hexahedron;
}

std::vector<Cell> cells_of(const Structure& structure) {
  std::vector<Cell> cells;
  for (const auto& member : structure.members)
    cells.push_back({CellType::line, {member.first, member.second}});
  for (const auto* elements : {&structure.elements, &structure.outlines}) {
    for (const auto& element : *elements)
      cells.push_back({cell_type(element.shape), element.nodes});
  }
  std::vector<bool> has_cell(structure.node_names.size());
  for (const auto& cell : cells) {
    for (const int node : cell.points) has_cell[static_cast<std::size_t>(node)] = true;
  }
  for (std::size_t node = 0; node < has_cell.size(); ++node) {
    if (!has_cell[node]) cells.push_back({CellType::vertex, {static_cast<int>(node)}});
  }
  return cells;
}

Eigen::Index node_count(const Structure& structure) {
  return static_cast<Eigen::Index>(structure.node_names.size());
}

Eigen::MatrixXd no_vectors(const Structure& structure) {
  return Eigen::MatrixXd::Zero(structure.dimension, node_count(structure));
}

SmallNumbers fixed_flags(const Structure& structure) {
  SmallNumbers flags = SmallNumbers::Zero(3, node_count(structure));
  for (std::size_t node = 0; node < structure.fixed.size(); ++node) {
    for (int axis = 0; axis < structure.dimension; ++axis) {
      if (structure.fixed[node][static_cast<std::size_t>(axis)])
        flags(axis, static_cast<Eigen::Index>(node)) = 1;
    }
  }
  return flags;
}

// f_D or f_R by node.
Eigen::MatrixXd loads(const Structure& structure, problems::Load::Kind kind) {
  auto vectors = no_vectors(structure);
  for (const auto& load : structure.loads) {
    if (load.kind == kind) vectors.col(load.node) += load.force;
  }
  return vectors;
}

// Default uncertain loads: 1 on each free component without a load.
Eigen::MatrixXd unloaded_components(const Structure& structure) {
  auto vectors = no_vectors(structure);
  if (structure.loads.empty()) return vectors;
  vectors.setOnes();
  for (const auto& load : structure.loads)
    vectors.col(load.node) = (load.force.array() != 0).select(0, vectors.col(load.node));
  const auto fixed = fixed_flags(structure);
  return (fixed.topRows(vectors.rows()).array() != 0).select(0, vectors);
}

// Sum of the magnitudes of all parameters' contributions to a component.
Eigen::MatrixXd uncertain_loads(const Structure& structure) {
  if (!structure.uncertain) return unloaded_components(structure);
  auto vectors = no_vectors(structure);
  for (const auto& parameter : *structure.uncertain) {
    for (const auto& [node, axis, weight] : parameter.components)
      vectors(axis, node) += std::abs(weight) * parameter.half_width.value_or(1);
  }
  return vectors;
}

// The number of a node in its mesh file: that at the end of "mesh.17"; -1 for other names.
std::int32_t tag_of(const std::string& name) {
  const auto dot = name.rfind('.');
  const char* const first = name.data() + (dot == std::string::npos ? 0 : dot + 1);
  const char* const end = name.data() + name.size();
  std::int32_t number = -1;
  const auto read = std::from_chars(first, end, number);
  return read.ec == std::errc() && read.ptr == end && number >= 0 ? number : -1;
}

WholeNumbers node_tags(const Structure& structure) {
  WholeNumbers tags(1, node_count(structure));
  std::ranges::transform(structure.node_names, tags.data(), tag_of);
  return tags;
}

void add_if_any(UnstructuredGrid& grid, const std::string& name, const Eigen::MatrixXd& vectors) {
  if (!vectors.isZero(0)) grid.point_data.push_back(node_vectors(name, vectors));
}

// Adds point data of inclined supports, springs and dependent nodes.
void add_holds(UnstructuredGrid& grid, const Structure& structure) {
  auto inclined = no_vectors(structure);
  for (const auto& support : structure.inclined)
    inclined.col(support.node) = support.direction.normalized();
  add_if_any(grid, "inclined_support", inclined);
  auto springs = no_vectors(structure);
  for (const auto& spring : structure.springs)
    springs(spring.axis, spring.node) += spring.stiffness;
  add_if_any(grid, "spring", springs);
  if (structure.ties.empty()) return;
  SmallNumbers tied = SmallNumbers::Zero(1, node_count(structure));
  for (const auto& tie : structure.ties) tied(0, tie.node) = 1;
  grid.point_data.push_back({"tied", std::move(tied)});
}

void add_friction(UnstructuredGrid& grid, const Structure& structure) {
  if (structure.contact.empty()) return;
  Eigen::MatrixXd friction = Eigen::MatrixXd::Zero(1, node_count(structure));
  for (const auto& candidate : structure.contact) friction(0, candidate.node) = candidate.friction;
  grid.point_data.push_back({"friction", std::move(friction)});
}

// Adds member numbers given by `number_of`, if any member has one.
template <class NumberOf>
void add_if_any(UnstructuredGrid& grid, const Structure& structure, const std::string& name,
                const NumberOf& number_of) {
  std::vector<double> numbers;
  for (const auto& member : structure.members) numbers.push_back(number_of(member));
  if (std::ranges::all_of(numbers, [](double each) { return std::isnan(each); })) return;
  grid.cell_data.push_back(member_numbers(grid, name, numbers));
}

void add_strengths(UnstructuredGrid& grid, const Structure& structure) {
  using problems::Member;
  add_if_any(grid, structure, "axial_stiffness", [](const Member& its) {
    return its.axial_stiffness > 0 ? its.axial_stiffness : nothing;
  });
  add_if_any(grid, structure, "yield_tension",
             [](const Member& its) { return its.yield ? its.yield->tension : nothing; });
  add_if_any(grid, structure, "yield_compression",
             [](const Member& its) { return its.yield ? its.yield->compression : nothing; });
  if (structure.elements.empty()) return;
  Eigen::MatrixXd moduli(1, static_cast<Eigen::Index>(structure.elements.size()));
  std::ranges::transform(structure.elements, moduli.data(), &problems::Element::modulus);
  grid.cell_data.push_back(element_numbers(grid, structure, "modulus", moduli));
}

}  // namespace

UnstructuredGrid structure_grid(const Structure& structure) {
  UnstructuredGrid grid;
  grid.points = Eigen::Matrix3Xd::Zero(3, node_count(structure));
  grid.points.topRows(structure.dimension) = structure.coordinates;
  grid.cells = cells_of(structure);
  grid.point_data.push_back({"node_tag", node_tags(structure)});
  grid.point_data.push_back({"fixed", fixed_flags(structure)});
  SmallNumbers candidates = SmallNumbers::Zero(1, node_count(structure));
  auto normals = no_vectors(structure);
  for (const auto& candidate : structure.contact) {
    candidates(0, candidate.node) = 1;
    normals.col(candidate.node) = candidate.normal;
  }
  if (!structure.contact.empty()) {
    grid.point_data.push_back({"candidate", std::move(candidates)});
    grid.point_data.push_back(node_vectors("normal", normals));
  }
  add_holds(grid, structure);
  return grid;
}

UnstructuredGrid unsolved_grid(const Structure& structure) {
  auto grid = structure_grid(structure);
  add_friction(grid, structure);
  add_if_any(grid, "dead_load", loads(structure, problems::Load::Kind::dead));
  add_if_any(grid, "reference_load", loads(structure, problems::Load::Kind::reference));
  add_if_any(grid, "uncertain_load", uncertain_loads(structure));
  add_strengths(grid, structure);
  return grid;
}

Field node_vectors(std::string name, const Eigen::MatrixXd& vectors) {
  Eigen::MatrixXd values = Eigen::MatrixXd::Zero(3, vectors.cols());
  values.topRows(vectors.rows()) = vectors;
  return {std::move(name), std::move(values)};
}

Field contact_states(const Structure& structure, std::span<const ContactState> states) {
  SmallNumbers values = SmallNumbers::Zero(1, node_count(structure));
  for (std::size_t i = 0; i < states.size(); ++i)
    values(0, structure.contact[i].node) = static_cast<std::int8_t>(states[i]);
  return {"state", std::move(values)};
}

Field candidate_numbers(const Structure& structure, std::string name,
                        std::span<const double> numbers) {
  Eigen::MatrixXd values = Eigen::MatrixXd::Zero(1, node_count(structure));
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    auto& own = values(0, structure.contact[i].node);
    own = std::max(own, numbers[i]);
  }
  return {std::move(name), std::move(values)};
}

Field whole_number(std::string name, double number, std::string unit) {
  return {std::move(name), Eigen::MatrixXd(Eigen::MatrixXd::Constant(1, 1, number)),
          std::move(unit)};
}

Field member_numbers(const UnstructuredGrid& grid, std::string name,
                     std::span<const double> numbers) {
  Eigen::MatrixXd values =
      Eigen::MatrixXd::Constant(1, static_cast<Eigen::Index>(grid.cells.size()), nothing);
  for (std::size_t i = 0; i < numbers.size(); ++i)
    values(0, static_cast<Eigen::Index>(i)) = numbers[i];
  return {std::move(name), std::move(values)};
}

Field element_numbers(const UnstructuredGrid& grid, const Structure& structure, std::string name,
                      const Eigen::MatrixXd& numbers) {
  Eigen::MatrixXd values = Eigen::MatrixXd::Constant(
      numbers.rows(), static_cast<Eigen::Index>(grid.cells.size()), nothing);
  values.middleCols(static_cast<Eigen::Index>(structure.members.size()), numbers.cols()) = numbers;
  return {std::move(name), std::move(values)};
}

}  // namespace kusabi::pictures
