// All displacements and support reactions, by statics and by the stiffness of the whole structure.
#include "problems/wedged/whole_structure.hpp"

#include <random>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "problems/files/structure_file.hpp"
#include "problems/structure/model/truss.hpp"
#include "support/input_error.hpp"

namespace {

using namespace kusabi::problems;

Structure example(const std::string& name) {
  const auto file = std::string(KUSABI_SOURCE_DIR) + "/examples/" + name + ".toml";
  return read_structure(file_text(file), file);
}

Eigen::VectorXd random_reactions(const WedgedProblem& problem, std::mt19937& random) {
  std::normal_distribution<double> normal;
  return Eigen::VectorXd::NullaryExpr(problem.compliance.matrix.rows(),
                                      [&] { return normal(random); });
}

std::vector<double> list(const Eigen::VectorXd& vector) {
  return {vector.begin(), vector.end()};
}

// A load along one of two orthogonal bars causes no force in the other.
TEST(WholeStructure, CarriesALoadAlongABarToItsSupport) {
  const auto structure = read_structure(R"(
name = "corner"
dimension = 2
units = {length = "m", force = "kN"}
[nodes]
top = [0, 2]
foot = [0, 0]
side = [3, 2]
[[members]]
EA = 10
between = [["foot", "top"], ["top", "side"]]
[[supports]]
nodes = ["foot", "side"]
fixed = ["x", "y"]
[[contact]]
nodes = ["top"]
normal = [0, 1]
)",
                                        "corner");
  const WholeStructure whole(structure, wedged_problem(structure));
  const auto state = whole.under(std::vector<double>{5, 0});
  EXPECT_DOUBLE_EQ(state.displacements(1, 0), 5.0 * 2 / 10);
  EXPECT_DOUBLE_EQ(state.displacements(0, 0), 0);
  EXPECT_DOUBLE_EQ(state.reactions(1, 1), -5);
  EXPECT_DOUBLE_EQ(state.reactions(0, 1), 0);
  EXPECT_DOUBLE_EQ(state.reactions.col(2).norm(), 0);
  EXPECT_DOUBLE_EQ(state.axial_forces(0), 5);
  EXPECT_DOUBLE_EQ(state.axial_forces(1), 0);
  EXPECT_TRUE(whole.is_supported(1));
  EXPECT_FALSE(whole.is_supported(0));
  EXPECT_LE(state.imbalance, 1e-15);
}

// K^0 u are the forces on each node, of the obstacle and the supports only. K^0 is assembled anew,
// of the truss without its supports.
TEST(WholeStructure, IsInEquilibriumAtEveryNode) {
  for (const char* const name : {"space-truss", "plane-truss"}) {
    const auto structure = example(name);
    const auto problem = wedged_problem(checked(structure));
    const WholeStructure whole(checked(structure), problem);
    auto loose = structure;
    for (auto& axes : loose.fixed) axes = {false, false, false};
    const auto all = free_degrees(loose);
    const auto stiffness = truss_stiffness(loose, all, member_stiffnesses(loose));
    std::mt19937 random(7);
    for (int draw = 0; draw < 10; ++draw) {
      const auto r = random_reactions(problem, random);
      const auto state = whole.under(list(r));
      Eigen::MatrixXd acting = state.reactions;
      for (std::size_t i = 0; i < structure.contact.size(); ++i) {
        const auto d = static_cast<Eigen::Index>(structure.dimension);
        acting.col(structure.contact[i].node) +=
            problem.frames[i] * r.segment(d * static_cast<Eigen::Index>(i), d);
      }
      const Eigen::VectorXd internal = stiffness * state.displacements.reshaped();
      EXPECT_LE((internal - acting.reshaped()).norm(), 1e-12 * acting.norm()) << name;
    }
  }
}

// Reactions act only at supports; candidates move as F predicts. For elements, too, and for
// structures with several blocks.
TEST(WholeStructure, MovesCandidatesByTheCompliance) {
  for (const char* const name : {"space-truss", "plane-truss", "elastic-body"}) {
    const auto structure = example(name);
    const auto problem = wedged_problem(checked(structure));
    const WholeStructure whole(checked(structure), problem);
    std::mt19937 random(8);
    for (int draw = 0; draw < 10; ++draw) {
      const auto r = random_reactions(problem, random);
      const auto state = whole.under(list(r));
      const Eigen::VectorXd u = problem.compliance.matrix * r;
      const auto d = static_cast<Eigen::Index>(structure.dimension);
      for (std::size_t i = 0; i < structure.contact.size(); ++i) {
        const Eigen::VectorXd own =
            problem.frames[i].transpose() * state.displacements.col(structure.contact[i].node);
        EXPECT_LE((own - u.segment(d * static_cast<Eigen::Index>(i), d)).norm(), 1e-12 * u.norm());
      }
      for (std::size_t node = 0; node < structure.fixed.size(); ++node) {
        for (std::size_t axis = 0; axis < static_cast<std::size_t>(d); ++axis) {
          const auto row = static_cast<Eigen::Index>(axis);
          const auto column = static_cast<Eigen::Index>(node);
          EXPECT_EQ(structure.fixed[node][axis] ? state.displacements(row, column)
                                                : state.reactions(row, column),
                    0);
        }
      }
      EXPECT_LE(state.imbalance, 1e-13) << name;
    }
  }
}

// At every node of a truss, bar forces, contact forces and support reactions are in equilibrium.
TEST(WholeStructure, HasBarForcesInEquilibrium) {
  const auto structure = example("space-truss");
  const auto problem = wedged_problem(checked(structure));
  const WholeStructure whole(checked(structure), problem);
  std::mt19937 random(3);
  const auto reactions = list(random_reactions(problem, random));
  const auto state = whole.under(reactions);
  Eigen::MatrixXd rest = state.reactions + whole.contact_forces(reactions);
  const double size = rest.cwiseAbs().maxCoeff();
  for (std::size_t i = 0; i < structure.members.size(); ++i) {
    const auto& [first, second, stiffness, yield, mass, expansion] = structure.members[i];
    const Eigen::VectorXd along =
        (structure.coordinates.col(second) - structure.coordinates.col(first)).normalized();
    rest.col(first) += state.axial_forces(static_cast<Eigen::Index>(i)) * along;
    rest.col(second) -= state.axial_forces(static_cast<Eigen::Index>(i)) * along;
  }
  EXPECT_LT(rest.cwiseAbs().maxCoeff(), 1e-12 * size);
}

}  // namespace
