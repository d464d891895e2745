// Names of rigid-body modes in messages.
#include <cmath>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "problems/structure/bodies/rigid_motions.hpp"

namespace kusabi::problems {
namespace {

/// Components of a mode below this are left out of its description.
constexpr double visible_part = 1e-6;

/// "x", or "(0.6, 0.8)" for a direction that is not an axis.
std::string direction_name(const Eigen::VectorXd& direction) {
  Eigen::Index axis = 0;
  const double size = direction.cwiseAbs().maxCoeff(&axis);
  if (direction.size() == 1) return "";
  const auto parts = (direction.cwiseAbs().array() > visible_part * size).count();
  if (parts == 1) return std::string(axis_name(static_cast<int>(axis)));
  const Eigen::VectorXd unit = direction / direction.norm();
  std::string text;
  for (const double part : unit)
    text +=
        fmt::format("{}{:.4g}", text.empty() ? "" : ", ", std::abs(part) > visible_part ? part : 0);
  return "(" + text + ")";
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

}  // namespace kusabi::problems
