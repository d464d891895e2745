// Pairs of bodies, multi-point constraints, inclined supports and rollers at candidates: by hand,
// by multipliers, and compared with equivalent structures.
#include <random>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "dense.hpp"
#include "problems/wedged/whole_structure.hpp"
#include "tests/problems/bodies.hpp"
#include "tests/problems/trusses.hpp"

namespace kusabi::problems {
namespace {

// A node on a bar along x and one along y, with stiffnesses of its own.
int crossing_bars(Structure& structure, double along_x, double along_y) {
  const int node = test::add_node(structure, Eigen::Vector2d(0, 0));
  const int right = test::add_node(structure, Eigen::Vector2d(1, 0));
  const int top = test::add_node(structure, Eigen::Vector2d(0, 1));
  test::fix(structure, right);
  test::fix(structure, top);
  structure.members.push_back({node, right, along_x, {}});
  structure.members.push_back({node, top, along_y, {}});
  return node;
}

TEST(TwoBodies, HaveTheSumOfBothCompliances) {
  Structure structure = test::empty_structure(2);
  const int a = crossing_bars(structure, 2, 8);
  const int b = crossing_bars(structure, 4, 1);
  structure.contact = {{a, Eigen::Vector2d(1, 0), std::nullopt, 1, std::nullopt, {{b, 1}}}};
  const auto problem = wedged_problem(checked(structure));
  EXPECT_EQ(problem.contact_names, std::vector<std::string>{"node 0|node 3"});
  EXPECT_DOUBLE_EQ(problem.compliance.matrix(0, 0), 1.0 / 2 + 1.0 / 4);
  EXPECT_DOUBLE_EQ(problem.compliance.matrix(1, 1), 1.0 / 8 + 1.0);
  EXPECT_DOUBLE_EQ(problem.compliance.matrix(0, 1), 0);

  // The opposite place half-way between two nodes: u_b = (u_1 + u_2)/2, and each takes half of the
  // force.
  const int c = crossing_bars(structure, 16, 5);
  structure.contact[0].against = {{b, 0.5}, {c, 0.5}};
  const auto between = wedged_problem(checked(structure));
  EXPECT_EQ(between.contact_names, std::vector<std::string>{"node 0|node 3+"});
  EXPECT_DOUBLE_EQ(between.compliance.matrix(0, 0), 1.0 / 2 + (1.0 / 4 + 1.0 / 16) / 4);
  EXPECT_DOUBLE_EQ(between.compliance.matrix(1, 1), 1.0 / 8 + (1.0 + 1.0 / 5) / 4);
}

TEST(TwoBodies, AgreeWithMultipliers) {
  std::mt19937 bits(3);
  for (int draw = 0; draw < 40; ++draw) {
    const Structure structure = test::random_bodies(2 + draw % 2, bits);
    SCOPED_TRACE(draw);
    const auto problem = wedged_problem(checked(structure));
    Eigen::MatrixXd expected = test::compliance_by_multipliers(structure);
    // The direction of the roller is independent of all others.
    const Eigen::Index held = expected.rows() - structure.dimension + 1;
    EXPECT_LE(expected.row(held).norm(), 1e-12 * expected.norm());
    EXPECT_GT(problem.compliance.matrix(held, held), 0);
    expected(held, held) = problem.compliance.matrix(held, held);
    EXPECT_LE((problem.compliance.matrix - expected).norm(), 1e-10 * expected.norm());
    EXPECT_LE(problem.compliance.precise_error, 1e-18);
    EXPECT_GT(dense::eigenvalues(problem.compliance.stiffness)(0), 0);
  }
}

TEST(TwoBodies, AreInEquilibrium) {
  std::mt19937 bits(4);
  for (int draw = 0; draw < 20; ++draw) {
    const Structure structure = test::random_bodies(2 + draw % 2, bits);
    const auto problem = wedged_problem(checked(structure));
    const WholeStructure whole(checked(structure), problem);
    const Eigen::VectorXd reactions = test::random_vector(problem.compliance.matrix.rows(), bits);
    const auto state = whole.under(
        std::span<const double>(reactions.data(), static_cast<std::size_t>(reactions.size())));
    // No moments: the places of random pairs and constraints do not match their weights.
    Eigen::VectorXd sum = state.reactions.rowwise().sum();
    for (std::size_t i = 0; i < structure.contact.size(); ++i) {
      double left = 1;
      for (const auto& share : structure.contact[i].against) left -= share.weight;
      const auto first = structure.dimension * static_cast<Eigen::Index>(i);
      sum += left * problem.frames[i] * reactions.segment(first, structure.dimension);
    }
    EXPECT_LE(sum.norm(), 1e-11 * state.reactions.norm());
    for (const auto& [node, direction] : structure.inclined) {
      EXPECT_LE(std::abs(state.displacements.col(node).dot(direction.normalized())),
                1e-14 * state.displacements.norm());
      const Eigen::VectorXd across =
          state.reactions.col(node) -
          state.reactions.col(node).dot(direction) / direction.squaredNorm() * direction;
      EXPECT_LE(across.norm(), 1e-12 * state.reactions.norm());
    }
    for (const auto& [node, to] : structure.ties) {
      Eigen::VectorXd place = Eigen::VectorXd::Zero(structure.dimension);
      for (const auto& [master, weight] : to) place += weight * state.displacements.col(master);
      EXPECT_LE((state.displacements.col(node) - place).norm(), 1e-14 * state.displacements.norm());
    }
  }
}

// A cantilever divided into two halves, which constraints connect.
TEST(TwoBodies, ConstrainedAtCoincidentNodesAreOneBody) {
  const Structure whole = test::cantilever(4);
  Structure tied = whole;
  for (const int node : {4, 5}) {  // of the second half, at x = 2
    const int twin = test::add_node(tied, whole.coordinates.col(node));
    for (Member& member : tied.members) {
      if (member.first == node && member.second > 5) member.first = twin;
      if (member.second == node && member.first > 5) member.second = twin;
    }
    tied.ties.push_back({twin, {{node, 1}}});
  }
  // The upright at x = 2 is connected to both of the second half.
  const auto one = wedged_problem(checked(whole));
  const auto two = wedged_problem(checked(tied));
  EXPECT_EQ(one.compliance.matrix, two.compliance.matrix);
  EXPECT_NE(one.provenance.fingerprint, two.provenance.fingerprint);
}

TEST(InclinedSupport, AlongAnAxisIsARoller) {
  for (const int axis : {0, 1}) {
    Structure fixed = test::cantilever(3);
    fixed.fixed[4][static_cast<std::size_t>(axis)] = true;
    Structure inclined = test::cantilever(3);
    inclined.inclined.push_back({4, -3 * Eigen::Vector2d::Unit(axis)});
    EXPECT_EQ(wedged_problem(checked(fixed)).compliance.matrix,
              wedged_problem(checked(inclined)).compliance.matrix);
  }
}

// A node on a bar along x, supported along (3, 4) / 5: it moves along (4, -3) / 5, and the
// elongation of the bar is 4/5 of that.
TEST(InclinedSupport, AdmitsMotionAcrossItsDirection) {
  Structure structure = test::empty_structure(2);
  const int tip = crossing_bars(structure, 10, 1e-9);
  structure.inclined.push_back({tip, Eigen::Vector2d(3, 4)});
  const int end = test::add_node(structure, Eigen::Vector2d(-1, 0));
  structure.members.push_back({tip, end, 5, {}});
  structure.fixed[static_cast<std::size_t>(end)] = {false, true, false};
  structure.contact = {{end, Eigen::Vector2d(-1, 0), std::nullopt, 1}};
  EXPECT_NEAR(wedged_problem(checked(structure)).compliance.matrix(0, 0), 1.0 / 10 + 1.0 / 5,
              1e-10);
}

// Half of a symmetric truss on rollers moves as the whole does under twice the load.
TEST(Roller, AtACandidateModelsAPlaneOfSymmetry) {
  const auto truss = [](bool half) {
    Structure structure = test::empty_structure(2);
    const int top = test::add_node(structure, Eigen::Vector2d(0, 1));
    const int right = test::add_node(structure, Eigen::Vector2d(1, 0));
    test::fix(structure, right);
    structure.members = {{top, right, 3, {}}};
    if (half) {
      structure.fixed[0][0] = true;
    } else {
      const int left = test::add_node(structure, Eigen::Vector2d(-1, 0));
      test::fix(structure, left);
      structure.members.push_back({top, left, 3, {}});
    }
    structure.contact = {{top, Eigen::Vector2d(0, -1), std::nullopt, 1}};
    return wedged_problem(checked(structure));
  };
  EXPECT_DOUBLE_EQ(truss(true).compliance.matrix(0, 0), 2 * truss(false).compliance.matrix(0, 0));
  EXPECT_EQ(truss(true).compliance.matrix(0, 1), 0);
}

std::string refusal(const Structure& structure) {
  try {
    wedged_problem(checked(structure));
  } catch (const support::InputError& error) {
    return error.what();
  }
  return "accepted";
}

TEST(TwoBodies, WrongPairsAreRefused) {
  using testing::HasSubstr;
  std::mt19937 bits(5);
  const Structure good = test::random_bodies(2, bits);
  EXPECT_EQ(refusal(good), "accepted");
  const auto spoilt = [&](auto change) {
    Structure structure = good;
    change(structure);
    return refusal(structure);
  };
  const auto& pairs = good.contact;
  EXPECT_THAT(spoilt([&](Structure& s) {
                s.contact[0].against = {{pairs[0].node, 1}};
              }),
              HasSubstr("with itself"));
  EXPECT_THAT(spoilt([&](Structure& s) {
                s.contact[0].against = {{pairs[1].node, 1}};
              }),
              HasSubstr("which is itself a dependent node"));
  EXPECT_THAT(spoilt([&](Structure& s) { s.contact[0].against[0].node = 99; }),
              HasSubstr("does not exist"));
  EXPECT_THAT(
      spoilt([&](Structure& s) { s.contact[0].against.push_back(s.contact[0].against[0]); }),
      HasSubstr("twice"));
  EXPECT_THAT(spoilt([&](Structure& s) { s.contact[0].against[0].weight = 0; }),
              HasSubstr("the weight"));
  EXPECT_THAT(spoilt([&](Structure& s) {
                s.ties.push_back({pairs[0].node, {{0, 1}}});
              }),
              HasSubstr("is a dependent node twice"));
  EXPECT_THAT(spoilt([&](Structure& s) { s.ties[0].to.clear(); }), HasSubstr("tied to no node"));
  EXPECT_THAT(spoilt([&](Structure& s) { s.inclined.push_back(s.inclined[0]); }),
              HasSubstr("supported twice"));
  EXPECT_THAT(spoilt([&](Structure& s) { s.inclined[0].direction.setZero(); }),
              HasSubstr("is not a direction"));
  EXPECT_THAT(spoilt([&](Structure& s) { s.inclined[0].node = pairs[3].node; }),
              HasSubstr("has an inclined support"));
  EXPECT_THAT(spoilt([&](Structure& s) { s.contact.back().normal = Eigen::Vector2d(0.6, 0.8); }),
              HasSubstr("across the obstacle"));
  EXPECT_THAT(spoilt([&](Structure& s) {
                s.fixed[static_cast<std::size_t>(pairs[0].node)][0] = true;
                s.contact[0].normal = Eigen::Vector2d(0, 1);
              }),
              HasSubstr("both or neither"));
  EXPECT_THAT(
      spoilt([&](Structure& s) { s.fixed[static_cast<std::size_t>(s.ties[0].node)][0] = true; }),
      HasSubstr("tied to others and supported"));
}

}  // namespace
}  // namespace kusabi::problems
