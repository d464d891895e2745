// Names of rigid-body modes in messages.
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <Eigen/Geometry>
#include <fmt/format.h>

#include "problems/structure/bodies/rigid_motions.hpp"

namespace kusabi::problems {
namespace {

/// Components of a mode below this are left out of its description.
constexpr double visible_part = 1e-6;

/// "x", or "(0.6, 0.8)" for a direction that is not an axis.
std::string direction_name(const Eigen::VectorXd& direction, double smallest = visible_part) {
  Eigen::Index axis = 0;
  const double size = direction.cwiseAbs().maxCoeff(&axis);
  if (direction.size() == 1) return "";
  const auto parts = (direction.cwiseAbs().array() > smallest * size).count();
  if (parts == 1) return std::string(axis_name(static_cast<int>(axis)));
  const Eigen::VectorXd unit = direction / direction.norm();
  std::string text;
  for (const double part : unit)
    text += fmt::format("{}{:.4g}", text.empty() ? "" : ", ", std::abs(part) > smallest ? part : 0);
  return "(" + text + ")";
}

/// Parts of one motion below this share of the largest are left out of its description: hardly beyond
/// the end of a range of loads the motion is known to fewer digits.
constexpr double visible_velocity = 1e-3;

/// A node this close to a centre of rotation, in sizes of the body, is named in its place.
constexpr double same_place = 1e-4;

/// Axes of rotation farther away than this many sizes of the body belong to translations.
constexpr double farthest_axis = 1e3;

// "moves along x", "moves against x" or "moves along (0.6, 0.8)".
std::string translation_words(const Eigen::VectorXd& velocity) {
  const auto name = direction_name(velocity, visible_velocity);
  const bool backward = name.front() != '(' && velocity.minCoeff() < -velocity.maxCoeff();
  return fmt::format("moves {} {}", backward ? "against" : "along", name);
}

// "(0, 3)": parts up to the smallest are zero.
std::string place_words(const Eigen::VectorXd& place, double smallest) {
  std::string text;
  for (const double part : place)
    text +=
        fmt::format("{}{:.4g}", text.empty() ? "(" : ", ", std::abs(part) > smallest ? part : 0);
  return text + ")";
}

std::string joined(const std::vector<std::string>& words) {
  std::string text;
  for (std::size_t k = 0; k < words.size(); ++k) {
    text += k == 0 ? "" : k + 1 == words.size() ? " and " : ", ";
    text += words[k];
  }
  return text;
}

}  // namespace

std::string described(const UnconstrainedBody& body) {
  const Eigen::MatrixXd motions = body.motions.cast<double>();
  const Eigen::Index d = body.centre.size();
  const Eigen::Index shifts = body.translations();
  std::vector<std::string> along;
  std::vector<std::string> about;
  for (Eigen::Index k = 0; k < shifts; ++k) along.push_back(direction_name(motions.col(k).head(d)));
  for (Eigen::Index k = shifts; k < motions.cols(); ++k)
    about.push_back(direction_name(motions.col(k).tail(motions.rows() - d)));
  std::string text = "can";
  if (!along.empty()) text += " move along " + joined(along);
  if (about.empty()) return text;
  if (!along.empty()) text += " and";
  text += " turn";
  if (d == 3) text += " about " + joined(about);
  return text;
}

// In the plane the velocity is zero at the centre of rotation, c + (-v_y, v_x) / omega. In space it is
// along omega at the axis through c + omega x v / |omega|^2.
std::string described(const Structure& structure, const UnconstrainedBody& body,
                      const Eigen::VectorXd& motion) {
  const Eigen::Index d = body.centre.size();
  const Eigen::VectorXd velocity = motion.head(d);
  const Eigen::VectorXd turn = motion.tail(motion.size() - d) / body.size;
  if (turn.norm() * body.size * farthest_axis <= velocity.norm())
    return translation_words(velocity);
  if (d == 2) {
    const Eigen::Vector2d away(-velocity[1] / turn[0], velocity[0] / turn[0]);
    const Eigen::VectorXd centre = body.centre + away;
    const auto there = std::ranges::find_if(body.nodes, [&](int node) {
      return (structure.coordinates.col(node) - centre).norm() <= same_place * body.size;
    });
    return fmt::format("turns {} about {}", turn[0] < 0 ? "clockwise" : "anticlockwise",
                       there == body.nodes.end()
                           ? place_words(centre, same_place * (body.size + body.centre.norm()))
                           : quoted_name(structure, *there));
  }
  const Eigen::Vector3d omega = turn;
  const Eigen::Vector3d moves = velocity;
  const Eigen::Vector3d place =
      body.centre + Eigen::VectorXd(omega.cross(moves) / omega.squaredNorm());
  const double pitch = omega.dot(moves) / omega.squaredNorm();
  return fmt::format("turns about the axis through {} along {} by the right-hand rule{}",
                     place_words(place, same_place * (body.size + body.centre.norm())),
                     place_words(omega.normalized(), visible_velocity),
                     std::abs(pitch) <= visible_velocity * body.size ? ""
                     : pitch > 0                                     ? " and moves along it"
                                                                     : " and moves against it");
}

}  // namespace kusabi::problems
