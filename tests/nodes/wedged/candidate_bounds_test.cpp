// Bounds of candidates compared with the configurations of the tree without cuts: rays, or walks to
// the boundary of each cone, must not exceed a bound.
#include "nodes/wedged/relaxation/candidate_bounds.hpp"

#include <algorithm>
#include <cstdint>
#include <optional>
#include <random>
#include <span>
#include <utility>
#include <vector>

#include <Eigen/Core>
#include <gtest/gtest.h>

#include "dense.hpp"
#include "engine/search.hpp"
#include "engine/transport/single_process.hpp"
#include "nodes/wedged/tree/sign_pattern_tree.hpp"
#include "problems/wedged/problem_block.hpp"
#include "random_problem.hpp"
#include "random_truss.hpp"
#include "solvers/rays/double_description.hpp"
#include "tests/support/thorough.hpp"

namespace kusabi::wedged {
namespace {

using problems::WedgedProblem;

// Candidates of the largest problems.
constexpr int max_candidates = test::thorough ? 8 : 7;

/// Number of comparisons with bounds, and of nontrivial bounds.
struct Compared {
  int numbers = 0;
  int close = 0;  ///< at least half of the bound
  int never = 0;  ///< sides excluded by the bounds
};

RootBounds bounds_of(const WedgedProblem& problem, const std::vector<double>& friction) {
  engine::SingleProcess alone;
  engine::Analysis analysis(alone);
  return bound_candidates(analysis, problem, friction, 0, {});
}

/// Checks a configuration (r, u) with these candidates in contact and these separated against the
/// bounds.
void expect_within(const std::vector<CandidateBounds>& bounds, const SignPattern& pattern,
                   const Eigen::VectorXd& r, const Eigen::VectorXd& scaled_u, int d,
                   Compared& compared) {
  constexpr double rounding = 1e-9;
  const auto compare = [&](double number, double bound) {
    EXPECT_LE(number, bound + rounding);
    ++compared.numbers;
    compared.close += number > bound / 2 ? 1 : 0;
  };
  for (const int i : pattern.contact) {
    EXPECT_TRUE(bounds[static_cast<std::size_t>(i)].can_touch());
    compare(r[d * i], bounds[static_cast<std::size_t>(i)].reaction);
  }
  for (const int i : pattern.separated) {
    EXPECT_TRUE(bounds[static_cast<std::size_t>(i)].can_separate());
    compare(scaled_u[d * i], bounds[static_cast<std::size_t>(i)].gap);
  }
  for (const int i : pattern.inactive) {
    EXPECT_GE(bounds[static_cast<std::size_t>(i)].gap, 0);
    EXPECT_GE(bounds[static_cast<std::size_t>(i)].reaction, 0);
  }
}

/// One cone D(Y), whose largest numbers a walk approaches. Uses only the definition of the cone.
class Cone {
 public:
  Cone(const WedgedProblem& problem, const std::vector<double>& friction, SignPattern pattern)
      : problem_(problem), friction_(friction), pattern_(std::move(pattern)) {
    const Eigen::Index d = problem.dimension;
    const Eigen::Index size = problem.compliance.matrix.rows();
    std::vector<Eigen::RowVectorXd> rows;
    Eigen::RowVectorXd sum = Eigen::RowVectorXd::Zero(size);
    for (Eigen::Index at = 0; at < size; at += d) sum[at] = 1;
    rows.push_back(sum);
    for (const int i : pattern_.contact) rows.emplace_back(problem.compliance.matrix.row(d * i));
    for (const int i : pattern_.separated)
      for (Eigen::Index c = 0; c < d; ++c)
        rows.emplace_back(Eigen::RowVectorXd::Unit(size, d * i + c));
    Eigen::MatrixXd equations(static_cast<Eigen::Index>(rows.size()), size);
    for (std::size_t k = 0; k < rows.size(); ++k)
      equations.row(static_cast<Eigen::Index>(k)) = rows[k].normalized();
    within_ =
        Eigen::MatrixXd::Identity(size, size) - dense::least_squares(equations, equations, 1e-12);
  }

