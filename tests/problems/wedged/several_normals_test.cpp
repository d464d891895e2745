// Several contact normals at a node: F by multipliers, which are independent of them; names; the
// whole structure; refusals.
#include "problems/structure/model/several_normals.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "dense.hpp"
#include "problems/files/structure_file.hpp"
#include "problems/files/toml/structure_writer.hpp"
#include "problems/wedged/whole_structure.hpp"
#include "tests/problems/bodies.hpp"
#include "tests/problems/corners.hpp"
#include "tests/problems/trusses.hpp"

namespace kusabi::problems {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

TEST(SeveralNormals, HaveTheComplianceByMultipliersExceptATangentialPart) {
  std::mt19937 bits(3);
  for (int draw = 0; draw < 40; ++draw) {
    SCOPED_TRACE(draw);
    const Structure structure = test::random_corners(2 + draw % 2, bits);
    const auto problem = wedged_problem(checked(structure));
    const Eigen::Index d = structure.dimension;
    const Eigen::MatrixXd expected = test::compliance_by_multipliers(structure);
    Eigen::MatrixXd added = problem.compliance.matrix - expected;
    const auto vertices = nodes_with_several_normals(structure);
    EXPECT_EQ(vertices.size(), d == 2 ? 4U : 5U);
    const double size = expected.norm();
    for (Eigen::Index i = 0; i < std::ssize(structure.contact); ++i) {
      const int node = structure.contact[static_cast<std::size_t>(i)].node;
      const auto own = added.block(d * i, d * i, d, d);
      EXPECT_LE(own.row(0).norm(), 1e-10 * size);
      if (vertices.contains(node)) {
        const double c = own(1, 1);
        EXPECT_GT(c, 1e-3 * expected(d * i, d * i));
        EXPECT_LT(c, 1e+3 * expected(d * i, d * i));
        EXPECT_LE(
            (own.bottomRightCorner(d - 1, d - 1) - c * Eigen::MatrixXd::Identity(d - 1, d - 1))
                .norm(),
            1e-10 * size);
      }
      added.block(d * i, d * i, d, d).setZero();
    }
    EXPECT_LE(added.norm(), 1e-10 * size);
    EXPECT_LE(problem.compliance.precise_error, 1e-18);
    EXPECT_LE(dense::eigenvalues(expected)(0), 1e-12 * size);
    EXPECT_GT(dense::eigenvalues(problem.compliance.stiffness)(0), 0);
  }
}

// The node has one displacement, and those of its candidates are its components.
TEST(SeveralNormals, HaveOneDisplacementAndTheSumOfReactions) {
  std::mt19937 bits(4);
  for (int draw = 0; draw < 20; ++draw) {
    SCOPED_TRACE(draw);
    const Structure structure = test::random_corners(2 + draw % 2, bits);
    const Eigen::Index d = structure.dimension;
    const auto problem = wedged_problem(checked(structure));
    const WholeStructure whole(checked(structure), problem);
    const Eigen::VectorXd reactions = test::random_vector(problem.compliance.matrix.rows(), bits);
    const auto state = whole.under(
        std::span<const double>(reactions.data(), static_cast<std::size_t>(reactions.size())));
    const Eigen::VectorXd seen = test::compliance_by_multipliers(structure) * reactions;
    Eigen::VectorXd sum = state.reactions.rowwise().sum();
    for (std::size_t i = 0; i < structure.contact.size(); ++i) {
      const auto first = d * static_cast<Eigen::Index>(i);
      Eigen::VectorXd moves = state.displacements.col(structure.contact[i].node);
      double left = 1;
      for (const auto& [node, weight] : structure.contact[i].against) {
        moves -= weight * state.displacements.col(node);
        left -= weight;
      }
      EXPECT_LE((problem.frames[i].transpose() * moves - seen.segment(first, d)).norm(),
                1e-11 * seen.norm());
      sum += left * problem.frames[i] * reactions.segment(first, d);
    }
    EXPECT_LE(sum.norm(), 1e-11 * state.reactions.norm());
  }
}

// Two rigid walls press a node between them: the forces on it cancel, and the supports carry
// rounding errors alone.
TEST(SeveralNormals, AreInEquilibriumIfTheReactionsCancel) {
  std::mt19937 bits(6);
  int corners = 0;
  for (int draw = 0; draw < 20; ++draw) {
    SCOPED_TRACE(draw);
    const Structure structure = test::random_corners(2 + draw % 2, bits);
    const Eigen::Index d = structure.dimension;
    const auto problem = wedged_problem(checked(structure));
    const WholeStructure whole(checked(structure), problem);
    for (std::size_t i = 0; i + 1 < structure.contact.size(); ++i) {
      const auto& wall = structure.contact[i];
      const auto& next = structure.contact[i + 1];
      if (wall.node != next.node || !wall.against.empty() || !next.against.empty()) continue;
      ++corners;
      const Eigen::VectorXd force = test::random_vector(d, bits);
      std::vector<double> reactions(static_cast<std::size_t>(problem.compliance.matrix.rows()));
      Eigen::VectorXd both(2 * d);
      both << problem.frames[i].transpose() * force, -problem.frames[i + 1].transpose() * force;
      std::ranges::copy(both, reactions.begin() + d * static_cast<Eigen::Index>(i));
      const auto state = whole.under(reactions);
      EXPECT_LE(state.reactions.norm(), 1e-11 * force.norm());
      EXPECT_LE(state.imbalance, 1e-11);
    }
  }
  EXPECT_GE(corners, 20);
}

// Each node has a truss of its own, except one that touches both: they are one block.
TEST(SeveralNormals, ConnectTheBodiesThatTheNodeTouches) {
  Structure structure = test::empty_structure(2);
  const auto hinge = [&](double x) {
    const int node = test::add_node(structure, Eigen::Vector2d(x, 0));
    for (const auto& arm : {Eigen::Vector2d(0, 1), Eigen::Vector2d(0.8, 1)}) {
      const int end = test::add_node(structure, Eigen::Vector2d(x, 0) + arm);
      test::fix(structure, end);
      structure.members.push_back({node, end, 1, {}});
    }
    return node;
  };
  const int first = hinge(0), second = hinge(0), third = hinge(5);
  const Eigen::Vector2d up(0, 1), right(1, 0);
  structure.contact = {
      {first, up, std::nullopt, 1}, {second, up, std::nullopt, 1}, {third, up, std::nullopt, 1}};
  EXPECT_EQ(wedged_problem(checked(structure)).blocks.size(), 3U);
  structure.contact.push_back({first, right, std::nullopt, 1, std::nullopt, {{second, 1}}});
  const auto problem = wedged_problem(checked(structure));
  ASSERT_EQ(problem.blocks.size(), 2U);
  EXPECT_EQ(problem.blocks[0], support::IndexSet(0b1011));
  EXPECT_THAT(problem.contact_names,
              ElementsAre("node 0@1", "node 3", "node 6", "node 0@2|node 3"));
}

std::string square(const std::string& rest) {
  return "name = \"s\"\ndimension = 2\nunits = { length = \"m\", force = \"N\" }\n"
         "[[mesh]]\nname = \"b\"\ncorners = [[0, 0], [2, 0], [2, 1], [0, 1]]\ndivisions = [2, 1]\n"
         "E = 1\nnu = 0.3\nthickness = 1\nplane = \"stress\"\n" +
         rest;
}

TEST(SeveralNormals, NameCandidatesAfterTheTouchedSurface) {
  const auto names = [](const std::string& contact) {
    return wedged_problem(read_structure(square(contact), "s")).contact_names;
  };
  const std::vector<std::string> expected{"b.0,0@b.left", "b.0,1", "b.0,0@b.bottom", "b.1,0",
                                          "b.2,0"};
  EXPECT_EQ(names("[[contact]]\nnodes = [\"b.left\"]\nnormal = [1, 0]\n"
                  "[[contact]]\nnodes = [\"b.bottom\"]\nnormal = [0, 1]\n"),
            expected);
  EXPECT_EQ(names("[[contact]]\nnodes = [\"b.left\", \"b.bottom\"]\nnormal = \"surface\"\n"),
            expected);
  EXPECT_THAT(names("[[contact]]\nname = \"wall\"\nnodes = [\"b.0,0\"]\nnormal = [1, 0]\n"
                    "[[contact]]\nname = \"floor\"\nnodes = [\"b.bottom\"]\nnormal = [0, 1]\n"),
              ElementsAre("b.0,0@wall", "b.0,0@floor", "b.1,0", "b.2,0"));
  EXPECT_THAT(names("[[contact]]\nname = \"wall\"\nnodes = [\"b.0,0\"]\nnormal = [1, 0]\n"
                    "[[contact]]\nnodes = [\"b.0,0\", \"b.1,0\"]\nnormal = [0, 1]\n"),
              ElementsAre("b.0,0@1", "b.0,0@2", "b.1,0"));
}

// In a list of edges, a node of two edges has the normal of each.
TEST(SeveralNormals, OfASurfaceAreThoseOfItsEdges) {
  const Structure structure = read_structure(
      square("[[contact]]\nnodes = [\"b.left\", \"b.bottom\"]\nnormal = \"surface\"\n"), "s");
  ASSERT_EQ(structure.contact.size(), 5U);
  for (const int i : {0, 1})
    EXPECT_TRUE(structure.contact[static_cast<std::size_t>(i)].normal.isApprox(
        Eigen::Vector2d(1, 0), 1e-15));
  for (const int i : {2, 3, 4})
    EXPECT_TRUE(structure.contact[static_cast<std::size_t>(i)].normal.isApprox(
        Eigen::Vector2d(0, 1), 1e-15));
  const auto again = read_structure(structure_text(structure), "again");
  EXPECT_EQ(wedged_problem(again).contact_names, wedged_problem(checked(structure)).contact_names);
  EXPECT_EQ(wedged_problem(again).compliance.matrix,
            wedged_problem(checked(structure)).compliance.matrix);
}

std::string refusal(const Structure& structure) {
  try {
    wedged_problem(checked(structure));
  } catch (const support::InputError& error) {
    return error.what();
  }
  return "accepted";
}

Structure on_walls(int dimension, const std::vector<Eigen::VectorXd>& normals) {
  std::mt19937 bits(7);
  Structure structure = test::random_wedge(dimension, dimension + 4, bits);
  const int node = structure.contact.front().node;
  structure.contact.clear();
  for (const auto& normal : normals) structure.contact.push_back({node, normal, std::nullopt, 1});
  return structure;
}

TEST(SeveralNormals, AreRefusedIfLinearlyDependent) {
  const auto turned = [](double degrees) -> Eigen::VectorXd {
    const double angle = degrees * std::numbers::pi / 180;
    return Eigen::Vector2d(std::cos(angle), std::sin(angle));
  };
  EXPECT_EQ(refusal(on_walls(2, {turned(20), turned(20.2)})), "accepted");
  EXPECT_EQ(refusal(on_walls(2, {turned(20), turned(200.2)})), "accepted");
  for (const double other : {20.0, 20.09, 199.91, 200.0}) {
    EXPECT_THAT(refusal(on_walls(2, {turned(20), turned(other)})),
                HasSubstr("is a contact candidate twice with normals that are"));
  }
  EXPECT_THAT(refusal(on_walls(2, {turned(20), turned(80), turned(140)})),
              HasSubstr("is a contact candidate 3 times; expected at most 2 in the plane"));
  const Eigen::Vector3d x(1, 0, 0), y(0, 1, 0), z(0, 0, 1);
  EXPECT_EQ(refusal(on_walls(3, {x, y, z})), "accepted");
  EXPECT_THAT(refusal(on_walls(3, {x, y, (x + y + 0.001 * z).normalized()})),
              HasSubstr("is a contact candidate three times with normals that are"));
  EXPECT_THAT(refusal(on_walls(3, {x, y, z, (x + y + z).normalized()})),
              HasSubstr("is a contact candidate 4 times; expected at most 3 in space"));
}

TEST(SeveralNormals, AreRefusedIfNamesOfCandidatesCoincide) {
  Structure structure = on_walls(2, {Eigen::Vector2d(1, 0), Eigen::Vector2d(0, 1)});
  const int other = static_cast<int>(structure.node_names.size()) - 1;
  ASSERT_NE(other, structure.contact.front().node);
  const auto at = static_cast<std::size_t>(structure.contact.front().node);
  structure.node_names[static_cast<std::size_t>(other)] = structure.node_names[at] + "@2";
  structure.contact.push_back({other, Eigen::Vector2d(1, 0), std::nullopt, 1});
  EXPECT_THAT(refusal(structure), HasSubstr("are both called"));
}

}  // namespace
}  // namespace kusabi::problems
