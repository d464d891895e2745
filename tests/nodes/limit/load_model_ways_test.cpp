// The load model f_D + T zeta by independent ways: all signs decided, the 0-1 program, equal
// parameters, the vertices of an example, a truss by hand.
#include <algorithm>
#include <limits>
#include <string>
#include <vector>

#include "nodes/limit/root/master.hpp"
#include "nodes/limit/search/limit_evidence.hpp"
#include "problems/files/structure_file.hpp"
#include "tests/nodes/limit/load_model.hpp"
#include "tests/nodes/limit/two_bars.hpp"
#include "verify/limit/limit_proof.hpp"
#include "verify/limit/sign_cover.hpp"

namespace kusabi::limit {
namespace {

using test::findings;
using test::near;
using test::PlainTruss;
using test::problem_of;

TEST(LoadModel, WorstCaseOfTheExampleIsThatOfAllVertices) {
  const auto truss = problems::load_structure(KUSABI_SOURCE_DIR "/examples/gust.toml");
  const PlainTruss plain(truss);
  for (const double alpha : {0.1, 0.5, 1.0, 2.0}) {
    const auto answer = findings(truss, {.alpha = alpha}).answer;
    EXPECT_TRUE(answer.whole());
    const auto minimum = plain.min_over_corners(alpha);
    EXPECT_EQ(answer.worst->status, minimum ? RootStatus::closed : RootStatus::not_carried)
        << alpha;
    if (minimum) {
      EXPECT_NEAR(answer.worst->ends.at_most(), *minimum, near);
    }
  }
}

// With all signs decided static cuts are exact: the least of 2^m linear programs is that of 2^m
// vertices, and their duals prove it.
TEST(LoadModel, IsProvedByTheLinearProgramsOfAllSigns) {
  unsigned compared = 0;
  for (unsigned seed = 1; seed <= 40; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const auto [truss, alpha] = test::correlated_truss(seed);
    const auto problem = problem_of(truss);
    if (!problem) continue;
    const auto minimum = PlainTruss(truss).min_over_corners(alpha);
    if (!minimum) continue;
    const auto model = limit_model(*problem);
    const auto m = static_cast<unsigned>(problem->uncertain_count());
    Master master(model, alpha / model.force_unit);
    double bound = std::numeric_limits<double>::infinity();
    std::vector<ClosedNode> nodes;
    for (unsigned corner = 0; corner < 1U << m; ++corner) {
      Signs signs(m);
      for (unsigned j = 0; j < m; ++j) signs[j] = ((corner >> j) & 1U) != 0 ? 1 : -1;
      master.decide(signs);
      const bool solved = master.solve();
      if (master.is_infeasible()) break;  // no motion has these signs
      ASSERT_TRUE(solved);
      bound = std::min(bound, master.objective() * model.factor_unit);
      ASSERT_TRUE(master.solve_with_margin(first_room));
      nodes.push_back(closed_node(master.proof(), {}));
    }
    if (nodes.size() < 1U << m) continue;
    EXPECT_NEAR(bound, *minimum, near);
    const Worst worst{Eigen::VectorXd::Zero(m),
                      {0, {}, Eigen::VectorXd::Zero(problem->free_count())}};
    const auto theorem = theorem_of(*problem, model, alpha, worst, {}, nodes);
    EXPECT_FALSE(verify::flaw_of_sign_cover(theorem.nodes, m));
    const auto meant = verify::limit_truss(
        with_loads(evidence::verified_structure(truss), *problem, alpha).value());
    const verify::LimitProof proof(meant.value(), theorem.cuts);
    for (const auto& node : theorem.nodes) {
      const auto lower = proof.lower(node);
      ASSERT_TRUE(std::holds_alternative<mpq_class>(lower)) << std::get<std::string>(lower);
      EXPECT_GE(std::get<mpq_class>(lower).get_d(), *minimum - near);
    }
    ++compared;
  }
  EXPECT_GE(compared, 5U);
}

TEST(LoadModel, AgreesWithTheZeroOneProgram) {
  unsigned compared = 0;
  for (unsigned seed = 1; seed <= 40; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const auto [truss, alpha] = test::correlated_truss(seed);
    if (!problem_of(truss)) continue;
    const auto minimum = PlainTruss(truss).min_over_corners(alpha);
    if (!minimum) continue;
    for (const auto method :
         {LimitMethod::fixed, LimitMethod::disjunctive, LimitMethod::tightened, LimitMethod::all}) {
      const auto found = findings(truss, {.alpha = alpha, .method = method}).answer;
      ASSERT_TRUE(found.worst);
      EXPECT_NEAR(found.worst->ends.at_most(), *minimum, near);
      if (!found.worst->zero_one) continue;
      EXPECT_NEAR(found.worst->zero_one->lower, *minimum, near);
      ++compared;
    }
  }
  EXPECT_GE(compared, 60U);
}

double factor_at(const LoadCurve& curve, double beta) {
  for (const auto& piece : curve.pieces) {
    if (beta <= piece.to) return piece.from.factor + piece.from.slope * (beta - piece.from.at);
  }
  return std::numeric_limits<double>::quiet_NaN();
}

TEST(LoadModel, AgreesWithCurvesAndSamples) {
  unsigned compared = 0;
  for (unsigned seed = 1; seed <= 15; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const auto [truss, alpha] = test::correlated_truss(seed);
    if (!problem_of(truss)) continue;
    const PlainTruss plain(truss);
    if (!plain.min_over_corners(alpha)) continue;
    const auto found = findings(truss, {.alpha = alpha, .samples = 20, .curve = true}).answer;
    ASSERT_TRUE(found.curve && found.worst_curve);
    for (const double beta : {0.0, 0.3, 0.7, 1.0}) {
      const auto minimum = plain.min_over_corners(beta * alpha).value();
      EXPECT_NEAR(factor_at(*found.worst_curve, beta), minimum, near);
      EXPECT_GE(factor_at(*found.curve, beta), minimum - near);
    }
    EXPECT_NEAR(factor_at(*found.curve, 1), found.worst->ends.at_most(), near);
    ASSERT_EQ(found.samples.size(), 20U);
    EXPECT_GE(std::ranges::min(found.samples), found.worst->ends.at_least() - near);
    ++compared;
  }
  EXPECT_GE(compared, 5U);
}

// A parameter that occurs twice counts twice, with either sign: T need not have full rank.
TEST(LoadModel, AddsUpEqualParameters) {
  for (unsigned seed = 1; seed <= 30; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    auto [truss, alpha] = test::correlated_truss(seed);
    if (!problem_of(truss)) continue;
    auto twice = truss;
    auto opposite = twice.uncertain->front();
    opposite.name = "opposite";
    for (auto& component : opposite.components) component.weight *= -1;
    twice.uncertain->push_back(opposite);
    for (auto& component : truss.uncertain->front().components) component.weight *= 2;
    const auto one = findings(truss, {.alpha = alpha}).answer;
    const auto two = findings(twice, {.alpha = alpha}).answer;
    ASSERT_EQ(one.worst.has_value(), two.worst.has_value());
    if (!one.worst) continue;
    EXPECT_EQ(one.worst->status, two.worst->status);
    if (one.worst->status != RootStatus::closed) continue;
    EXPECT_NEAR(one.worst->ends.at_most(), two.worst->ends.at_most(), near);
  }
}

// With zeta (1, -1) the factor is min(3 - zeta, 5 + zeta).
TEST(LoadModel, OfTwoBarsIsThatOfTheHandCalculation) {
  const auto minimum = [](const std::string& uncertainty, double alpha) {
    const auto truss = problems::read_structure(two_bars(uncertainty), "two-bars.toml");
    const auto answer = findings(truss, {.alpha = alpha}).answer;
    EXPECT_TRUE(answer.whole());
    return answer.worst->ends.at_most();
  };
  const std::string across =
      "[[uncertainty]]\nname = \"across\"\nforces = [{ nodes = [\"tip\"], force = [1, -1] }]\n";
  const std::string more =
      "[[uncertainty]]\nname = \"more\"\nforces = [{ nodes = [\"tip\"], force = [-0.5, 0.5] }]\n";
  EXPECT_NEAR(minimum(across, 0.5), 2.5, 1e-9);
  EXPECT_NEAR(minimum(across, 2), 1, 1e-9);
  EXPECT_NEAR(minimum(across + more, 1), 1.5, 1e-9);
  // Loads along the reference load, which assumption 3.1 (ii) excludes: q = lambda + zeta in the
  // level bar alone, and in both.
  const std::string level = "[[uncertainty]]\nnodes = [\"tip\"]\naxes = [\"x\"]\n";
  const std::string along =
      "[[uncertainty]]\nname = \"along\"\nforces = [{ nodes = [\"tip\"], force = [1, 1] }]\n";
  EXPECT_NEAR(minimum(level, 0.5), 2.5, 1e-9);
  EXPECT_NEAR(minimum(along, 0.5), 2.5, 1e-9);
  EXPECT_NEAR(minimum(along, 4), -1, 1e-9);
}

// A parameter of c f_R decreases the least factor by alpha |c| for any other uncertain loads; a
// parameter on a component with reference load is like any other.
TEST(LoadModel, AdmitsParametersAlongTheReferenceLoad) {
  unsigned compared = 0;
  for (unsigned seed = 1; seed <= 25; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    auto [truss, alpha] = test::correlated_truss(seed);
    if (!problem_of(truss)) continue;
    const auto before = PlainTruss(truss).min_over_corners(alpha);
    problems::UncertainParameter along{"along", {}};
    for (const auto& load : truss.loads) {
      if (load.kind != problems::Load::Kind::reference) continue;
      for (int axis = 0; axis < truss.dimension; ++axis) {
        if (load.force(axis) != 0)
          along.components.push_back({load.node, axis, 0.25 * load.force(axis)});
      }
    }
    auto& parameters = *truss.uncertain;
    parameters.push_back(along);
    if (before) {
      EXPECT_NEAR(PlainTruss(truss).min_over_corners(alpha).value(), *before - alpha / 4, near);
    }
    parameters.push_back({"component", {along.components.front()}});
    const auto found = findings(truss, {.alpha = alpha});
    const auto minimum = PlainTruss(truss).min_over_corners(alpha);
    if (!minimum) continue;
    ASSERT_TRUE(found.answer.worst && !found.theorems.empty());
    EXPECT_TRUE(found.answer.whole());
    EXPECT_NEAR(found.answer.worst->ends.at_most(), *minimum, near);
    const auto claim = test::shown(found.theorems.front(), truss);
    EXPECT_EQ(claim.why, "");
    EXPECT_LE(claim.lower, *minimum + near);
    EXPECT_NEAR(claim.lower, claim.upper, near);
    ++compared;
  }
  EXPECT_GE(compared, 8U);
}

}  // namespace
}  // namespace kusabi::limit
