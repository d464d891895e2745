// Structures of two clusters; their displacements from one dense system with multipliers.
#include "bodies.hpp"

#include <utility>
#include <vector>

#include "dense.hpp"
#include "problems/structure/assembly/contact_frame.hpp"
#include "problems/structure/assembly/solid_element.hpp"
#include "problems/structure/model/truss.hpp"
#include "trusses.hpp"

namespace kusabi::problems::test {
namespace {

// The numbers of the nodes of a cluster, all connected; the first `dimension` are supported.
std::vector<int> add_cluster(Structure& structure, int nodes, double along, std::mt19937& bits) {
  std::vector<int> numbers;
  for (int i = 0; i < nodes; ++i) {
    Eigen::VectorXd place = random_vector(structure.dimension, bits);
    place(0) += along;
    numbers.push_back(add_node(structure, place));
    if (i < structure.dimension) fix(structure, numbers.back());
    for (int other = 0; other < i; ++other) {
      const double stiffness = 1 + static_cast<double>(bits() % 1000) / 500;
      structure.members.push_back(
          {numbers[static_cast<std::size_t>(other)], numbers.back(), stiffness, {}});
    }
  }
  return numbers;
}

Eigen::Index at(const Structure& structure, int node, int axis) {
  return Eigen::Index{structure.dimension} * node + axis;
}

Eigen::MatrixXd stiffness_of_all(Structure structure) {
  for (auto& axes : structure.fixed) axes = {};
  structure.ties.clear();
  structure.inclined.clear();
  structure.contact.clear();
  const auto all = free_degrees(structure);
  return Eigen::MatrixXd(truss_stiffness(structure, all, member_stiffnesses(structure))) +
         Eigen::MatrixXd(element_stiffness(structure, all));
}

Eigen::MatrixXd conditions(const Structure& structure) {
  const auto size = structure.coordinates.size();
  std::vector<Eigen::VectorXd> rows;
  for (int node = 0; node < static_cast<int>(structure.fixed.size()); ++node) {
    for (int axis = 0; axis < structure.dimension; ++axis) {
      if (structure.fixed[static_cast<std::size_t>(node)][static_cast<std::size_t>(axis)])
        rows.emplace_back(Eigen::VectorXd::Unit(size, at(structure, node, axis)));
    }
  }
  for (const auto& [node, direction] : structure.inclined) {
    rows.emplace_back(Eigen::VectorXd::Zero(size));
    rows.back().segment(at(structure, node, 0), structure.dimension) = direction.normalized();
  }
  for (const auto& [node, to] : structure.ties) {
    for (int axis = 0; axis < structure.dimension; ++axis) {
      rows.emplace_back(Eigen::VectorXd::Unit(size, at(structure, node, axis)));
      for (const auto& [master, weight] : to) rows.back()(at(structure, master, axis)) -= weight;
    }
  }
  Eigen::MatrixXd all(static_cast<Eigen::Index>(rows.size()), size);
  for (std::size_t i = 0; i < rows.size(); ++i)
    all.row(static_cast<Eigen::Index>(i)) = rows[i].transpose();
  return all;
}

}  // namespace

Structure random_bodies(int dimension, std::mt19937& bits) {
  Structure structure = empty_structure(dimension);
  const auto first = add_cluster(structure, dimension + 5, 0, bits);
  const auto second = add_cluster(structure, dimension + 5, 3, bits);
  const auto a = [&](int i) { return first[static_cast<std::size_t>(dimension + i)]; };
  const auto b = [&](int i) { return second[static_cast<std::size_t>(dimension + i)]; };
  const auto normal = [&] { return random_vector(dimension, bits).normalized(); };
  const auto touches = [&](int node, std::vector<WeightedNode> place) {
    structure.contact.push_back({node, normal(), std::nullopt, 1, std::nullopt, std::move(place)});
  };
  structure.inclined.push_back({b(0), random_vector(dimension, bits)});
  touches(a(0), {{b(1), 1}});
  touches(a(1), {{b(1), 0.3}, {b(2), 0.7}});
  touches(a(2), {{b(0), 0.25}, {b(3), 0.75}});
  touches(b(3), {});
  if (dimension == 2) {  // an element with one vertex in a multi-point constraint and another in
                         // contact with the ground
    Element square{{}, 3.0, 0.25, 0.5, PlaneState::stress};
    for (const auto& corner : {Eigen::Vector2d(9, 0), Eigen::Vector2d(10, 0),
                               Eigen::Vector2d(10, 1), Eigen::Vector2d(9, 1)})
      square.nodes.push_back(add_node(structure, corner));
    fix(structure, square.nodes[1]);
    structure.ties.push_back({square.nodes[0], {{b(2), -0.5}, {b(0), 1.5}}});
    touches(square.nodes[2], {{second.front(), 1}});
    auto& corner_normal = structure.contact.back().normal;  // into the body
    corner_normal = -corner_normal.cwiseAbs();
    structure.elements.push_back(std::move(square));
  }
  structure.ties.push_back({b(4), {{a(4), 0.6}, {b(2), 0.4}}});
  structure.fixed[static_cast<std::size_t>(a(3))][1] = true;
  structure.contact.push_back({a(3),
                               Eigen::VectorXd::Unit(dimension, 0),
                               Eigen::VectorXd::Unit(dimension, 1),
                               1,
                               std::nullopt,
                               {}});
  return structure;
}

MultiplierSystem multiplier_system(const Structure& structure) {
  auto stiffness = stiffness_of_all(structure);
  for (const auto& [node, axis, own] : structure.springs)
    stiffness(at(structure, node, axis), at(structure, node, axis)) += own;
  const auto held = conditions(structure);
  const auto size = stiffness.rows();
  const Eigen::Index d = structure.dimension;
  Eigen::MatrixXd system = Eigen::MatrixXd::Zero(size + held.rows(), size + held.rows());
  system.topLeftCorner(size, size) = stiffness;
  system.bottomLeftCorner(held.rows(), size) = held;
  system.topRightCorner(size, held.rows()) = held.transpose();
  Eigen::MatrixXd loads =
      Eigen::MatrixXd::Zero(system.rows(), d * static_cast<Eigen::Index>(structure.contact.size()));
  for (std::size_t i = 0; i < structure.contact.size(); ++i) {
    const auto& candidate = structure.contact[i];
    const auto frame = contact_frame(candidate);
    const auto column = d * static_cast<Eigen::Index>(i);
    loads.block(at(structure, candidate.node, 0), column, d, d) += frame;
    for (const auto& [node, weight] : candidate.against)
      loads.block(at(structure, node, 0), column, d, d) -= weight * frame;
  }
  return {std::move(system), std::move(loads)};
}

Eigen::MatrixXd compliance_by_multipliers(const Structure& structure) {
  const auto [system, loads] = multiplier_system(structure);
  return loads.transpose() * dense::solve(system, loads);
}

Structure with_a_matrix(Structure structure) {
  const Eigen::MatrixXd stiffness = stiffness_of_all(structure);
  Superelement body;
  for (int row = 0; row < static_cast<int>(stiffness.rows()); ++row)
    body.rows.push_back({row / structure.dimension, row % structure.dimension});
  body.stiffness = Eigen::MatrixXd((stiffness + stiffness.transpose()) / 2).sparseView();
  structure.members.clear();
  structure.elements.clear();
  structure.superelements.push_back(std::move(body));
  return structure;
}

}  // namespace kusabi::problems::test
