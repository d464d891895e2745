// Search of patterns without a tree, compared with all leaves of small problems; its cone programs,
// compared with the simplex method.
#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "engine/transport/single_process.hpp"
#include "faces.hpp"
#include "nodes/wedged/critical/critical_start.hpp"
#include "nodes/wedged/friction/critical_friction.hpp"
#include "nodes/wedged/pattern_search.hpp"
#include "nodes/wedged/primal/clusters.hpp"
#include "nodes/wedged/primal/primal_search.hpp"
#include "random_problem.hpp"
#include "solvers/conic/weighted_relaxation.hpp"
#include "solvers/linear/linear_program.hpp"
#include "solvers/linear/simplex.hpp"

namespace kusabi::wedged {
namespace {

using support::IndexSet;

// In the plane a reaction is a sum of two along the edges of its cone.
double min_friction_by_simplex(const Eigen::MatrixXd& compliance, double mu,
                               const Eigen::VectorXd& gap, const Eigen::VectorXd& reaction,
                               const Eigen::MatrixXd& motions) {
  const auto m = static_cast<int>(gap.size());
  linear::LinearProgram program;
  std::vector<linear::LinearTerm> sum;
  std::vector<Eigen::VectorXd> edges;  // u of a unit along each
  std::vector<Eigen::VectorXd> loads;
  for (int i = 0; i < m; ++i)
    for (const double slope : {mu, -mu}) {
      Eigen::VectorXd load = Eigen::VectorXd::Zero(2 * m);
      load[2 * i] = 1;
      load[2 * i + 1] = slope;
      loads.push_back(load);
      edges.emplace_back(compliance * load);
      double cost = reaction[i];
      for (int j = 0; j < m; ++j) cost += gap[j] * edges.back()[2 * j];
      sum.push_back({program.add_column({.cost = cost}), 1});
    }
  std::vector<int> alpha;
  for (Eigen::Index l = 0; l < motions.cols(); ++l) {
    double cost = 0;
    for (int j = 0; j < m; ++j) cost += gap[j] * motions(2 * j, l);
    alpha.push_back(program.add_column({.cost = cost, .lower = -linear::infinity}));
  }
  program.add_row({.lower = 1, .upper = 1}, sum);
  for (int j = 0; j < m; ++j) {
    std::vector<linear::LinearTerm> terms;
    for (std::size_t k = 0; k < edges.size(); ++k)
      terms.push_back({static_cast<int>(k), edges[k][2 * j]});
    for (std::size_t l = 0; l < alpha.size(); ++l)
      terms.push_back({alpha[l], motions(2 * j, static_cast<Eigen::Index>(l))});
    program.add_row({.lower = 0}, terms);
  }
  for (Eigen::Index l = 0; l < motions.cols(); ++l) {
    std::vector<linear::LinearTerm> terms;
    for (std::size_t k = 0; k < loads.size(); ++k)
      terms.push_back({static_cast<int>(k), loads[k].dot(motions.col(l))});
    program.add_row({.lower = 0, .upper = 0}, terms);
  }
  linear::Simplex simplex(program);
  simplex.use_slack_basis();
  if (simplex.solve_robustly() != linear::LinearStatus::optimal) return linear::infinity;
  return simplex.objective();
}

TEST(WeightedRelaxation, HasTheOptimumOfTheSimplexMethod) {
  constexpr int m = 8;
  constexpr double mu = 1.5;
  std::mt19937_64 generator(5);
  const auto uniform = [&] { return static_cast<double>(generator() >> 11) * 0x1p-53; };
  int compared = 0;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const auto problem = random_problem(2, m, seed);
    const Eigen::MatrixXd compliance =
        problem.compliance.matrix / problems::mean_normal_compliance(problem);
    const Eigen::Index loose = seed % 3;
    Eigen::MatrixXd motions(2 * m, loose);
    for (auto& entry : motions.reshaped()) entry = 2 * uniform() - 1;
    Eigen::VectorXd gap(m), reaction(m);
    for (int i = 0; i < m; ++i) {
      gap[i] = i % 2 == 0 ? uniform() : 0;
      reaction[i] = i % 2 == 0 ? 0 : uniform();
    }
    const double minimum = min_friction_by_simplex(compliance, mu, gap, reaction, motions);
    conic::WeightedRelaxation<2> relaxation(compliance,
                                            conic::ordered_motions<2, double>(motions, 0));
    const auto point = relaxation.minimise(std::vector<double>(m, mu), gap, reaction);
    ASSERT_EQ(point.has_value(), std::isfinite(minimum)) << seed;
    if (!point) continue;
    ++compared;
    EXPECT_NEAR(point->reaction.sum(), 1, 1e-6) << seed;
    EXPECT_NEAR(gap.dot(point->gap) + reaction.dot(point->reaction), minimum, 1e-6) << seed;
  }
  EXPECT_GT(compared, 10);
}

PrimalPattern found_in(const problems::WedgedProblem& problem, double infeasible = 0) {
  engine::SingleProcess alone;
  engine::Analysis analysis(alone);
  return search_primal(analysis, problem,
                       {.infeasible = infeasible, .maximum = 1000, .enough = 0, .known = {}})
      .best;
}

// True if any leaf is feasible at a coefficient, by enumeration.
bool any_sticks(CriticalFriction& critical, int m, double factor) {
  for (unsigned contact = 1; contact < 1U << static_cast<unsigned>(m); ++contact)
    if (critical.probe(leaf_with(IndexSet(contact), m), factor).sign == conic::Sign::feasible)
      return true;
  return false;
}

TEST(PrimalSearch, FindsTheLeastCriticalPatternOfMostSmallProblems) {
  constexpr int m = 6;
  int met = 0, tried = 0;
  for (const int dimension : {2, 3})
    for (std::uint64_t seed = 1; seed <= 8; ++seed) {
      const auto problem = random_problem(dimension, m, seed);
      const auto best = found_in(problem);
      CriticalFriction critical(problem, 1e-8);
      ASSERT_TRUE(best.is_known()) << dimension << ' ' << seed;
      EXPECT_EQ(critical.probe(leaf_with(best.contact, m), best.factor * (1 + 1e-9)).sign,
                conic::Sign::feasible)
          << dimension << ' ' << seed;
      ++tried;
      met += any_sticks(critical, m, best.factor * (1 - 3e-3)) ? 0 : 1;
    }
  EXPECT_GE(met, tried - 2);
}

TEST(PrimalSearch, StopsAtTheFirstSufficientPattern) {
  const auto problem = random_problem(3, 6, 1);
  const auto best = found_in(problem);
  engine::SingleProcess alone;
  engine::Analysis analysis(alone);
  const double enough = 2 * best.factor;
  const auto whole = search_primal(analysis, problem, {.maximum = 1000, .enough = 0, .known = {}});
  const auto part =
      search_primal(analysis, problem, {.maximum = 1000, .enough = enough, .known = {}});
  EXPECT_LE(part.best.factor, enough);
  EXPECT_LT(part.programs, whole.programs);
}

TEST(Clusters, PartitionTheCandidatesAndHaveTheirMeanCompliance) {
  const auto problem = random_problem(3, 12, 3);
  const auto clusters = clusters_of(problem, 4);
  IndexSet all;
  for (int cluster = 0; cluster < 4; ++cluster) {
    const auto members = clusters.members(IndexSet::single(cluster));
    EXPECT_FALSE(members.empty());
    EXPECT_FALSE(all.meets(members));
    all |= members;
  }
  EXPECT_EQ(all, IndexSet::below(12));
  // The mean normal displacement of a cluster under a unit reaction spread over it.
  const auto members = clusters.members(IndexSet::single(2));
  double mean = 0;
  for (const int i : members)
    for (const int j : members) mean += problem.compliance.matrix(3 * i, 3 * j);
  EXPECT_NEAR(clusters.problem.compliance.matrix(6, 6), mean / members.size() / members.size(),
              1e-12);
}

// Of the patterns of the list one is found, and none where the list is empty.
TEST(Patterns, ExistIfTheListIsNotEmpty) {
  int some = 0, none = 0;
  for (const auto& problem : {cantilever_face(26), leaning_face(26)})
    for (const double share : {0.9, 1.02}) {
      const double mu = share * found_in(problem).factor;
      const std::vector<double> friction(26, mu);
      engine::SingleProcess alone;
      engine::Analysis first(alone), second(alone);
      PatternParameters all;
      all.search.limits.nodes = 20000;
      const auto list = find_patterns(first, problem, friction, all);
      PatternParameters parameters;
      parameters.exists = true;
      const auto one = find_patterns(second, problem, friction, parameters);
      if (list.whole() && list.leaves.empty()) {
        EXPECT_TRUE(one.whole() && one.leaves.empty()) << mu;
        ++none;
      } else if (list.whole()) {
        ASSERT_FALSE(one.leaves.empty()) << mu;
        const auto same = std::ranges::count_if(list.leaves, [&](const auto& leaf) {
          return leaf.pattern == one.leaves.front().pattern;
        });
        EXPECT_EQ(same, 1) << mu;
        ++some;
      }
    }
  EXPECT_GT(some, 0);
  EXPECT_GT(none, 0);
}

}  // namespace
}  // namespace kusabi::wedged
