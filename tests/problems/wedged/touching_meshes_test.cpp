// Meshes in contact, with multi-point constraints, or on inclined rollers, constrained or not:
// compared with a system of all displacements with multipliers for all constraints.
#include <random>
#include <string>
#include <vector>

#include <Eigen/Core>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "dense.hpp"
#include "problems/structure/bodies/rigid_motions.hpp"
#include "problems/wedged/whole_structure.hpp"
#include "tests/problems/bodies.hpp"
#include "tests/problems/structure/patches.hpp"
#include "tests/problems/trusses.hpp"

namespace kusabi::problems {
namespace {

using testing::HasSubstr;

/// Unit squares or cubes side by side along x, with the nodes of each.
struct Row {
  Structure structure;
  std::vector<std::vector<int>> nodes;

  /// The nodes of a body at a distance x from its own left side.
  [[nodiscard]] std::vector<int> at(std::size_t body, double x) const {
    std::vector<int> result;
    for (const int node : nodes[body]) {
      if (structure.coordinates(0, node) == x + static_cast<double>(body)) result.push_back(node);
    }
    return result;
  }
};

// Coordinates are multiples of 1/4, such that coincident nodes are exactly equal.
Row row_of(ElementShape shape, int bodies) {
  std::mt19937 bits(1);
  Structure patch = test::patch(shape, 0, bits);
  Row row{test::empty_structure(patch.dimension), {}};
  for (int body = 0; body < bodies; ++body) {
    auto& numbers = row.nodes.emplace_back();
    for (Eigen::VectorXd place : patch.coordinates.colwise()) {
      place = (place * 12).array().round() / 16;
      place(0) = place(0) / 0.75 + body;
      if (std::abs(place(0) - std::round(place(0))) < 1e-9) place(0) = std::round(place(0));
      numbers.push_back(test::add_node(row.structure, place));
    }
    for (Element element : patch.elements) {
      for (int& node : element.nodes) node = numbers[static_cast<std::size_t>(node)];
      row.structure.elements.push_back(element);
    }
  }
  return row;
}

void pair_up(Row& row, std::size_t left, std::size_t right) {
  const auto normal = Eigen::VectorXd::Unit(row.structure.dimension, 0);
  for (const int node : row.at(right, 0)) {
    for (const int other : row.at(left, 1)) {
      if (row.structure.coordinates.col(node) != row.structure.coordinates.col(other)) continue;
      row.structure.contact.push_back({node, normal, std::nullopt, 1, std::nullopt, {{other, 1}}});
    }
  }
}

void tie_up(Row& row, std::size_t left, std::size_t right) {
  for (const int node : row.at(right, 0)) {
    for (const int other : row.at(left, 1)) {
      if (row.structure.coordinates.col(node) == row.structure.coordinates.col(other))
        row.structure.ties.push_back({node, {{other, 1}}});
    }
  }
}

void touch(Structure& structure, int node, const Eigen::VectorXd& normal) {
  structure.contact.push_back({node, normal.normalized(), std::nullopt, 1});
}

Eigen::MatrixXd across(const Eigen::MatrixXd& columns, const Eigen::MatrixXd& values) {
  if (columns.cols() == 0) return values;
  return values - columns * dense::least_squares(columns, values, 1e-12);
}

// The same rigid-body modes as the system, displacements that differ by these only; and the whole
// structure consistent with its candidates.
void expect_what_multipliers_say(const Structure& structure, Eigen::Index motions) {
  const auto problem = wedged_problem(checked(structure));
  ASSERT_EQ(problem.modes.matrix.cols(), motions);
  const auto [matrix, loads] = test::multiplier_system(structure);
  const Eigen::MatrixXd kernel = dense::kernel(matrix, 1e-11);
  if (kernel.cols() > 0) {
    const Eigen::MatrixXd seen = loads.transpose() * kernel;
    EXPECT_EQ(seen.cols() - dense::kernel(seen, 1e-9).cols(), motions);
    EXPECT_LE(across(problem.modes.matrix, seen).norm(), 1e-9 * seen.norm());
  } else {
    EXPECT_EQ(motions, 0);
  }
  const WholeStructure whole(checked(structure), problem);
  std::mt19937 bits(2);
  for (int draw = 0; draw < 3; ++draw) {
    const Eigen::VectorXd r =
        across(problem.modes.matrix, test::random_vector(problem.compliance.matrix.rows(), bits));
    const Eigen::VectorXd u = problem.compliance.matrix * r;
    const Eigen::VectorXd expected =
        loads.transpose() * dense::least_squares(matrix, loads * r, 1e-11);
    EXPECT_LE(across(problem.modes.matrix, u - expected).norm(), 1e-9 * u.norm());
    EXPECT_GT(u.norm(), 1e-6 * r.norm());

    const Eigen::VectorXd moved =
        motions == 0
            ? u
            : Eigen::VectorXd(u + problem.modes.matrix * test::random_vector(motions, bits));
    const auto state = whole.under(std::vector<double>(r.begin(), r.end()),
                                   std::vector<double>(moved.begin(), moved.end()));
    EXPECT_LE(state.imbalance, 1e-11);
    const Eigen::Index d = structure.dimension;
    for (std::size_t i = 0; i < structure.contact.size(); ++i) {
      const auto& candidate = structure.contact[i];
      Eigen::VectorXd own = state.displacements.col(candidate.node);
      for (const auto& [node, weight] : candidate.against)
        own -= weight * state.displacements.col(node);
      own = problem.frames[i].transpose() * own;
      EXPECT_LE((own - moved.segment(d * static_cast<Eigen::Index>(i), d)).norm(),
                1e-9 * moved.norm());
    }
  }
}

// Three for a body in the plane, six in space; candidates of two unconstrained bodies only have
// relative modes, unless an obstacle touches one.
TEST(TouchingMeshes, AgreeWithMultipliers) {
  for (const auto shape : {ElementShape::triangle3, ElementShape::tetrahedron4}) {
    SCOPED_TRACE(test::name_of(shape));
    const Eigen::Index motions = shape == ElementShape::triangle3 ? 3 : 6;
    Row row = row_of(shape, 2);
    pair_up(row, 0, 1);
    expect_what_multipliers_say(row.structure, motions);
    Row seen = row;
    for (const int node : seen.at(0, 0))
      touch(seen.structure, node, Eigen::VectorXd::Unit(seen.structure.dimension, 0));
    expect_what_multipliers_say(seen.structure, 2 * motions);
    for (const int node : row.at(0, 0)) test::fix(row.structure, node);
    expect_what_multipliers_say(row.structure, motions);
    for (const int node : row.at(1, 1)) test::fix(row.structure, node);
    expect_what_multipliers_say(row.structure, 0);
  }
}

// Two meshes as one body: constrained, and not. With a spring on a dependent node, which acts on
// its master.
TEST(ConstrainedMeshes, AgreeWithMultipliers) {
  for (const auto shape : {ElementShape::triangle6, ElementShape::tetrahedron4}) {
    SCOPED_TRACE(test::name_of(shape));
    Row row = row_of(shape, 2);
    tie_up(row, 0, 1);
    ASSERT_FALSE(row.structure.ties.empty());
    const auto normal = Eigen::VectorXd::Unit(row.structure.dimension, 0);
    for (const int node : row.at(1, 1)) touch(row.structure, node, -normal);
    ASSERT_EQ(unconstrained_bodies(row.structure).size(), 1U);
    expect_what_multipliers_say(row.structure, row.structure.dimension == 2 ? 3 : 6);
    Row sprung = row;
    sprung.structure.springs.push_back({row.structure.ties[1].node, 0, 30});
    expect_what_multipliers_say(sprung.structure, row.structure.dimension == 2 ? 2 : 5);
    for (const int node : row.at(0, 0)) test::fix(row.structure, node);
    expect_what_multipliers_say(row.structure, 0);
    row.structure.springs.push_back({row.structure.ties[0].node, 1, 30});
    expect_what_multipliers_say(row.structure, 0);
  }
}

// A dependent node at a distance from its place would prevent a rotation by the gap alone.
TEST(ConstrainedMeshes, OfAnUnconstrainedBodyAreRefusedWithAGap) {
  Row row = row_of(ElementShape::triangle6, 2);
  tie_up(row, 0, 1);
  for (const int node : row.at(1, 1)) touch(row.structure, node, -Eigen::Vector2d::UnitX());
  for (const double gap : {1e-14, 1e-6, 1e-3}) {
    Structure off = row.structure;
    off.coordinates(0, off.ties[2].node) += gap;
    try {
      wedged_problem(checked(off));
      ADD_FAILURE() << gap;
    } catch (const support::InputError& error) {
      EXPECT_THAT(error.what(), HasSubstr("differs from its own"));
    }
    for (const int node : row.at(0, 0)) test::fix(off, node);
    EXPECT_EQ(wedged_problem(checked(off)).modes.matrix.cols(), 0);
  }
}

// On a roller that admits (4, -3) the body has one translation, and the rotation about the roller.
TEST(InclinedRoller, RemovesOneRigidBodyMode) {
  for (const auto shape : {ElementShape::triangle3, ElementShape::tetrahedron4}) {
    SCOPED_TRACE(test::name_of(shape));
    Row row = row_of(shape, 1);
    Structure& structure = row.structure;
    const Eigen::Index d = structure.dimension;
    Eigen::VectorXd direction = Eigen::VectorXd::Zero(d);
    direction.head(2) << 3, 4;
    const int roller = row.at(0, 0).front();
    structure.inclined.push_back({roller, direction});
    for (const int node : row.at(0, 1)) touch(structure, node, -Eigen::VectorXd::Unit(d, 0));
    const auto bodies = unconstrained_bodies(structure);
    ASSERT_EQ(bodies.size(), 1U);
    EXPECT_EQ(bodies[0].translations(), d - 1);
    const Eigen::MatrixXd moves =
        displacements(bodies[0], structure.coordinates.col(roller)).cast<double>();
    EXPECT_LE((direction.transpose() * moves).norm(), 1e-15);
    expect_what_multipliers_say(structure, d == 2 ? 2 : 5);
  }
}

}  // namespace
}  // namespace kusabi::problems
