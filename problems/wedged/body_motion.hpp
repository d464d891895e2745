// Rigid-body motions of the bodies of a structure that displace its candidates in a given way.
#pragma once

#include <string>
#include <vector>

#include <Eigen/Core>

#include "problems/structure/checks/checked_structure.hpp"

namespace kusabi::problems {

/// A body that moves.
struct MovingBody {
  std::string node;   ///< the name of its first node
  std::string words;  ///< "turns clockwise about (0, 3)"
};

struct BodyMotion {
  std::vector<MovingBody> bodies{};  ///< in the order of their first nodes
  bool only_body = false;            ///< the structure has no other unconstrained body
  Eigen::MatrixXd velocities{};      ///< d x nodes; the largest component is 1
  double largest = 0;                ///< by which the given displacements are divided
};

/// The motion with the least sum of squares of the coefficients of the modes.
/// @param displacements of the candidates, dm, as WedgedProblem; a combination of rigid-body modes
BodyMotion body_motion(const CheckedStructure& structure, const Eigen::VectorXd& displacements);

}  // namespace kusabi::problems
