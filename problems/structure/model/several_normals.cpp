// Angles between the normals of a node.
#include "problems/structure/model/several_normals.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <numbers>
#include <string>
#include <vector>

#include <Eigen/QR>
#include <fmt/format.h>

namespace kusabi::problems {
namespace {

/// The angle in degrees between the last column and the span of the previous ones; 90 for a single
/// column.
double angle_from_span(const Eigen::MatrixXd& unit) {
  const Eigen::Index before = unit.cols() - 1;
  if (before == 0) return 90;
  const Eigen::VectorXd last = unit.col(before);
  const Eigen::MatrixXd others = unit.leftCols(before);
  const Eigen::VectorXd rest = last - others * others.colPivHouseholderQr().solve(last);
  return std::asin(std::min(1.0, rest.norm())) * 180 / std::numbers::pi;
}

/// The least angle between one of the columns and the span of the others.
double min_angle(const Eigen::MatrixXd& unit) {
  double minimum = 90;
  for (Eigen::Index k = 0; k < unit.cols(); ++k) {
    Eigen::MatrixXd turned = unit;
    turned.col(k).swap(turned.col(unit.cols() - 1));
    minimum = std::min(minimum, angle_from_span(turned));
  }
  return minimum;
}

Eigen::MatrixXd normals_of(const Structure& structure, const std::vector<std::size_t>& candidates) {
  Eigen::MatrixXd normals(structure.dimension, static_cast<Eigen::Index>(candidates.size()));
  for (std::size_t k = 0; k < candidates.size(); ++k)
    normals.col(static_cast<Eigen::Index>(k)) = structure.contact[candidates[k]].normal;
  return normals;
}

[[noreturn]] void refuse_candidate(const Structure& structure, std::size_t candidate,
                                   std::string_view message) {
  throw structure_error(
      structure, position_of(structure.sources.contact, static_cast<int>(candidate)), message);
}

void check_normals(const Structure& structure, const std::vector<std::size_t>& candidates) {
  const auto name = quoted_name(structure, structure.contact[candidates.front()].node);
  const auto maximum = static_cast<std::size_t>(structure.dimension);
  if (candidates.size() > maximum) {
    refuse_candidate(
        structure, candidates[maximum],
        fmt::format(
            "node {} is a contact candidate {} times; expected at most {} in {}, since more "
            "normals are linearly dependent",
            name, candidates.size(), maximum, maximum == 2 ? "the plane" : "space"));
  }
  const auto angle = min_angle(normals_of(structure, candidates));
  if (angle >= smallest_angle_of_normals) return;
  refuse_candidate(
      structure, candidates.back(),
      fmt::format("node {} is a contact candidate {} with normals that are {:.2f} degrees from "
                  "linear dependence; expected one normal, or normals at least {:g} degrees from "
                  "it",
                  name, candidates.size() == 2 ? "twice" : "three times", angle,
                  smallest_angle_of_normals));
}

void check_names(const Structure& structure) {
  std::map<std::string, std::size_t> first;
  for (std::size_t i = 0; i < structure.contact.size(); ++i) {
    const std::string name = candidate_name(structure, i);
    const auto [entry, is_new] = first.emplace(name, i);
    if (is_new) continue;
    refuse_candidate(
        structure, i,
        fmt::format("contact candidates {} and {} are both called {} in answers; expected nodes "
                    "with other names",
                    entry->second + 1, i + 1, support::in_quotes(name)));
  }
}

}  // namespace

std::set<int> nodes_with_several_normals(const Structure& structure) {
  std::set<int> seen;
  std::set<int> several;
  for (const ContactCandidate& candidate : structure.contact) {
    if (!seen.insert(candidate.node).second) several.insert(candidate.node);
  }
  return several;
}

void check_several_normals(const Structure& structure) {
  std::map<int, std::vector<std::size_t>> at_node;
  for (std::size_t i = 0; i < structure.contact.size(); ++i)
    at_node[structure.contact[i].node].push_back(i);
  for (const auto& [node, candidates] : at_node) check_normals(structure, candidates);
  if (at_node.size() < structure.contact.size()) check_names(structure);
}

}  // namespace kusabi::problems
