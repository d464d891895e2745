// One answer as it is drawn: a structure, how it moves, what acts on it. Plain data, all vectors
// with three components in global axes, the third zero in the plane.
#pragma once

#include <array>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "pictures/contact_state.hpp"

namespace kusabi::pictures {

/// How a bar yields.
enum class Yield { none, tension, compression };

struct DrawnBar {
  std::array<int, 2> nodes;
  Yield yield = Yield::none;
};

struct DrawnSupport {
  int node;
  std::array<bool, 3> fixed;
};

/// A support that holds along a direction that is no axis.
struct DrawnInclined {
  int node;
  Eigen::Vector3d direction;  ///< any length but zero
};

struct DrawnSpring {
  int node;
  int axis;  ///< 0, 1 or 2
};

/// A node that follows others.
struct DrawnTie {
  int node;
  std::vector<int> followed;
};

struct DrawnCandidate {
  int node;
  std::string name;
  Eigen::Vector3d normal;  ///< out of the obstacle, unit
  double friction = 0;     ///< mu_i
  bool rigid = true;       ///< the obstacle, or else another body
  ContactState state = ContactState::none;
  Eigen::Vector3d reaction = Eigen::Vector3d::Zero();  ///< force
};

struct DrawnLoad {
  enum class Kind { dead, reference };
  Kind kind;
  int node;
  Eigen::Vector3d force;
};

struct Scene {
  int dimension = 2;
  Eigen::Matrix3Xd positions;  ///< of the nodes
  std::vector<DrawnBar> bars;
  std::vector<std::vector<int>> faces;  ///< of bodies, their nodes going round
  std::vector<DrawnSupport> supports;
  std::vector<DrawnInclined> inclined;
  std::vector<DrawnSpring> springs;
  std::vector<DrawnTie> ties;
  std::vector<DrawnCandidate> candidates;
  std::vector<DrawnLoad> loads;
  Eigen::Matrix3Xd displacements;      ///< of all nodes; no columns: not known
  Eigen::Matrix3Xd support_reactions;  ///< likewise
  bool collapse = false;               ///< whether `displacements` are velocities of a collapse
  std::string name;                    ///< "pattern 3"
  std::string note;                    ///< a few words beside it: "t* 1.2e-03"
  std::vector<std::string> lines;      ///< sentences below the title where it is drawn alone
};

struct Units {
  std::string length;
  std::string force;
};

}  // namespace kusabi::pictures
