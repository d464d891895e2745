// Scales: the largest displacement is drawn with at most 0.09 of the structure's size (the scale is
// 1, 2 or 5 times a power of ten), the longest arrow with 0.16 of it. All forces have
// one scale, so that they are seen to be in equilibrium.
#include "pictures/svg/scales.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/Geometry>

namespace kusabi::pictures {
namespace {

constexpr double longest_motion = 0.09;
constexpr double longest_arrow = 0.16;
constexpr double cone_side = 0.11;
/// Number of candidates in contact from which on cones are smaller, so that they do not overlap.
constexpr double many_cones = 6;
constexpr int rim_points = 24;

// The nearest of 1, 2, 5, 10, ... below.
double round_below(double value) {
  const double power = std::pow(10.0, std::floor(std::log10(value)));
  const double digit = value / power;
  return power * (digit >= 5 ? 5 : digit >= 2 ? 2 : 1);
}

double largest_column(const Eigen::Matrix3Xd& vectors) {
  return vectors.cols() == 0 ? 0 : vectors.colwise().norm().maxCoeff();
}

}  // namespace

Scales scales_of(const Scene& scene) {
  Scales scales;
  const double diagonal =
      (scene.positions.rowwise().maxCoeff() - scene.positions.rowwise().minCoeff()).norm();
  if (diagonal > 0) scales.size = diagonal;
  scales.largest_displacement = largest_column(scene.displacements);
  if (scales.largest_displacement > 0)
    scales.displacement = round_below(longest_motion * scales.size / scales.largest_displacement);
  for (const auto& candidate : scene.candidates)
    scales.largest_reaction = std::max(scales.largest_reaction, candidate.reaction.norm());
  scales.largest_support_reaction = largest_column(scene.support_reactions);
  double force = std::max(scales.largest_reaction, scales.largest_support_reaction);
  for (const auto& load : scene.loads) force = std::max(force, load.force.norm());
  if (force > 0) scales.force = longest_arrow * scales.size / force;
  const auto cones = static_cast<double>(
      std::ranges::count(scene.candidates, ContactState::contact, &DrawnCandidate::state));
  scales.cone = cone_side * scales.size * std::sqrt(many_cones / std::max(many_cones, cones));
  return scales;
}

Eigen::Vector3d moved(const Scene& scene, const Scales& scales, int node) {
  const Eigen::Vector3d place = scene.positions.col(node);
  if (scales.displacement == 0) return place;
  return place + scales.displacement * scene.displacements.col(node);
}

double sense_of(const Scene& scene, const DrawnCandidate& candidate) {
  return scene.dimension == 3 && !scene.faces.empty() && candidate.rigid ? -1 : 1;
}

Eigen::Vector3d contact_place(const Scene& scene, const Scales& scales,
                              const DrawnCandidate& candidate) {
  return sense_of(scene, candidate) < 0 ? moved(scene, scales, candidate.node)
                                        : Eigen::Vector3d(scene.positions.col(candidate.node));
}

Eigen::Vector3d reaction_end(const Scene& scene, const Scales& scales,
                             const DrawnCandidate& candidate) {
  return contact_place(scene, scales, candidate) +
         sense_of(scene, candidate) * scales.force * candidate.reaction;
}

std::vector<Eigen::Vector3d> friction_cone(const Scene& scene, const Scales& scales,
                                           const DrawnCandidate& candidate) {
  const Eigen::Vector3d apex = contact_place(scene, scales, candidate);
  const double angle = std::atan(candidate.friction);
  const Eigen::Vector3d along =
      sense_of(scene, candidate) * scales.cone * std::cos(angle) * candidate.normal;
  const double radius = scales.cone * std::sin(angle);
  if (scene.dimension == 2) {
    const Eigen::Vector3d across(-candidate.normal.y(), candidate.normal.x(), 0);
    return {apex, apex + along + radius * across, apex + along - radius * across};
  }
  const Eigen::Vector3d first = candidate.normal.unitOrthogonal();
  const Eigen::Vector3d second = candidate.normal.cross(first);
  std::vector<Eigen::Vector3d> points{apex};
  for (int i = 0; i < rim_points; ++i) {
    const double turn = 2 * std::numbers::pi * i / rim_points;
    points.emplace_back(apex + along + radius * (std::cos(turn) * first + std::sin(turn) * second));
  }
  return points;
}

std::vector<Eigen::Vector3d> extent(const Scene& scene, const Scales& scales) {
  std::vector<Eigen::Vector3d> points;
  for (int node = 0; node < static_cast<int>(scene.positions.cols()); ++node) {
    const Eigen::Vector3d place = scene.positions.col(node);
    points.push_back(place);
    points.push_back(moved(scene, scales, node));
    if (scene.support_reactions.cols() > 0)
      points.emplace_back(place - scales.force * scene.support_reactions.col(node));
  }
  for (const auto& candidate : scene.candidates) {
    points.push_back(reaction_end(scene, scales, candidate));
    if (candidate.state != ContactState::contact) continue;
    const auto cone = friction_cone(scene, scales, candidate);
    points.insert(points.end(), cone.begin(), cone.end());
  }
  for (const auto& load : scene.loads) {
    const double way = load.kind == DrawnLoad::Kind::dead ? -1 : 1;
    points.emplace_back(scene.positions.col(load.node) + way * scales.force * load.force);
  }
  return points;
}

}  // namespace kusabi::pictures
