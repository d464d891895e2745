// Several contact normals at a node: the enclosed K is that of the solver, results are proved, and
// faulty claims are refused.
#include <random>
#include <string>
#include <utility>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "nodes/evidence/verified_structure.hpp"
#include "problems/files/structure_file.hpp"
#include "problems/wedged/wedged_problem.hpp"
#include "searched.hpp"
#include "tests/problems/bodies.hpp"
#include "tests/problems/corners.hpp"
#include "verify/wedged/certificate.hpp"

namespace kusabi::verify {
namespace {

using testing::IsEmpty;

TEST(SeveralNormals, HaveTheStiffnessOfTheSolver) {
  std::mt19937 bits(6);
  for (int draw = 0; draw < 20; ++draw) {
    SCOPED_TRACE(draw);
    const auto structure = problems::test::random_corners(2 + draw % 2, bits);
    expect_same_stiffness(structure);
    if (draw < 4) expect_same_stiffness(problems::test::with_a_matrix(structure));
  }
}

TEST(SeveralNormals, HaveCertificatesThatAreProved) {
  std::mt19937 bits(7);
  for (int draw = 0; draw < 3; ++draw) {
    SCOPED_TRACE(draw);
    const auto structure = problems::test::random_corners(2 + draw % 2, bits);
    const auto own = evidence::verified_structure(structure);
    for (const double friction : {0.3, 0.6}) {
      const auto found =
          verdict(written(problems::wedged_problem(checked(structure)), friction), &own);
      EXPECT_THAT(found.refusals, IsEmpty());
      EXPECT_EQ(found.marginal, 0U);
      EXPECT_GT(found.infeasible, 0U);
    }
  }
}

/// A truss that hangs between two walls, its tip in a corner.
problems::Structure hanging(const std::string& wall, const std::string& corner) {
  return problems::read_structure(
      fmt::format(
          "name = \"h\"\ndimension = 2\nunits = {{ length = \"m\", force = \"N\" }}\n"
          "[nodes]\ntip = [0, 0]\na = [-1, 1]\nb = [1, 1]\nc = [-1, 2]\nd = [1, 2]\n"
          "[[members]]\nEA = 1\nbetween = [[\"tip\", \"a\"], [\"tip\", \"b\"], [\"a\", \"b\"], "
          "[\"a\", \"c\"], [\"b\", \"d\"], [\"a\", \"d\"], [\"b\", \"c\"]]\n"
          "[[supports]]\nnodes = [\"c\", \"d\"]\n"
          "[[contact]]\nnodes = [\"a\"]\nnormal = [{0}]\n"
          "[[contact]]\nnodes = [\"tip\"]\nnormal = [{1}]\n"
          "[[contact]]\nnodes = [\"tip\"]\nnormal = [-{1}]\n"
          "[[contact]]\nnodes = [\"b\"]\nnormal = [-{0}]\n",
          wall, corner),
      "h");
}

// A node that wedges by itself makes degenerate nodes, which have no claims; other feasible leaves
// have.
TEST(SeveralNormals, HavePatternsThatAreProved) {
  for (const std::string wall : {"1, 1", "4, -1"}) {
    for (const std::string corner : {"1, 4", "1, 1"}) {
      const auto structure = hanging(wall, corner);
      const auto own = evidence::verified_structure(structure);
      const auto found = verdict(written(problems::wedged_problem(checked(structure)), 3), &own);
      EXPECT_THAT(found.refusals, IsEmpty());
      EXPECT_EQ(found.feasible.size(), 2U);
      EXPECT_EQ(found.marginal == 0, corner == "1, 4");
    }
  }
}

TEST(SeveralNormals, AreDistinguishedFromOthers) {
  std::mt19937 bits(8);
  const auto structure = problems::test::random_corners(2, bits);
  const auto text = written(problems::wedged_problem(checked(structure)), 0.6);
  const auto refusals = [&](auto change) {
    auto other = evidence::verified_structure(structure);
    change(other);
    return verdict(text, &other).refusals;
  };
  EXPECT_THAT(refusals([](Structure&) {}), IsEmpty());
  EXPECT_FALSE(refusals([](Structure& s) { s.contact[1].normal[0] += 0.01; }).empty());
  EXPECT_FALSE(refusals([](Structure& s) { s.contact[2].against[0].weight += 0.01; }).empty());
  EXPECT_FALSE(refusals([](Structure& s) { s.contact[2].surface = "left"; }).empty() &&
               refusals([](Structure& s) { s.contact[1].node += 1; }).empty());
  EXPECT_FALSE(refusals([](Structure& s) { std::swap(s.contact[0], s.contact[1]); }).empty());
}

// An infeasible node claimed feasible, a feasible leaf claimed infeasible, and a leaf with an
// opposite tangential reaction.
TEST(SeveralNormals, HaveCertificatesThatAreRefusedIfFalsified) {
  std::size_t leaves = 0;
  std::size_t infeasible_nodes = 0;
  for (const std::string wall : {"1, 1", "4, -1"}) {
    const auto structure = hanging(wall, "1, 4");
    const auto own = evidence::verified_structure(structure);
    const auto draft = searched(problems::wedged_problem(checked(structure)), 3);
    ASSERT_THAT(verdict(draft.text(), &own).refusals, IsEmpty());
    const auto refused = [&](std::size_t i, const std::string& line) {
      auto other = draft;
      other.nodes[i] = line;
      try {
        return !verdict(other.text(), &own).proved();
      } catch (const CertificateError&) {  // not even as many numbers
        return true;
      }
    };
    std::size_t tried = 0;
    for (std::size_t i = 0; i < draft.nodes.size(); ++i) {
      const auto& line = draft.nodes[i];
      if (line.starts_with("wedged")) {
        EXPECT_TRUE(refused(i, "infeasible" + line.substr(6)));
        const auto last = line.rfind(' ') + 1;
        const bool negative = line[last] == '-';
        EXPECT_TRUE(refused(i, line.substr(0, last) +
                                   (negative ? line.substr(last + 1) : "-" + line.substr(last))));
        ++leaves;
      } else if (line.starts_with("infeasible") && ++tried < 4) {
        EXPECT_TRUE(refused(i, "wedged" + line.substr(10)));
        ++infeasible_nodes;
      }
    }
  }
  EXPECT_GT(leaves, 2U);
  EXPECT_GT(infeasible_nodes, 5U);
}

problems::Structure in_groove(const std::string& corners, const std::string& contact) {
  return problems::read_structure(
      fmt::format("name = \"g\"\ndimension = 2\nunits = {{ length = \"m\", force = \"N\" }}\n"
                  "[[mesh]]\nname = \"b\"\ncorners = {}\ndivisions = [2, 2]\n"
                  "E = 1000\nnu = 0.3\nthickness = 1\nplane = \"stress\"\n{}",
                  corners, contact),
      "g");
}

// A square that stands on its vertex in a groove, on a wall and the floor, and a brick in a corner
// of three walls: none has other supports.
TEST(SeveralNormals, OfAnUnconstrainedBodyAreProved) {
  const auto diamond = in_groove("[[0, 0], [1, 1], [0, 2], [-1, 1]]",
                                 "[[contact]]\nname = \"right\"\nnodes = [\"b.bottom\"]\n"
                                 "normal = [-1, 1]\n[[contact]]\nname = \"left\"\n"
                                 "nodes = [\"b.left\"]\nnormal = [1, 1]\n");
  const problems::Structure brick = problems::read_structure(
      "name = \"b\"\ndimension = 3\nunits = { length = \"m\", force = \"N\" }\n"
      "[nodes]\na = [0, 0, 0]\nb = [1, 0, 0]\nc = [0, 1, 0]\nd = [0, 0, 1]\n"
      "[[members]]\nEA = 2\nbetween = [[\"a\", \"b\"], [\"a\", \"c\"], [\"a\", \"d\"], [\"b\", "
      "\"c\"], [\"b\", \"d\"], [\"c\", \"d\"]]\n"
      "[[contact]]\nnodes = [\"a\"]\nnormal = [4, 1, 0]\n"
      "[[contact]]\nnodes = [\"a\"]\nnormal = [1, 4, 1]\n"
      "[[contact]]\nnodes = [\"b\"]\nnormal = [-4, 1, 1]\n"
      "[[contact]]\nnodes = [\"c\"]\nnormal = [1, -4, 1]\n",
      "b");
  for (const auto* structure : {&diamond, &brick}) {
    const auto problem = problems::wedged_problem(checked(*structure));
    EXPECT_GT(problem.modes.matrix.cols(), 0);
    const auto own = evidence::verified_structure(*structure);
    for (const double friction : {0.9, 1.1}) {
      const auto found = verdict(written(problem, friction), &own);
      EXPECT_THAT(found.refusals, IsEmpty()) << structure->name;
      EXPECT_GT(found.infeasible, 0U);
    }
  }
}

}  // namespace
}  // namespace kusabi::verify
