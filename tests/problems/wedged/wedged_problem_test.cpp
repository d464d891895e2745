// Wedged problem: numbers known by hand, identities of K and F, independence of units and of the
// choice of tangents, and refusals of ill-conditioned structures.
#include "problems/wedged/wedged_problem.hpp"

#include <cmath>
#include <tuple>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "dense.hpp"
#include "problems/files/structure_file.hpp"
#include "tests/problems/trusses.hpp"

namespace kusabi::problems {
namespace {

/// A few roundings of numbers of the order of one.
constexpr double rounding = 1e-13;

/// K and F come from two factorisations; the example trusses have condition numbers of at most 1e4.
constexpr double condensed_rounding = 1e-10;

TEST(WedgedProblem, OfTwoBarsHasTheMatricesByHand) {
  const WedgedProblem problem = wedged_problem(checked(test::two_bars()));
  // Axes: K = diag(1, 3); n = (-1, 1) / sqrt 2, t = (1, 1) / sqrt 2.
  EXPECT_TRUE(problem.compliance.stiffness.isApprox(Eigen::Matrix2d{{2, 1}, {1, 2}}, rounding));
  EXPECT_TRUE(
      problem.compliance.matrix.isApprox(Eigen::Matrix2d{{2, -1}, {-1, 2}} / 3.0, rounding));
  EXPECT_EQ(problem.dimension, 2);
  EXPECT_EQ(problem.provenance.nodes, 3);
  EXPECT_EQ(problem.provenance.members, 2);
  EXPECT_THAT(problem.contact_names, testing::ElementsAre("node 2"));
  EXPECT_EQ(problem.provenance.units.force, "kN");
}

TEST(WedgedProblem, WithARollerHasTheComplianceByUnitLoads) {
  // A triangle a (0, 0), b (4, 0), c (2, 1.5), EA = 1; a is pinned, b rolls along x, load at c.
  // Forces by statics: a unit load along x gives ac 5/8, bc -5/8, ab 1/2; along y 5/6, 5/6, -2/3.
  Structure structure = test::empty_structure(2);
  const int a = test::add_node(structure, Eigen::Vector2d(0, 0));
  const int b = test::add_node(structure, Eigen::Vector2d(4, 0));
  const int c = test::add_node(structure, Eigen::Vector2d(2, 1.5));
  structure.fixed[0] = {true, true, false};
  structure.fixed[1] = {false, true, false};
  structure.members = {{a, c, 1.0}, {b, c, 1.0}, {a, b, 1.0}};
  structure.contact = {{c, Eigen::Vector2d(1, 0), std::nullopt}};  // t = (0, -1)
  const Eigen::Vector3d lengths(2.5, 2.5, 4.0);
  const Eigen::Vector3d by_x(5.0 / 8, -5.0 / 8, 1.0 / 2);
  const Eigen::Vector3d by_y(5.0 / 6, 5.0 / 6, -2.0 / 3);
  const double xx = by_x.cwiseAbs2().dot(lengths);
  const double yy = by_y.cwiseAbs2().dot(lengths);
  const double xy = by_x.cwiseProduct(by_y).dot(lengths);
  EXPECT_TRUE(wedged_problem(checked(structure))
                  .compliance.matrix.isApprox(Eigen::Matrix2d{{xx, -xy}, {-xy, yy}}, rounding));
}

class WedgedExample : public testing::TestWithParam<const char*> {
 protected:
  CheckedStructure structure_ = load_structure(test::source_path(GetParam()));
  WedgedProblem problem_ = wedged_problem(structure_);
};

TEST_P(WedgedExample, MatricesAreSymmetricDefiniteAndInverseToEachOther) {
  const auto& [stiffness, compliance] =
      std::tie(problem_.compliance.stiffness, problem_.compliance.matrix);
  EXPECT_EQ(stiffness, Eigen::MatrixXd(stiffness.transpose()));
  EXPECT_EQ(compliance, Eigen::MatrixXd(compliance.transpose()));
  EXPECT_TRUE((stiffness * compliance).isIdentity(condensed_rounding));
  EXPECT_GT(dense::eigenvalues(stiffness)(0), 0);
}

TEST_P(WedgedExample, ScalesWithTheAxialStiffness) {
  for (const double factor : {1e-6, 1e-3, 1e3, 1e9}) {
    Structure scaled = structure_;
    for (Member& member : scaled.members) member.axial_stiffness *= factor;
    const WedgedProblem problem = wedged_problem(checked(scaled));
    EXPECT_TRUE(problem.compliance.stiffness.isApprox(factor * problem_.compliance.stiffness,
                                                      condensed_rounding));
    EXPECT_TRUE(problem.compliance.matrix.isApprox(problem_.compliance.matrix / factor,
                                                   condensed_rounding));
  }
}

TEST_P(WedgedExample, ScalesWithTheUnitOfLength) {
  for (const double factor : {1e-9, 1e3}) {
    Structure scaled = structure_;
    scaled.coordinates *= factor;
    EXPECT_TRUE(wedged_problem(checked(scaled))
                    .compliance.stiffness.isApprox(problem_.compliance.stiffness / factor,
                                                   condensed_rounding));
  }
}

INSTANTIATE_TEST_SUITE_P(Examples, WedgedExample,
                         testing::Values("examples/two-bars.toml", "examples/plane-truss.toml",
                                         "examples/space-truss.toml"));

TEST(WedgedProblem, EigenvaluesAndNormalPartsDoNotDependOnTheTangents) {
  Structure structure = load_structure(test::source_path("examples/space-truss.toml"));
  const WedgedProblem problem = wedged_problem(checked(structure));
  std::mt19937 bits(9);
  for (ContactCandidate& candidate : structure.contact) {
    candidate.tangent = test::random_vector(3, bits);
  }
  const WedgedProblem turned = wedged_problem(checked(structure));
  ASSERT_FALSE(turned.compliance.stiffness.isApprox(problem.compliance.stiffness,
                                                    1e-3));  // the tangents differ
  EXPECT_TRUE(dense::eigenvalues(turned.compliance.stiffness)
                  .isApprox(dense::eigenvalues(problem.compliance.stiffness), condensed_rounding));
  const auto normals = Eigen::seq(0, Eigen::last, 3);
  EXPECT_TRUE(turned.compliance.stiffness(normals, normals)
                  .isApprox(problem.compliance.stiffness(normals, normals), condensed_rounding));
}

TEST(WedgedProblem, OfASlenderTrussHasTheComplianceOfStatics) {
  // The truss is statically determinate, so its compliance at the loaded node is sum N^2 L / EA.
  // Under a unit load upwards, the cut through bay i of n has the upper chord with the moment about
  // the lower left node of the bay, arm n - i, the lower chord with the moment about its upper
  // right node, arm n - i - 1, and the diagonal with sqrt 2; each vertical has 1.
  const int bays = 30;
  const WedgedProblem problem = wedged_problem(checked(test::cantilever(bays)));
  double compliance = 0.0;
  for (int bay = 0; bay < bays; ++bay) {
    const double upper = bays - bay;
    const double lower = bays - bay - 1;
    const double diagonal = std::sqrt(2.0);
    const double vertical = 1.0;
    compliance +=
        upper * upper + lower * lower + diagonal * diagonal * diagonal + vertical * vertical;
  }
  EXPECT_NEAR(problem.compliance.matrix(0, 0), compliance, 1e-9 * compliance);
}

template <typename Action>
std::string error_of(Action action) {
  try {
    action();
  } catch (const support::InputError& error) {
    return error.what();
  }
  return "no error";
}

TEST(WedgedProblem, RefusesAMechanismAndNamesMovingNodes) {
  EXPECT_EQ(error_of([] { wedged_problem(checked(test::cantilever(3, 2))); }),
            "test: the structure is a mechanism: \"node 6\", \"node 7\" move without straining any "
            "member; expected supports and members that prevent this");
}

TEST(WedgedProblem, NamesOnlyTheFirstOfManyMovingNodes) {
  EXPECT_THAT(error_of([] { wedged_problem(checked(test::cantilever(9, 0))); }),
              testing::HasSubstr("\"node 2\", \"node 3\", \"node 4\", \"node 5\", \"node 6\", "
                                 "\"node 7\" and 12 more move"));
}

TEST(WedgedProblem, RefusesATooIllConditionedStiffness) {
  const auto error_with = [](double axial_stiffness) {
    Structure structure = test::cantilever(3);
    for (std::size_t index = 0; index < structure.members.size(); index += 2) {
      structure.members[index].axial_stiffness = axial_stiffness;
    }
    return error_of([&] { wedged_problem(checked(structure)); });
  };
  for (const double axial_stiffness : {1e-30, 1e30}) {
    EXPECT_THAT(error_with(axial_stiffness),
                testing::StartsWith("test: the stiffness is too ill-conditioned"));
  }
  // Doubles have lost at least six digits here, but F is computed in higher precision.
  for (const double axial_stiffness : {1e-9, 1e11})
    EXPECT_EQ(error_with(axial_stiffness), "no error");
}

TEST(WedgedProblem, ChecksAStructureMadeByAProgram) {
  Structure structure = test::two_bars();
  structure.members[1].axial_stiffness = std::nan("");
  EXPECT_THAT(error_of([&] { wedged_problem(checked(structure)); }),
              testing::StartsWith("test: EA is nan"));
}

}  // namespace
}  // namespace kusabi::problems