  /// The point of the cone that is farthest from `start` towards `goal`, subject to the equations.
  [[nodiscard]] Eigen::VectorXd farthest(const Eigen::VectorXd& start,
                                         const Eigen::VectorXd& goal) const {
    const Eigen::VectorXd direction = within_ * goal;
    if (direction.norm() < 1e-9 * goal.norm()) return start;
    const Eigen::VectorXd step = direction.normalized();
    double inside = 0;
    double outside = 1e3;
    for (int halving = 0; halving < 60; ++halving) {
      const double middle = (inside + outside) / 2;
      (holds(start + middle * step) ? inside : outside) = middle;
    }
    return start + inside * step;
  }

 private:
  [[nodiscard]] bool holds(const Eigen::VectorXd& r) const {
    const Eigen::Index d = problem_.dimension;
    const Eigen::VectorXd u = problem_.compliance.matrix * r;
    return std::ranges::all_of(pattern_.separated, [&](int i) { return u[d * i] >= 0; }) &&
           std::ranges::all_of(pattern_.contact, [&](int i) {
             return r.segment(d * i + 1, d - 1).norm() <=
                    friction_[static_cast<std::size_t>(i)] * r[d * i];
           });
  }

  const WedgedProblem& problem_;
  const std::vector<double>& friction_;
  SignPattern pattern_;
  Eigen::MatrixXd within_;  // the projection onto the null space of the equations
};

/// Walks towards the largest reaction and gap of each candidate, and halfway back each time.
void compare_by_walks(const WedgedProblem& problem, const std::vector<double>& friction,
                      const Configuration& leaf, const std::vector<CandidateBounds>& bounds,
                      Compared& compared) {
  const int d = problem.dimension;
  const double unit = problems::mean_normal_compliance(problem);
  const Eigen::Map<const Eigen::VectorXd> given(leaf.reaction.data(),
                                                static_cast<Eigen::Index>(leaf.reaction.size()));
  const Eigen::VectorXd start = given;
  const auto expect = [&](const Eigen::VectorXd& r) {
    expect_within(bounds, leaf.pattern, r, problem.compliance.matrix * r / unit, d, compared);
  };
  expect(start);
  if (leaf.state != LeafState::feasible) return;
  const Cone cone(problem, friction, leaf.pattern);
  for (std::size_t i = 0; i < friction.size(); ++i) {
    const auto at = d * static_cast<Eigen::Index>(i);
    const Eigen::VectorXd goal = leaf.pattern.contact.contains(static_cast<int>(i))
                                     ? Eigen::VectorXd::Unit(start.size(), at)
                                     : Eigen::VectorXd(problem.compliance.matrix.col(at));
    Eigen::VectorXd r = start;
    for (int step = 0; step < 6; ++step) {
      const Eigen::VectorXd far = cone.farthest(r, goal);
      expect(far);
      r = start + (1 - 0.5 / (step + 1)) * (far - start);
      std::mt19937_64 generator(i + static_cast<std::size_t>(step));
      std::normal_distribution<double> normal;
      const auto aside =
          Eigen::VectorXd::NullaryExpr(start.size(), [&] { return normal(generator); });
      r = (r + cone.farthest(r, Eigen::VectorXd(aside))) / 2;
    }
  }
}

std::vector<Configuration> leaves_without_cuts(const WedgedProblem& problem,
                                               const std::vector<double>& friction) {
  SignPatternOptions options;
  options.tightening = Tightening::never;
  SignPatternTree tree(problem, friction, options);
  std::vector<Configuration> leaves;
  for (auto& found : engine::search(tree).solutions) leaves.push_back(std::move(found.solution));
  return leaves;
}

void compare(const WedgedProblem& problem, double mu, Compared& compared) {
  const std::vector<double> friction(problem.contact_names.size(), mu);
  const auto root = bounds_of(problem, friction);
  ASSERT_EQ(root.bounds.size(), friction.size());
  for (const auto& own : root.bounds)
    compared.never += (own.can_separate() ? 0 : 1) + (own.can_touch() ? 0 : 1);
  for (const auto& leaf : leaves_without_cuts(problem, friction))
    compare_by_walks(problem, friction, leaf, root.bounds, compared);
}

void expect_something(const Compared& compared) {
  EXPECT_GT(compared.numbers, 1000);
  EXPECT_GT(compared.close, 20) << "bounds that far away say little";
  EXPECT_GT(compared.never, 0);
}

class CandidateBoundsIn : public ::testing::TestWithParam<int> {};

TEST_P(CandidateBoundsIn, AreSatisfiedInEveryConeOfRandomMatrices) {
  Compared compared;
  for (int m = 5; m <= max_candidates; ++m)
    for (const double mu : {0.6, 1.2, 3.0})
      compare(random_problem(GetParam(), m, static_cast<std::uint64_t>(m)), mu, compared);
  expect_something(compared);
}

TEST_P(CandidateBoundsIn, AreSatisfiedInEveryConeOfRandomTrusses) {
  std::mt19937_64 generator(5);
  Compared compared;
  for (int m = 5; m <= max_candidates; ++m)
    for (const double mu : {0.5, 1.0, 2.0}) {
      const auto made = testing::random_problem(
          {.dimension = GetParam(), .candidates = m, .free_nodes = m + 2}, generator);
      compare(made.second, mu, compared);
    }
  expect_something(compared);
}

INSTANTIATE_TEST_SUITE_P(Dimension, CandidateBoundsIn, ::testing::Values(2, 3));

// In the plane a number is largest at a ray, and rays are found without cone programs.
TEST(CandidateBounds, AreSatisfiedByTheRaysOfEveryPatternInThePlane) {
  Compared compared;
  for (int m = 5; m <= max_candidates; ++m)
    for (const double mu : {0.6, 1.2, 3.0}) {
      const auto problem = random_problem(2, m, 100 + static_cast<std::uint64_t>(m));
      const std::vector<double> friction(static_cast<std::size_t>(m), mu);
      const auto root = bounds_of(problem, friction);
      const double unit = problems::mean_normal_compliance(problem);
      const rays::ReactionCone cone(problem.compliance.matrix.cast<long double>(), friction);
      for (const auto& zero : rays::complementary_rays(cone).rays) {
        rays::Health health;
        const auto ray = cone.ray(zero, health);
        SignPattern pattern;
        constexpr double nothing = 1e-12;
        for (int i = 0; i < m; ++i) {
          if (ray.reaction[2 * i] > nothing)
            pattern.contact.insert(i);
          else if (ray.displacement[2 * i] > nothing * unit)
            pattern.separated.insert(i);
          else
            pattern.inactive.insert(i);
        }
        expect_within(root.bounds, pattern, ray.reaction, ray.displacement / unit, 2, compared);
      }
    }
  EXPECT_GT(compared.numbers, 300);
  EXPECT_GT(compared.close, 20);
}

bool same(const ProvedBound& first, const ProvedBound& second) {
  return first.theorem == second.theorem && first.candidate == second.candidate &&
         first.side == second.side && first.maximum == second.maximum &&
         first.numbers == second.numbers;
}

// The ranks of a search: each has its own bounds, solves some of the programs of a group in its own
// order, and adds all bounds found.
TEST(CandidateBounds, AreBitwiseEqualOnAnyNumberOfRanks) {
  for (const int d : {2, 3}) {
    const int m = 8;
    const auto problem = random_problem(d, m, 9);
    const std::vector<double> friction(m, 1.2);
    const auto expected = bounds_of(problem, friction).proved;
    for (const int count : {1, 3}) {
      std::vector<CandidateBounding> ranks;
      for (int rank = 0; rank < count; ++rank)
        ranks.emplace_back(problem, friction, conic::Tolerances());
      for (int sweep = 0; sweep < 2; ++sweep) {
        std::vector<std::optional<ProvedBound>> found(2 * m);
        for (int piece = 2 * m - 1; piece >= 0; --piece)
          found[static_cast<std::size_t>(piece)] =
              ranks[static_cast<std::size_t>(piece * 7 % count)].improved(
                  piece / 2, piece % 2 == 0 ? Side::separated : Side::contact);
        for (auto& rank : ranks)
          for (const auto& one : found)
            if (one) rank.add_bound(*one);
      }
      for (const auto& rank : ranks) {
        ASSERT_GT(rank.proved().size(), 2U * m);
        ASSERT_GE(expected.size(), rank.proved().size());
        EXPECT_TRUE(std::ranges::equal(rank.proved(),
                                       std::span(expected).first(rank.proved().size()), same));
      }
    }
  }
}

}  // namespace
}  // namespace kusabi::wedged
