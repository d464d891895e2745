// Scales: drawn lengths of displacements and forces, relative to the size of the structure.
#pragma once

#include <vector>

#include <Eigen/Core>

#include "pictures/svg/scene.hpp"

namespace kusabi::pictures {

struct Scales {
  double size = 1;  ///< of the structure, length
  /// drawn length per displacement: 1, 2 or 5 times a power of ten; 0: no displacements
  double displacement = 0;
  double force = 0;  ///< length per force, of all arrows
  double cone = 0;   ///< length of a friction cone's sides
  double largest_displacement = 0;
  double largest_reaction = 0;
  double largest_support_reaction = 0;
};

Scales scales_of(const Scene& scene);

/// 1 if the forces of an obstacle are drawn on the side of the body, -1 on the side of the
/// obstacle: bodies in space hide their inside.
double sense_of(const Scene& scene, const DrawnCandidate& candidate);

/// Drawn position of a candidate: that of its displaced node if its forces are on the side of the
/// obstacle, else that of the node at rest.
Eigen::Vector3d contact_place(const Scene& scene, const Scales& scales,
                              const DrawnCandidate& candidate);

/// Drawn reaction of a candidate: the end away from its node.
Eigen::Vector3d reaction_end(const Scene& scene, const Scales& scales,
                             const DrawnCandidate& candidate);

/// All positions of drawn objects.
std::vector<Eigen::Vector3d> extent(const Scene& scene, const Scales& scales);

/// Drawn position of a displaced node.
Eigen::Vector3d moved(const Scene& scene, const Scales& scales, int node);

/// Friction cone at its node: the apex, then the rim; in the plane two sides.
std::vector<Eigen::Vector3d> friction_cone(const Scene& scene, const Scales& scales,
                                           const DrawnCandidate& candidate);

}  // namespace kusabi::pictures
