// Grounding springs: one mode after another is constrained where it is largest.
#include "problems/structure/bodies/grounding_springs.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <set>

#include "problems/structure/assembly/solid_element.hpp"
#include "problems/structure/bodies/null_space.hpp"
#include "problems/structure/model/elongation.hpp"

namespace kusabi::problems {
namespace {

/// A later place is preferred if it is better by more than rounding.
constexpr double clearly_more = 1 + 1e-9;

double square_sum_at(const StrainVector<double>& vector, const FreeDegrees& degrees, int node) {
  double sum = 0;
  for (const auto& entry : vector) {
    if (degrees.free[static_cast<std::size_t>(entry.number)].node == node)
      sum += entry.value * entry.value;
  }
  return sum;
}

/// The trace of the stiffness at a node.
double stiffness_at(const Structure& structure, const FreeDegrees& degrees, int node) {
  double sum = 0;
  for (const Member& member : structure.members) {
    if (member.first != node && member.second != node) continue;
    sum += bar_stiffness<double>(structure, member) *
           square_sum_at(elongation_vector<double>(structure, degrees, member), degrees, node);
  }
  for (const Element& element : structure.elements) {
    if (std::ranges::find(element.nodes, node) == element.nodes.end()) continue;
    const auto matrix = element_matrix<double>(structure, element);
    for (const auto& [place, number, weight] : element_parts<double>(degrees, element)) {
      if (degrees.free[static_cast<std::size_t>(number)].node == node)
        sum += weight * weight * matrix(place, place);
    }
  }
  return sum;
}

struct SpringPlace {
  int node;
  int axis;
};

/// Nodes of a body for grounding springs. At candidates on rollers and at nodes with several
/// contact normals a spring would change the compliance of tangential springs
/// (problems/wedged/tangential_springs.cpp), so they are used only if there are no others.
std::vector<int> nodes_for_springs(const Structure& structure, const FreeDegrees& degrees,
                                   const UnconstrainedBody& body) {
  std::set<int> others = degrees.several_normals;
  for (const ContactCandidate& candidate : structure.contact) {
    const auto& fixed = structure.fixed[static_cast<std::size_t>(candidate.node)];
    if (std::ranges::count(fixed, true) > 0) others.insert(candidate.node);
  }
  std::vector<int> nodes;
  std::ranges::copy_if(body.nodes, std::back_inserter(nodes),
                       [&](int node) { return !others.contains(node); });
  return nodes.empty() ? body.nodes : nodes;
}

/// The places of springs: repeatedly the node and axis of the largest displacement in the modes
/// that leave the previous places fixed.
std::vector<SpringPlace> spring_places(const Structure& structure, const FreeDegrees& degrees,
                                       UnconstrainedBody body) {
  std::vector<SpringPlace> result;
  auto nodes = nodes_for_springs(structure, degrees, body);
  while (body.count() > 0) {
    SpringPlace best{nodes.front(), 0};
    Eigen::Index column = 0;
    double maximum = 0;
    for (const int node : nodes) {
      const Eigen::MatrixXd moves =
          displacements(body, structure.coordinates.col(node)).cast<double>();
      for (int axis = 0; axis < structure.dimension; ++axis) {
        if (degrees.number(axis, node) < 0) continue;
        Eigen::Index at = 0;
        const double size = moves.row(axis).cwiseAbs().maxCoeff(&at);
        if (size <= maximum * clearly_more) continue;
        maximum = size;
        best = {node, axis};
        column = at;
      }
    }
    if (maximum < smallest_nonzero_pivot &&
        nodes.size() < body.nodes.size()) {  // these nodes do not suffice
      nodes = body.nodes;
      continue;
    }
    result.push_back(best);
    const numbers::PreciseVector row =
        displacements(body, structure.coordinates.col(best.node)).row(best.axis).transpose();
    numbers::PreciseMatrix left(body.motions.rows(), body.count() - 1);
    for (Eigen::Index k = 0, next = 0; k < body.count(); ++k) {
      if (k == column) continue;
      left.col(next++) = body.motions.col(k) - (row(k) / row(column)) * body.motions.col(column);
    }
    body.motions = left;
  }
  return result;
}

}  // namespace

std::vector<Spring> grounding_springs(const Structure& structure, const FreeDegrees& degrees,
                                      std::span<const UnconstrainedBody> bodies) {
  std::vector<Spring> springs;
  for (const UnconstrainedBody& body : bodies) {
    for (const auto& [node, axis] : spring_places(structure, degrees, body)) {
      const double stiffness = stiffness_at(structure, degrees, node);
      springs.push_back({node, axis, std::exp2(std::round(std::log2(stiffness)))});
    }
  }
  return springs;
}

Structure grounded_structure(Structure structure, const FreeDegrees& degrees,
                             std::span<const UnconstrainedBody> bodies) {
  for (const Spring& spring : grounding_springs(structure, degrees, bodies))
    structure.springs.push_back(spring);
  return structure;
}

}  // namespace kusabi::problems
