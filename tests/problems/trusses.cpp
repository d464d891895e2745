// Small trusses that several tests use.
#include "trusses.hpp"

#include <cstddef>

namespace kusabi::problems::test {

int add_node(Structure& structure, const Eigen::VectorXd& position) {
  const auto number = static_cast<int>(structure.node_names.size());
  structure.node_names.push_back("node " + std::to_string(number));
  structure.coordinates.conservativeResize(structure.dimension, number + 1);
  structure.coordinates.col(number) = position;
  structure.fixed.push_back({false, false, false});
  return number;
}

Structure empty_structure(int dimension) {
  Structure structure;
  structure.name = "test";
  structure.dimension = dimension;
  structure.units = {"m", "kN"};
  structure.coordinates.resize(dimension, 0);
  return structure;
}

void fix(Structure& structure, int node) {
  structure.fixed[static_cast<std::size_t>(node)] = {true, true, true};
}

Structure two_bars() {
  Structure structure = empty_structure(2);
  const int left = add_node(structure, Eigen::Vector2d(0, 0));
  const int top = add_node(structure, Eigen::Vector2d(1, 1));
  const int tip = add_node(structure, Eigen::Vector2d(1, 0));
  fix(structure, left);
  fix(structure, top);
  structure.members = {{left, tip, 1.0}, {top, tip, 3.0}};
  structure.contact = {{tip, Eigen::Vector2d(-1, 1).normalized(), std::nullopt}};
  return structure;
}

Structure cantilever(int bays, int bay_without_diagonal) {
  Structure structure = empty_structure(2);
  for (int bay = 0; bay <= bays; ++bay) {
    add_node(structure, Eigen::Vector2d(bay, 0));
    add_node(structure, Eigen::Vector2d(bay, 1));
  }
  fix(structure, 0);
  fix(structure, 1);
  for (int bay = 0; bay < bays; ++bay) {
    const int node = 2 * bay;
    structure.members.push_back({node, node + 2, 1.0});
    structure.members.push_back({node + 1, node + 3, 1.0});
    structure.members.push_back({node + 2, node + 3, 1.0});
    if (bay != bay_without_diagonal) structure.members.push_back({node, node + 3, 1.0});
  }
  structure.contact = {{2 * bays, Eigen::Vector2d(0, 1), std::nullopt}};
  return structure;
}

Eigen::VectorXd random_vector(Eigen::Index size, std::mt19937& bits) {
  std::uniform_real_distribution<double> entry(-1.0, 1.0);
  return Eigen::VectorXd::NullaryExpr(size, [&]() { return entry(bits); });
}

Structure random_cluster(int dimension, int nodes, std::mt19937& bits) {
  Structure structure = empty_structure(dimension);
  for (int node = 0; node < nodes; ++node) {
    add_node(structure, random_vector(dimension, bits));
    for (int other = 0; other < node; ++other) structure.members.push_back({other, node, 1.0});
  }
  return structure;
}

Structure random_wedge(int dimension, int nodes, std::mt19937& bits) {
  Structure structure = random_cluster(dimension, nodes, bits);
  std::uniform_real_distribution<double> axial_stiffness(1.0, 3.0);
  for (Member& member : structure.members) member.axial_stiffness = axial_stiffness(bits);
  for (int node = 0; node < dimension; ++node) fix(structure, node);
  for (int node = nodes - 3; node < nodes; ++node) {
    structure.contact.push_back({node, random_vector(dimension, bits).normalized(), std::nullopt});
  }
  return structure;
}

std::string source_path(const std::string& relative) {
  return std::string(KUSABI_SOURCE_DIR) + "/" + relative;
}

}  // namespace kusabi::problems::test
