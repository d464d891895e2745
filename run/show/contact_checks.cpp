// Shapes are recognised from positions and normals of the candidates alone.
#include "run/show/contact_checks.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <set>

#include <Eigen/Dense>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "answer/values.hpp"
#include "problems/structure/bodies/connected_bodies.hpp"

namespace kusabi::run {
namespace {

using problems::ContactCandidate;
using problems::Structure;

using Candidates = std::vector<const ContactCandidate*>;

/// Distances below this, relative to the size of the structure, are rounding of a file.
constexpr double rounding = 1e-6;

double size_of(const Structure& structure) {
  return (structure.coordinates.rowwise().maxCoeff() - structure.coordinates.rowwise().minCoeff())
      .norm();
}

std::string within(const Structure& structure, double distance) {
  if (distance <= rounding * size_of(structure)) return "";
  return fmt::format(", but the nodes are up to {:.3g} {} apart along it", distance,
                     structure.units.length);
}

// One normal: a plane, or a straight side in the plane, and the distance of its nodes.
std::string flat_shape(const Structure& structure, const Candidates& candidates) {
  const auto& normal = candidates.front()->normal;
  double minimum = HUGE_VAL;
  double maximum = -HUGE_VAL;
  for (const auto* const each : candidates) {
    const double place = normal.dot(structure.coordinates.col(each->node));
    minimum = std::min(minimum, place);
    maximum = std::max(maximum, place);
  }
  return fmt::format("one normal ({:.4g}){}", fmt::join((normal.array() + 0.0).eval(), ", "),
                     within(structure, maximum - minimum));
}

// Normals at one angle to an axis: a cylinder (90 degrees) or a cone. Empty: neither.
std::string round_shape(const Structure& structure, const Candidates& candidates) {
  constexpr double alike = 1e-6;
  if (structure.dimension == 2 || candidates.size() < 4) return "";
  Eigen::Matrix3Xd normals(3, static_cast<Eigen::Index>(candidates.size()));
  for (Eigen::Index i = 0; i < normals.cols(); ++i)
    normals.col(i) = candidates[static_cast<std::size_t>(i)]->normal;
  // The axis is perpendicular to all differences of normals.
  const Eigen::Matrix3Xd differences = normals.colwise() - normals.rowwise().mean().eval();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> spread(differences *
                                                              differences.transpose());
  if (!(spread.eigenvalues()(0) <= alike * alike * static_cast<double>(normals.cols())) ||
      !(spread.eigenvalues()(1) > alike))
    return "";
  const Eigen::Vector3d axis = spread.eigenvectors().col(0);
  const double angle =
      std::asin(std::min(1.0, std::abs(axis.dot(normals.col(0))))) * 180 / std::numbers::pi;
  const auto along =
      fmt::format("about an axis ({:.4g})", fmt::join((axis.array() + 0.0).eval(), ", "));
  if (angle < alike * 180) return "normals of a cylinder " + along;
  return fmt::format("normals of a cone of half angle {:.6g}° {}", angle, along);
}

std::string shape_of(const Structure& structure, const Candidates& candidates) {
  constexpr double alike = 1e-9;
  const auto& first = candidates.front()->normal;
  const bool flat = std::ranges::all_of(
      candidates, [&](const auto* each) { return (each->normal - first).norm() <= alike; });
  if (flat) return flat_shape(structure, candidates);
  auto round = round_shape(structure, candidates);
  return round.empty() ? "normals in several directions" : round;
}

// Number of the body of a node, from 1; 0: it is the ground.
int body_of(const std::vector<std::set<int>>& bodies, int node) {
  const auto own =
      std::ranges::find_if(bodies, [&](const auto& nodes) { return nodes.contains(node); });
  return own == bodies.end() ? 0 : static_cast<int>(own - bodies.begin()) + 1;
}

std::string named(int body) {
  return body == 0 ? "the ground" : fmt::format("body {}", body);
}

}  // namespace

std::vector<std::string> touching_surfaces(const Structure& structure) {
  const auto bodies = problems::connected_bodies(structure);
  std::map<std::pair<std::string, std::string>, Candidates> surfaces;
  for (const auto& each : structure.contact) {
    const auto own = named(body_of(bodies, each.node));
    const auto other = each.against.empty() ? std::string("an obstacle")
                                            : named(body_of(bodies, each.against.front().node));
    surfaces[{each.surface, own + " against " + other}].push_back(&each);
  }
  std::vector<std::string> lines;
  for (const auto& [key, candidates] : surfaces) {
    const auto& [name, touch] = key;
    lines.push_back(fmt::format("{}{}: {}, {}", name.empty() ? "" : name + ", ", touch,
                                answer::counted(candidates.size(), "candidate"),
                                shape_of(structure, candidates)));
  }
  return lines;
}

std::string coincident_nodes(const Structure& structure) {
  return problems::coincidence_warnings(structure).empty()
             ? "none that are not joined"
             : "nodes that are not joined, see the warnings";
}

}  // namespace kusabi::run
