// Unconstrained bodies: connected components of a structure whose supports and springs admit
// rigid-body modes (docs/theory/wedged.md, "Unconstrained bodies").
//
// The modes follow from the supported axes of nodes and the coordinates of these nodes by
// elimination in 104 bits, where zeros are clearly distinguished from other numbers. A structure
// with numerically undecided pivots is refused.
#pragma once

#include <string>
#include <vector>

#include <Eigen/Core>

#include "problems/structure/model/structure.hpp"
#include "support/numbers/precise.hpp"

namespace kusabi::problems {

/// A component connected by members and elements that admits rigid-body modes. Nodes supported
/// along every axis belong to the ground and connect nothing; nor do candidates `against` another
/// body.
struct UnconstrainedBody {
  std::vector<int> nodes;  ///< in increasing order, without ground nodes
  Eigen::VectorXd centre;  ///< d, centre of the modes below
  double size = 1;         ///< a power of two near the largest distance of a node from the centre
  /// q x p, q = 3 in the plane and 6 in space: velocity of the centre, d numbers, and `size` times
  /// the angular velocity, one number in the plane, x, y, z in space. Translations come first.
  numbers::PreciseMatrix motions;
  /// Bound of the error of an entry, relative to the largest entry of its column.
  double error = 0;

  [[nodiscard]] Eigen::Index count() const { return motions.cols(); }
  /// The number of translations among the modes.
  [[nodiscard]] Eigen::Index translations() const;
};

/// The displacements d x p of a place in the modes of a body.
numbers::PreciseMatrix displacements(const UnconstrainedBody& body, const Eigen::VectorXd& place);

/// All unconstrained bodies, in the order of their first nodes; without those connected to a
/// superelement, which are taken as constrained.
/// @throws InputError where supports lie almost, but not exactly, on one line
/// @pre the structure passes `check_structure`
std::vector<UnconstrainedBody> unconstrained_bodies(const Structure& structure);

/// Description such as "can move along x and y and turn".
std::string described(const UnconstrainedBody& body);

/// Description of one motion of a body, such as "turns clockwise about (0, 3)", or about a node that
/// is there, or "moves along x".
/// @param motion one column as in `motions`, not zero
std::string described(const Structure& structure, const UnconstrainedBody& body,
                      const Eigen::VectorXd& motion);

}  // namespace kusabi::problems
