// Tests of rays of unconstrained bodies against the definition: every choice of equalities.
#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include <Eigen/Core>
#include <gtest/gtest.h>

#include "dense.hpp"
#include "ray_oracles.hpp"
#include "solvers/rays/double_description.hpp"

namespace kusabi::rays {
namespace {

struct UnconstrainedProblem {
  Eigen::MatrixXd compliance;  // F, 2m x 2m
  Eigen::MatrixXd motions;     // G, 2m x p
  std::vector<double> friction;

  [[nodiscard]] ReactionCone cone() const {
    return {compliance.cast<long double>(), friction, motions.cast<long double>()};
  }
};

// Reactions above displacements of each ray: (r, u), 4m.
using States = std::vector<Eigen::VectorXd>;

constexpr double tolerance = 1e-9;

void add_if_new(States& list, const Eigen::VectorXd& state) {
  const bool known = std::any_of(list.begin(), list.end(), [&](const auto& each) {
    return (each - state).cwiseAbs().maxCoeff() < tolerance;
  });
  if (!known) list.push_back(state);
}

// In (r, alpha): equilibrium and as many of the 3m inequalities as leave one direction. All modes
// have a normal part.
States by_brute_force(const UnconstrainedProblem& problem) {
  const auto m = static_cast<Eigen::Index>(problem.friction.size());
  const Eigen::Index p = problem.motions.cols();
  Eigen::MatrixXd displacements(2 * m, 2 * m + p);
  displacements << problem.compliance, problem.motions;
  Eigen::MatrixXd inequalities = Eigen::MatrixXd::Zero(3 * m, 2 * m + p);
  for (Eigen::Index i = 0; i < m; ++i) {
    const double mu = problem.friction[static_cast<std::size_t>(i)];
    inequalities.block<2, 2>(2 * i, 2 * i) << mu, -1, mu, 1;
    inequalities.row(2 * m + i) = displacements.row(2 * i);
  }
  const Eigen::Index chosen_count = 2 * m - 1;
  Eigen::MatrixXd system = Eigen::MatrixXd::Zero(p + chosen_count, 2 * m + p);
  system.topLeftCorner(p, 2 * m) = problem.motions.transpose();
  std::vector<bool> chosen(static_cast<std::size_t>(3 * m), false);
  std::fill(chosen.begin(), chosen.begin() + chosen_count, true);
  States list;
  do {
    Eigen::Index at = p;
    for (Eigen::Index row = 0; row < 3 * m; ++row) {
      if (chosen[static_cast<std::size_t>(row)]) system.row(at++) = inequalities.row(row);
    }
    const Eigen::MatrixXd kernel = dense::kernel(system, 1e-11);
    if (kernel.cols() != 1) continue;
    Eigen::VectorXd point = kernel;
    if ((inequalities * point).sum() < 0) point = -point;
    Eigen::VectorXd state(4 * m);
    state << point.head(2 * m), displacements * point;
    const double load = state(Eigen::seqN(0, m, 2)).sum();
    const double size = load > tolerance ? load : state.cwiseAbs().maxCoeff();
    state /= size;
    if ((inequalities * point).minCoeff() < -tolerance * size) continue;
    const Eigen::ArrayXd products =
        state(Eigen::seqN(0, m, 2)).array() * state(Eigen::seqN(2 * m, m, 2)).array();
    if (products.maxCoeff() < tolerance) add_if_new(list, state);
  } while (std::prev_permutation(chosen.begin(), chosen.end()));
  return list;
}

States states(const ReactionCone& cone, const std::vector<ZeroSet>& rays) {
  States list;
  Health health;
  for (const auto& zero : rays) {
    const Ray ray = cone.ray(zero, health);
    list.emplace_back(ray.reaction.size() + ray.displacement.size());
    list.back() << ray.reaction, ray.displacement;
  }
  EXPECT_TRUE(health.sound());
  return list;
}

UnconstrainedProblem random_problem(int m, int p, std::mt19937& bits) {
  std::normal_distribution<double> number;
  std::uniform_real_distribution<double> friction(0.3, 2);
  UnconstrainedProblem problem;
  problem.compliance = test::random_compliance(m, bits);
  problem.motions = Eigen::MatrixXd::NullaryExpr(2 * m, p, [&] { return number(bits); });
  for (int i = 0; i < m; ++i) problem.friction.push_back(friction(bits));
  return problem;
}

TEST(UnconstrainedRays, AreThoseOfTheDefinition) {
  std::mt19937 bits(5);
  std::size_t loaded = 0;
  std::size_t alone = 0;
  for (int trial = 0; trial < 60; ++trial) {
    const int m = 2 + trial % 3;
    const auto problem = random_problem(m, 1 + trial % std::min(m, 3), bits);
    const auto cone = problem.cone();
    const auto found = complementary_rays(cone);
    EXPECT_TRUE(found.health.sound());
    const auto expected = by_brute_force(problem);
    const auto own = states(cone, found.rays);
    ASSERT_EQ(own.size(), expected.size()) << trial;
    for (const auto& state : own) {
      EXPECT_TRUE(std::any_of(expected.begin(), expected.end(), [&](const auto& other) {
        return (other - state).cwiseAbs().maxCoeff() < tolerance;
      })) << trial;
      (state.head(2 * m).norm() > 0 ? loaded : alone) += 1;
    }
  }
  EXPECT_GT(loaded, 100U);
  EXPECT_GT(alone, 100U);
}

// Rays of each sign pattern computed separately equal those of the whole in its cone.
TEST(UnconstrainedRays, OfAPatternAreThoseOfTheWholeInItsCone) {
  std::mt19937 bits(6);
  for (int trial = 0; trial < 20; ++trial) {
    const auto cone = random_problem(4, 3, bits).cone();
    const auto all = complementary_rays(cone).rays;
    for (Candidates contact = 0; contact < 16; ++contact) {
      std::vector<ZeroSet> expected;
      for (const auto& zero : all) {
        const Supports supports(zero, cone.all());
        if ((supports.separated() & contact) == 0 && (supports.reaction() & ~contact) == 0)
          expected.push_back(zero);
      }
      auto own = rays_of_pattern(cone, contact).rays;
      std::sort(own.begin(), own.end(), comes_before);
      std::sort(expected.begin(), expected.end(), comes_before);
      EXPECT_EQ(own, expected) << trial << ' ' << contact;
    }
  }
}

// A mode that slides along all surfaces is not an unknown, for any rounding of its direction.
TEST(PivotedModes, ThatOnlySlideRequireEquilibrium) {
  LongMatrix motions(4, 2);
  motions << 1, 1 + 1e-16L, 2, 3, -1, -1, 4, 5;
  const auto both = combined(motions);
  EXPECT_EQ(both.pivots, std::vector<int>{0});
  EXPECT_EQ(both.moves(0, 1), 0);
  EXPECT_EQ(both.moves(2, 1), 0);
  EXPECT_NEAR(std::abs(static_cast<double>(both.moves(1, 1))), 1, 1e-15);
}

}  // namespace
}  // namespace kusabi::rays
