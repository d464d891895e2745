// Enclosures of K with pairs, multi-point constraints, inclined supports and rollers: consistent
// with the solver, and proved.
#include <random>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "nodes/evidence/verified_structure.hpp"
#include "problems/files/structure_file.hpp"
#include "problems/wedged/wedged_problem.hpp"
#include "searched.hpp"
#include "tests/problems/bodies.hpp"

namespace kusabi::verify {
namespace {

TEST(TwoBodies, HaveTheStiffnessOfTheSolver) {
  std::mt19937 bits(6);
  for (int draw = 0; draw < 20; ++draw) {
    SCOPED_TRACE(draw);
    const auto structure = problems::test::random_bodies(2 + draw % 2, bits);
    expect_same_stiffness(structure);
  }
}

TEST(TwoBodies, HaveCertificatesThatAreProved) {
  std::mt19937 bits(7);
  for (int draw = 0; draw < 6; ++draw) {
    SCOPED_TRACE(draw);
    const auto structure = problems::test::random_bodies(2 + draw % 2, bits);
    const auto own = evidence::verified_structure(structure);
    for (const double friction : {0.3, 2.0}) {
      const auto draft = searched(problems::wedged_problem(checked(structure)), friction);
      const auto found = verdict(draft.text(), &own);
      EXPECT_THAT(found.refusals, testing::IsEmpty());
      EXPECT_GT(found.infeasible + found.feasible.size(), 0U);
    }
  }
}

// An unconstrained peg, tapered by 1 in 4, between two elastic walls, and its nodes between theirs:
// it wedges from 1/4 on. Either body may be the unconstrained one.
TEST(TwoBodies, AreProvedIfOneIsUnconstrained) {
  const auto mesh = [](const std::string& name, const std::string& corners, int rows) {
    return "[[mesh]]\nname = \"" + name + "\"\ncorners = " + corners + "\ndivisions = [2, " +
           std::to_string(rows) +
           "]\nE = 2\nnu = 0.25\nthickness = 1\nplane = \"strain\"\njoin = false\n";
  };
  for (const std::string held : {"\"left.left\", \"right.right\"", "\"peg.top\", \"left.left\""}) {
    const auto structure = problems::read_structure(
        "name = \"p\"\ndimension = 2\nunits = {length = \"m\", force = \"N\"}\n" +
            mesh("left", "[[-2, 0], [-0.5, 0], [-1, 2], [-2, 2]]", 4) +
            mesh("right", "[[0.5, 0], [2, 0], [2, 2], [1, 2]]", 4) +
            mesh("peg", "[[-0.75, 1], [0.75, 1], [1, 2], [-1, 2]]", 3) + "[[supports]]\nnodes = [" +
            held +
            "]\n[[contact]]\nnodes = [\"peg.left\"]\nexcept = [\"peg.0,3\"]\n"
            "against = \"left.right\"\nnormal = [4, 1]\n"
            "[[contact]]\nnodes = [\"peg.right\"]\nexcept = [\"peg.2,3\"]\n"
            "against = \"right.left\"\nnormal = [-4, 1]\n",
        "peg");
    const auto own = evidence::verified_structure(structure);
    const auto problem = problems::wedged_problem(structure);
    EXPECT_EQ(problem.modes.matrix.cols(), 3);
    const auto below = verdict(written(problem, 0.2), &own);
    EXPECT_THAT(below.refusals, testing::IsEmpty());
    const auto above = verdict(written(problem, 0.5), &own);
    EXPECT_THAT(above.refusals, testing::IsEmpty());
    if (held.find("peg") != std::string::npos) continue;
    EXPECT_TRUE(below.feasible.empty());
    EXPECT_FALSE(above.feasible.empty());
  }
}

// Another pair, weight or direction has another K.
TEST(TwoBodies, AreDistinguishedFromOthers) {
  std::mt19937 bits(8);
  const auto structure = problems::test::random_bodies(2, bits);
  const auto text = searched(problems::wedged_problem(checked(structure)), 1).text();
  const auto refusals = [&](auto change) {
    auto other = evidence::verified_structure(structure);
    change(other);
    return verdict(text, &other).refusals;
  };
  EXPECT_THAT(refusals([](Structure&) {}), testing::IsEmpty());
  EXPECT_FALSE(refusals([](Structure& s) { s.contact[0].against[0].node += 1; }).empty());
  EXPECT_FALSE(refusals([](Structure& s) { s.contact[1].against[0].weight += 0.01; }).empty());
  EXPECT_FALSE(refusals([](Structure& s) { s.ties[0].to[0].weight += 0.01; }).empty());
  EXPECT_FALSE(refusals([](Structure& s) { s.inclined[0].direction[0] += 0.1; }).empty());
}

}  // namespace
}  // namespace kusabi::verify
