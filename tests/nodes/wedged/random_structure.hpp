// Random structures with degenerate nodes: disconnected components, separate posts, candidates on
// rods along their normals, right angles.
#pragma once

#include <array>
#include <cstdint>
#include <random>
#include <vector>

#include <fmt/format.h>

#include "problems/structure/model/structure.hpp"

namespace kusabi::wedged {

/// Builder of a structure, node by node and bar by bar.
class StructureBuilder {
 public:
  explicit StructureBuilder(int dimension) {
    structure_.name = "made for a test";
    structure_.dimension = dimension;
    structure_.units = {"m", "kN"};
    structure_.coordinates.resize(dimension, 0);
  }

  int node(const Eigen::VectorXd& place, bool fixed) {
    const auto number = structure_.coordinates.cols();
    structure_.coordinates.conservativeResize(structure_.dimension, number + 1);
    structure_.coordinates.col(number) = place;
    structure_.node_names.push_back(fmt::format("n{}", number));
    structure_.fixed.push_back({fixed, fixed, fixed});
    return static_cast<int>(number);
  }
  void bar(int first, int second, double axial_stiffness = 1) {
    structure_.members.push_back({first, second, axial_stiffness});
  }
  void candidate(int node, const Eigen::VectorXd& normal, double friction = 1) {
    structure_.contact.push_back({node, normal.normalized(), std::nullopt, friction});
  }

  [[nodiscard]] const problems::Structure& structure() const { return structure_; }

 private:
  problems::Structure structure_;
};

/// A structure of a few components, each with up to four candidates at integer coordinates, such
/// that bars are often parallel or at right angles, to each other and to normals along the axes.
inline problems::Structure random_structure(int dimension, std::uint64_t seed) {
  std::mt19937_64 generator(seed);
  const auto pick = [&](int count) { return static_cast<int>(generator() % std::uint64_t(count)); };
  StructureBuilder builder(dimension);
  const int pieces = 1 + pick(3);
  for (int piece = 0; piece < pieces; ++piece) {
    const Eigen::VectorXd origin = 100.0 * piece * Eigen::VectorXd::Unit(dimension, 0);
    const auto place = [&] {
      Eigen::VectorXd at(dimension);
      for (double& x : at) x = pick(4);
      return at;
    };
    std::vector<Eigen::VectorXd> taken;
    const auto new_place = [&] {
      for (;;) {
        const Eigen::VectorXd at = place();
        bool is_free = true;
        for (const auto& other : taken) is_free = is_free && (at - other).norm() > 0.5;
        if (!is_free) continue;
        taken.push_back(at);
        return at;
      }
    };
    const int candidates = 1 + pick(4);
    std::vector<int> loose;
    for (int i = 0; i < candidates; ++i) loose.push_back(builder.node(origin + new_place(), false));
    // Enough bars to the ground to support each node, and rods from one to the next.
    for (std::size_t i = 0; i < loose.size(); ++i) {
      const bool rod = i > 0 && pick(2) == 0;
      if (rod) builder.bar(loose[i - 1], loose[i], 1 + pick(3));
      for (int k = 0; k < dimension; ++k) {
        const int ground = builder.node(origin + new_place(), true);
        builder.bar(ground, loose[i], 1 + pick(3));
      }
      Eigen::VectorXd normal(dimension);
      do {
        for (double& x : normal) x = pick(3) - 1;
      } while (normal.norm() < 0.5);
      builder.candidate(loose[i], normal);
    }
  }
  return builder.structure();
}

/// An unconstrained body, or one with a hinge: up to six nodes at integer coordinates, a bar
/// between every two, and walls at most of them with inward normals along an axis or a diagonal.
/// May be a mechanism.
inline problems::Structure random_unconstrained_structure(int dimension, std::uint64_t seed) {
  std::mt19937_64 generator(seed);
  const auto pick = [&](int count) { return static_cast<int>(generator() % std::uint64_t(count)); };
  std::vector<Eigen::VectorXd> places;
  const int nodes = dimension + 1 + pick(3);
  while (static_cast<int>(places.size()) < nodes) {
    Eigen::VectorXd at(dimension);
    for (double& x : at) x = pick(3);
    bool is_free = true;
    for (const auto& other : places) is_free = is_free && (at - other).norm() > 0.5;
    if (is_free) places.push_back(at);
  }
  StructureBuilder builder(dimension);
  Eigen::VectorXd centre = Eigen::VectorXd::Zero(dimension);
  for (const auto& at : places) centre += at / nodes;
  const int hinge = pick(4) == 0 ? 0 : -1;
  for (int i = 0; i < nodes; ++i) builder.node(places[static_cast<std::size_t>(i)], i == hinge);
  for (int i = 0; i < nodes; ++i)
    for (int j = 0; j < i; ++j) builder.bar(j, i, 1 + pick(3));
  for (int i = 0; i < nodes; ++i) {
    if (i == hinge || pick(6) == 0) continue;
    Eigen::VectorXd normal(dimension);
    do {
      for (double& x : normal) x = pick(3) - 1;
    } while (normal.norm() < 0.5);
    if (normal.dot(centre - places[static_cast<std::size_t>(i)]) < 0) normal = -normal;
    builder.candidate(i, normal);
  }
  return builder.structure();
}

}  // namespace kusabi::wedged
