// Corners: nodes that are contact candidates more than once, each time with another normal. One
// node of the bottom of a block may so touch the wall beside it, too.
//
// Its candidates see the same d displacements from several sides, so the node keeps its own, and
// what a candidate sees is a sum (docs/theory/wedged.md, "Corners").
#pragma once

#include <set>

#include <Eigen/Core>

#include "problems/structure/model/elongation.hpp"
#include "problems/structure/model/structure.hpp"
#include "problems/structure/model/truss.hpp"

namespace kusabi::problems {

/// Least angle, in degrees, between a normal of a corner and the span of the others there: nearer
/// ones are of one face, or of two sides of a gap. F_nn loses the square of it, three parts in a
/// million, to what is common to both.
inline constexpr double smallest_corner_angle = 0.1;

/// The nodes with more than one candidate.
std::set<int> corner_nodes(const Structure& structure);

/// What a candidate sees of the free displacements along an axis: that of its node, of a corner
/// less that of the place that it is against.
template <class Scalar>
StrainVector<Scalar> seen_along(const FreeDegrees& degrees, const ContactCandidate& candidate,
                                bool in_corner, int axis) {
  StrainVector<Scalar> seen;
  if (!in_corner) {
    const int number = degrees.number(axis, candidate.node);
    if (number >= 0) seen.push_back({number, Scalar(1.0)});
    return seen;
  }
  add_entry(degrees, axis, candidate.node, Scalar(1.0), seen);
  for (const auto& [node, weight] : candidate.against)
    add_entry(degrees, axis, node, Scalar(-weight), seen);
  return seen;
}

/// Checks that the normals of each corner are linearly independent, and that no two candidates have
/// the same name.
/// @pre nodes and normals of the candidates are right
/// @throws InputError otherwise
void check_corners(const Structure& structure);

}  // namespace kusabi::problems
