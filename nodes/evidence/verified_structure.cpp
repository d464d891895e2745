// Number by number, none of them changed.
#include "nodes/evidence/verified_structure.hpp"

#include <cmath>
#include <cstddef>

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

// The axis that is farthest from the normal, of equals the first: docs/problem-files.md.
std::size_t farthest_axis(const Eigen::VectorXd& normal) {
  Eigen::Index farthest = 0;
  for (Eigen::Index axis = 1; axis < normal.size(); ++axis) {
    if (std::abs(normal(axis)) < std::abs(normal(farthest))) farthest = axis;
  }
  return static_cast<std::size_t>(farthest);
}

verify::ContactPoint contact_point(const problems::ContactCandidate& candidate) {
  verify::ContactPoint point;
  point.node = number(candidate.node);
  point.normal = vector(candidate.direction ? *candidate.direction : candidate.normal);
  if (candidate.tangent) point.tangent = vector(*candidate.tangent);
  point.tangent_axis = farthest_axis(candidate.normal);
  point.friction = candidate.friction;
  return point;
}

}  // namespace

verify::Structure verified_structure(const problems::Structure& structure) {
  verify::Structure result;
  result.dimension = number(structure.dimension);
  result.names = structure.node_names;
  for (const auto& column : structure.coordinates.colwise())
    result.places.push_back(vector(column));
  result.fixed = structure.fixed;
  for (const auto& member : structure.members) {
    const auto yield = member.yield.value_or(problems::YieldForces{});
    result.bars.push_back({number(member.first), number(member.second), member.axial_stiffness,
                           yield.tension, yield.compression});
  }
  for (const auto& element : structure.elements) {
    verify::PlaneElement plane;
    for (std::size_t corner = 0; corner < 4; ++corner) {
      plane.nodes[corner] = number(element.nodes[corner]);
    }
    plane.modulus = element.modulus;
    plane.ratio = element.ratio;
    plane.thickness = element.thickness;
    plane.plane_strain = element.state == problems::PlaneState::strain;
    result.elements.push_back(plane);
  }
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
      auto& load = result.uncertain->emplace_back();
      for (const auto& [node, axis, weight] : parameter.components) {
        load.push_back({number(node), number(axis), weight});
      }
    }
  }
  return result;
}

}  // namespace kusabi::evidence
