// The bodies that nothing holds: connected pieces of a structure whose supports and springs leave
// them some motions of a rigid body (docs/theory/wedged.md, "Loose bodies").
//
// Which motions these are follows from which axes of which nodes are held, and where they are, by
// elimination in 104 bits: what is zero comes out as zero, and where it can't be told whether it
// is, the structure is refused.
#pragma once

#include <string>
#include <vector>

#include <Eigen/Core>

#include "problems/structure/model/structure.hpp"
#include "support/numbers/precise.hpp"

namespace kusabi::problems {

/// A pivot below this is zero: coordinates that depend on each other exactly leave 1e-29.
inline constexpr double dependent = 1e-24;
/// A pivot above this is none that rounding of the file could have made. What is in between is
/// refused.
inline constexpr double independent = 1e-8;

/// A piece of a structure, connected by members and elements, that can move as a rigid body. Nodes
/// that are supported along every axis belong to the ground and connect nothing; candidates that
/// are `against` another body do not either.
struct LooseBody {
  std::vector<int> nodes;  ///< in increasing order; those of the ground left out
  Eigen::VectorXd centre;  ///< d, of the motions below
  double size = 1;         ///< a power of two near the distance of the farthest node from it
  /// q x p, q = 3 in the plane and 6 in space: velocity of the centre, d, and `size` times the
  /// angular velocity, one number in the plane, x, y, z in space. First the translations, if any.
  numbers::PreciseMatrix motions;
  /// What an entry of a motion may be off by, relative to the largest entry of its column.
  double error = 0;

  [[nodiscard]] Eigen::Index count() const { return motions.cols(); }
  /// How many of the motions are translations.
  [[nodiscard]] Eigen::Index translations() const;
};

/// The displacements d x p of a place under the motions of a body.
numbers::PreciseMatrix displacements(const LooseBody& body, const Eigen::VectorXd& place);

/// All bodies that can move, in the order of their first nodes; without those that hang on a
/// superelement, which is taken to hold them.
/// @throws InputError where supports lie almost, but not exactly, on one line
/// @pre the structure passes `check_structure`
std::vector<LooseBody> loose_bodies(const Structure& structure);

/// "can move along x and y and turn".
std::string described(const LooseBody& body);

}  // namespace kusabi::problems
