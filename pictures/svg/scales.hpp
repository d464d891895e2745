// How large what is no length is drawn: displacements and forces, by the size of the structure.
#pragma once

#include <vector>

#include <Eigen/Core>

#include "pictures/svg/scene.hpp"

namespace kusabi::pictures {

struct Scales {
  double size = 1;          ///< of the structure, length
  double displacement = 0;  ///< drawn per real: 1, 2 or 5 times a power of ten; 0: there is none
  double force = 0;         ///< length per force, one for all arrows but those of a load
  double dead_load = 0;     ///< likewise of dead loads
  double reference_load = 0;
  double cone = 0;  ///< length of a friction cone's sides
  double largest_displacement = 0;
  double largest_reaction = 0;
  double largest_support_reaction = 0;
};

Scales scales_of(const Scene& scene);

/// Of this load's kind: length per force.
double scale_of(const DrawnLoad& load, const Scales& scales);

/// All places that something is drawn at.
std::vector<Eigen::Vector3d> extent(const Scene& scene, const Scales& scales);

/// Where a node is drawn when it has moved.
Eigen::Vector3d moved(const Scene& scene, const Scales& scales, int node);

/// The friction cone at its node: the apex, and then its rim; in the plane two sides.
std::vector<Eigen::Vector3d> friction_cone(const Scene& scene, const Scales& scales,
                                           const DrawnCandidate& candidate);

}  // namespace kusabi::pictures
