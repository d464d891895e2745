// Unconstrained bodies whose normals are directions of a mesh: parallel, or through an axis, up to
// their sixteenth digit. Infeasibility or feasibility with a margin is proved nevertheless.
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "nodes/evidence/verified_structure.hpp"
#include "problems/files/problem_text.hpp"
#include "problems/files/structure_file.hpp"
#include "problems/wedged/wedged_problem.hpp"
#include "searched.hpp"
#include "verify/wedged/certificate.hpp"
#include "verify/wedged/consistency.hpp"
#include "verify/wedged/proof.hpp"

namespace kusabi::verify {
namespace {

using testing::IsEmpty;

// An element of Gmsh by its type, and its nodes within a cell of 3 x 3 places.
struct Shape {
  const char* name;
  int type;
  bool middles;
  std::vector<std::vector<int>> elements;
};

const std::vector<Shape>& shapes() {
  static const std::vector<Shape> all{{"T3", 2, false, {{0, 2, 8}, {0, 8, 6}}},
                                      {"T6", 9, true, {{0, 2, 8, 1, 5, 4}, {0, 8, 6, 4, 7, 3}}},
                                      {"Q4", 3, false, {{0, 2, 8, 6}}},
                                      {"Q8", 16, true, {{0, 2, 8, 6, 1, 5, 7, 3}}}};
  return all;
}

// A wedge of 2 x 2 cells, its sides at an angle to the vertical, in a groove with the same angle.
problems::Structure wedge(const Shape& shape, double degrees) {
  const double lean = std::tan(degrees * std::numbers::pi / 180);
  constexpr int steps = 4;
  const auto tag = [](int column, int row) { return 1 + column + (steps + 1) * row; };
  std::string nodes;
  std::string elements;
  int count = 0;
  const auto add = [&](int type, int group, const std::vector<int>& tags) {
    elements += fmt::format("{} {} 2 {} {}", ++count, type, group, group);
    for (const int each : tags) elements += fmt::format(" {}", each);
    elements += '\n';
  };
  int node_count = 0;
  for (int row = 0; row <= steps; ++row) {
    for (int column = 0; column <= steps; ++column) {
      if (row % 2 == 1 && column % 2 == 1 && shape.type != 9) continue;  // inside a cell
      if ((row % 2 == 1 || column % 2 == 1) && !shape.middles) continue;
      const double y = 0.25 * row;
      const double x = (0.5 + y * lean) * (0.5 * column - 1);
      nodes += fmt::format("{} {} {} 0\n", tag(column, row), x, y);
      ++node_count;
    }
  }
  for (int row = 0; row < steps; row += 2) {
    for (const int side : {0, steps}) {
      std::vector<int> tags{tag(side, row), tag(side, row + 2)};
      if (shape.middles) tags.push_back(tag(side, row + 1));
      add(shape.middles ? 8 : 1, 1, tags);
    }
    for (int column = 0; column < steps; column += 2) {
      for (const auto& element : shape.elements) {
        std::vector<int> tags;
        for (const int place : element) tags.push_back(tag(column + place % 3, row + place / 3));
        add(shape.type, 2, tags);
      }
    }
  }
  problems::ProblemText text;
  text.meshes["w.msh"] = fmt::format(
      "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n2\n1 1 \"sides\"\n2 2 "
      "\"wedge\"\n$EndPhysicalNames\n$Nodes\n{}\n{}$EndNodes\n$Elements\n{}\n{}$EndElements\n",
      node_count, nodes, count, elements);
  text.toml = R"(
name = "wedge"
dimension = 2
units = { length = "mm", force = "N" }
[[mesh]]
name = "w"
file = "w.msh"
[[material]]
groups = ["w.wedge"]
E = 1000
nu = 0.3
thickness = 1
plane = "strain"
[[contact]]
nodes = ["w.sides"]
normal = "surface"
)";
  return problems::read_structure(text, "test");
}

TEST(RoundedNormals, OfWedgesOfEveryElementShapeAdmitAProof) {
  std::size_t far = 0;
  for (const double degrees : {5.0, 15.0, 30.0}) {
    const double critical = std::tan(degrees * std::numbers::pi / 180);
    for (const auto& shape : shapes()) {
      const auto body = wedge(shape, degrees);
      const auto own = evidence::verified_structure(body);
      const auto problem = problems::wedged_problem(checked(body));
      const auto below = verdict(written(problem, 0.97 * critical), &own);
      EXPECT_THAT(below.refusals, IsEmpty()) << shape.name << ' ' << degrees;
      EXPECT_THAT(below.feasible, IsEmpty());
      EXPECT_EQ(below.except_large_displacements, 0U);  // proved by a rigid-body mode alone
      const auto above = verdict(written(problem, 1.3 * critical), &own);
      EXPECT_THAT(above.refusals, IsEmpty()) << shape.name << ' ' << degrees;
      EXPECT_FALSE(above.feasible.empty());
      EXPECT_EQ(above.marginal, 0U);
      far += above.except_large_displacements;
    }
  }
  EXPECT_GT(far, 0U);
}

// Evidence for the infeasibility of other nodes does not prove it for a wedged one or for its
// ancestors.
TEST(RoundedNormals, AdmitNoProofOfInfeasibilityOfAWedgedNode) {
  const auto body = wedge(shapes()[3], 15);
  const auto text = written(problems::wedged_problem(checked(body)), 0.35);
  const auto certificate = read_certificate(text, "test");
  const auto agreed =
      std::get<ConsistentStructure>(consistency(certificate, evidence::verified_structure(body)));
  const Proof proof(certificate, agreed.stiffness, agreed.motions);
  std::size_t tried = 0;
  for (const auto& leaf : certificate.states) {
    for (auto node : certificate.nodes) {
      if (node.claim != Claim::infeasible) continue;
      node.contact = leaf.contact;
      node.separated = leaf.separated;
      for (int candidate = 0; candidate < 10; candidate += 3) {
        EXPECT_TRUE(proof.proof_result(node).refusal.has_value());
        ++tried;
        const auto one = support::IndexSet::single(candidate);
        node.contact -= one;
        node.separated -= one;
      }
    }
  }
  EXPECT_GT(tried, 100U);
}

// A round plug: its rotation about its axis is along its whole surface up to rounding.
TEST(RoundedNormals, OfAConeAdmitAProofThatAPlugWedges) {
  const auto plug = example_structure("morse-taper.toml");
  const auto own = evidence::verified_structure(plug);
  const auto text = written(problems::wedged_problem(checked(plug)), 0.03);
  const auto said = verdict(text, &own);
  EXPECT_THAT(said.refusals, IsEmpty());
  EXPECT_EQ(said.feasible.size(), 1U);
  EXPECT_EQ(said.marginal, 0U);
  // The leaf with other tangential reactions, or with less friction, is not proved.
  auto certificate = read_certificate(text, "test");
  const auto agreed = std::get<ConsistentStructure>(consistency(certificate, own));
  const auto refused = [&] {
    const Proof proof(certificate, agreed.stiffness, agreed.motions);
    for (const auto& state : certificate.states) {
      if (!proof.refusal(state)) return false;
    }
    return true;
  };
  EXPECT_FALSE(refused());
  for (auto& friction : certificate.friction) friction = 0.026;  // tan 1.5 degrees is 0.02618
  EXPECT_TRUE(refused());
  for (auto& friction : certificate.friction) friction = 0.03;
  for (auto& state : certificate.states) {
    for (auto& number : state.numbers) number = -number;
  }
  EXPECT_TRUE(refused());
}

}  // namespace
}  // namespace kusabi::verify
