// Nodes with several contact normals: each normal is a contact candidate. For example, a node at
// the bottom of a block may also touch the wall beside it.
//
// The candidates have the same d displacements in different directions, so the node keeps its own
// displacements, and the displacement of a candidate is a combination of these
// (docs/theory/wedged.md, "Corners").
#pragma once

#include <set>

#include <Eigen/Core>

#include "problems/structure/model/elongation.hpp"
#include "problems/structure/model/structure.hpp"
#include "problems/structure/model/truss.hpp"

namespace kusabi::problems {

/// Least angle, in degrees, between a normal of a node and the span of its others: closer normals
/// belong to one face, or to two sides of a gap. F_nn loses the square of it, three parts in a
/// million, by cancellation.
inline constexpr double smallest_angle_of_normals = 0.1;

/// The nodes with more than one candidate: `FreeDegrees::several_normals`.
std::set<int> nodes_with_several_normals(const Structure& structure);

/// Weights of the free displacements in the displacement of a candidate along an axis: that of its
/// node; at a node with several normals minus that of the opposite place.
template <class Scalar>
StrainVector<Scalar> candidate_displacement(const FreeDegrees& degrees,
                                            const ContactCandidate& candidate, int axis) {
  StrainVector<Scalar> seen;
  if (!degrees.several_normals.contains(candidate.node)) {
    const int number = degrees.number(axis, candidate.node);
    if (number >= 0) seen.push_back({number, Scalar(1.0)});
    return seen;
  }
  add_entry(degrees, axis, candidate.node, Scalar(1.0), seen);
  for (const auto& [node, weight] : candidate.against)
    add_entry(degrees, axis, node, Scalar(-weight), seen);
  return seen;
}

/// Checks that the normals of each node are linearly independent, and that no two candidates have
/// the same name.
/// @pre nodes and normals of the candidates are valid
/// @throws InputError otherwise
void check_several_normals(const Structure& structure);

}  // namespace kusabi::problems
