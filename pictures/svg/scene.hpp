// Scene: one answer as plain data for drawing: structure, displacements, loads and reactions. All
// vectors have three components in global axes; the third is zero in the plane.
#pragma once

#include <array>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "pictures/contact_state.hpp"

namespace kusabi::pictures {

/// State of a bar in a collapse: it yields, or it was lost before.
enum class BarState { none, tension, compression, lost };

struct DrawnBar {
  std::array<int, 2> nodes;
  BarState state = BarState::none;
};

struct DrawnSupport {
  int node;
  std::array<bool, 3> fixed;
};

/// A support along a direction that is not an axis.
struct DrawnInclined {
  int node;
  Eigen::Vector3d direction;  ///< any length but zero
};

struct DrawnSpring {
  int node;
  int axis;  ///< 0, 1 or 2
};

/// A dependent node of a multi-point constraint.
struct DrawnTie {
  int node;
  std::vector<int> masters;
};

struct DrawnCandidate {
  int node;
  std::string name;
  Eigen::Vector3d normal;  ///< out of the obstacle, unit vector
  double friction = 0;     ///< mu_i
  bool rigid = true;       ///< true: obstacle; false: another body
  ContactState state = ContactState::none;
  Eigen::Vector3d reaction = Eigen::Vector3d::Zero();  ///< force
};

struct DrawnLoad {
  enum class Kind { dead, reference };
  Kind kind;
  int node;
  Eigen::Vector3d force;  ///< as it acts: a reference load times its factor
};

/// Names of the loads of a scene, in the legend.
struct LoadNames {
  std::string dead = "dead load";
  std::string reference = "reference load";
};

struct Scene {
  int dimension = 2;
  Eigen::Matrix3Xd positions;  ///< of the nodes
  std::vector<DrawnBar> bars;
  std::vector<std::vector<int>> faces;  ///< of bodies, with their nodes in cyclic order,
                                        ///< in space anticlockwise as seen from outside
  std::vector<DrawnSupport> supports;
  std::vector<DrawnInclined> inclined;
  std::vector<DrawnSpring> springs;
  std::vector<DrawnTie> ties;
  std::vector<DrawnCandidate> candidates;
  std::vector<DrawnLoad> loads;
  LoadNames load_names{};
  Eigen::Matrix3Xd displacements;        ///< of all nodes; no columns: not known
  Eigen::Matrix3Xd support_reactions;    ///< as displacements
  bool collapse = false;                 ///< true if `displacements` are velocities of a motion
  std::string motion = "collapse mode";  ///< its name, with `collapse`
  std::string name;                      ///< "pattern 3"
  std::string note;                      ///< short text beside the name: "t* 1.2e-03"
  std::vector<std::string> lines;        ///< sentences below the title if the scene is drawn alone
};

struct UnitNames {
  std::string length;
  std::string force;
};

}  // namespace kusabi::pictures
