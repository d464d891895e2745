// Member-by-member copy; numbers are not changed.
#include "nodes/evidence/verified_structure.hpp"

#include <cmath>
#include <cstddef>
#include <utility>

namespace kusabi::evidence {
namespace {

std::size_t number(int index) {
  return static_cast<std::size_t>(index);
}

template <class Column>
verify::Vector vector(const Column& column) {
  verify::Vector result{};
  for (Eigen::Index axis = 0; axis < column.size(); ++axis) {
    result[static_cast<std::size_t>(axis)] = column(axis);
  }
  return result;
}

// The axis with the smallest component of the normal, the first of equal ones:
// docs/problem-files.md.
std::size_t farthest_axis(const Eigen::VectorXd& normal) {
  Eigen::Index farthest = 0;
  for (Eigen::Index axis = 1; axis < normal.size(); ++axis) {
    if (std::abs(normal(axis)) < std::abs(normal(farthest))) farthest = axis;
  }
  return static_cast<std::size_t>(farthest);
}

std::vector<verify::Part> parts(const std::vector<problems::WeightedNode>& shares) {
  std::vector<verify::Part> result;
  result.reserve(shares.size());
  for (const auto& [node, weight] : shares) result.push_back({number(node), weight});
  return result;
}

verify::ContactPoint contact_point(const problems::ContactCandidate& candidate) {
  verify::ContactPoint point;
  point.node = number(candidate.node);
  point.normal = vector(candidate.direction ? *candidate.direction : candidate.normal);
  if (candidate.tangent) point.tangent = vector(*candidate.tangent);
  point.tangent_axis = farthest_axis(candidate.normal);
  point.friction = candidate.friction;
  point.against = parts(candidate.against);
  point.surface = candidate.surface;
  point.clearance = candidate.clearance;
  return point;
}

verify::GivenStiffness given_stiffness(const problems::Superelement& superelement) {
  verify::GivenStiffness result;
  for (const auto& [node, axis] : superelement.rows) {
    auto& row = result.rows.emplace_back();
    if (node >= 0) row = {number(node), number(axis)};
  }
  const auto& matrix = superelement.stiffness;
  for (int column = 0; column < static_cast<int>(matrix.outerSize()); ++column) {
    for (Eigen::SparseMatrix<double>::InnerIterator entry(matrix, column); entry; ++entry) {
      if (entry.value() == 0) continue;
      result.entries.push_back(
          {number(static_cast<int>(entry.row())), number(column), entry.value()});
    }
  }
  return result;
}

}  // namespace

verify::Structure verified_structure(const problems::Structure& structure) {
  verify::Structure result;
  result.dimension = number(structure.dimension);
  result.names = structure.node_names;
  for (const auto& column : structure.coordinates.colwise())
    result.coordinates.push_back(vector(column));
  result.fixed = structure.fixed;
  for (const auto& member : structure.members) {
    const auto yield = member.yield.value_or(problems::YieldForces{});
    result.bars.push_back({number(member.first), number(member.second), member.axial_stiffness,
                           yield.tension, yield.compression,
                           yield.residual.value_or(yield.compression)});
  }
  for (const auto& element : structure.elements) {
    verify::Element solid;
    for (const int node : element.nodes) solid.nodes.push_back(number(node));
    solid.modulus = element.modulus;
    solid.ratio = element.ratio;
    solid.thickness = element.thickness;
    solid.plane_strain = element.state == problems::PlaneState::strain;
    result.elements.push_back(std::move(solid));
  }
  for (const auto& [node, to] : structure.ties) result.ties.push_back({number(node), parts(to)});
  for (const auto& [node, direction] : structure.inclined)
    result.inclined.push_back({number(node), vector(direction)});
  for (const auto& spring : structure.springs) {
    result.springs.push_back({number(spring.node), number(spring.axis), spring.stiffness});
  }
  for (const auto& superelement : structure.superelements)
    result.given.push_back(given_stiffness(superelement));
  for (const auto& candidate : structure.contact) {
    result.contact.push_back(contact_point(candidate));
  }
  for (const auto& load : structure.loads) {
    auto& list = load.kind == problems::Load::Kind::dead ? result.dead : result.reference;
    list.push_back({number(load.node), vector(load.force)});
  }
  if (structure.uncertain) {
    result.uncertain.emplace();
    for (const auto& parameter : *structure.uncertain) {
      result.half_widths.push_back(parameter.half_width);
      result.load_names.push_back(parameter.group.empty() ? parameter.name : parameter.group);
      auto& load = result.uncertain->emplace_back();
      for (const auto& [node, axis, weight] : parameter.components) {
        load.push_back({number(node), number(axis), weight});
      }
    }
  }
  return result;
}

verify::Structure verified_under_load(const problems::Structure& structure) {
  auto result = verified_structure(structure);
  for (Eigen::Index node = 0; node < structure.imposed_forces.cols(); ++node) {
    const auto force = structure.imposed_forces.col(node);
    if (!force.isZero(0)) result.dead.push_back({number(static_cast<int>(node)), vector(force)});
  }
  return result;
}

}  // namespace kusabi::evidence
