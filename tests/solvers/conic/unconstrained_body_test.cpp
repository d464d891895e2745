// Tests of node programs of unconstrained bodies: strong duality, and a wedge in a groove with a
// closed form from equilibrium.
#include <cmath>
#include <numbers>
#include <random>

#include <gtest/gtest.h>

#include "solvers/conic/node_solver.hpp"
#include "tests/solvers/conic/contact_problem.hpp"
#include "tests/solvers/conic/cut_candidate.hpp"

namespace kusabi::conic {
namespace {

using support::IndexSet;
using testing::random_masks;

struct UnconstrainedProblem {
  Eigen::MatrixXd compliance;
  Eigen::MatrixXd motions;
  std::vector<double> friction;
};

/// Frames and positions of candidates all around a body, and its rigid-body modes in these frames.
Eigen::MatrixXd rigid_motions(int d, int m, std::mt19937_64& generator) {
  std::normal_distribution<double> normal;
  const int p = d == 2 ? 3 : 6;
  Eigen::MatrixXd motions(d * m, p);
  for (int i = 0; i < m; ++i) {
    Eigen::VectorXd place(d), direction(d);
    for (int k = 0; k < d; ++k) place[k] = normal(generator);
    for (int k = 0; k < d; ++k) direction[k] = -place[k] + 0.3 * normal(generator);
    // An orthonormal frame that begins with the direction.
    Eigen::MatrixXd frame = Eigen::MatrixXd::Random(d, d);
    frame.col(0) = direction;
    frame = dense::orthonormal(frame);
    if (frame.col(0).dot(direction) < 0) frame = -frame;
    Eigen::MatrixXd here = Eigen::MatrixXd::Identity(d, p);
    int column = d;
    for (int a = 0; a < d; ++a)
      for (int b = a + 1; b < d; ++b, ++column) {
        here(a, column) = -place[b];
        here(b, column) = place[a];
      }
    motions.middleRows(d * i, d) = frame.transpose() * here;
  }
  return motions;
}

template <int D>
UnconstrainedProblem random_unconstrained(int m, std::mt19937_64& generator) {
  auto held = testing::random_problem(D, m, 0.1, 1.0, generator);
  return {held.compliance, rigid_motions(D, m, generator), held.friction};
}

template <int D>
NodeSolver<D> solver_of(const UnconstrainedProblem& problem, Tolerances tolerances = {}) {
  std::vector<int> owners(problem.friction.size());
  for (std::size_t i = 0; i < owners.size(); ++i) owners[i] = static_cast<int>(i);
  return NodeSolver<D>(problem.compliance, problem.friction, owners, tolerances, 0,
                       ordered_motions<D, double>(problem.motions, 0));
}

// Both sides of duality, recomputed from the solver's output: a point of the program and
// multipliers, whose values coincide.
template <int D>
struct Sides {
  double below, above;
  double unbalanced_reaction, unbalanced_forces;
};

template <int D>
Sides<D> both_sides(const UnconstrainedProblem& problem, const NodeSolver<D>& solver,
                    const Motions<double>& motions, const IndexSet& contact,
                    const IndexSet& separated) {
  const auto m = static_cast<int>(problem.friction.size());
  const Eigen::VectorXd& r = solver.reaction();
  const Eigen::VectorXd alpha = motions.combination.leftCols(motions.lifting) * solver.motion();
  const Eigen::VectorXd u = problem.compliance * r + problem.motions * alpha;
  const Eigen::VectorXd y = solver.multipliers().head(m);
  const Eigen::VectorXd beta = motions.combination * solver.multipliers().tail(motions.count());
  Eigen::VectorXd forces = Eigen::VectorXd::Zero(D * m);
  double below = 1e300, sum = 0, weights = 0, pushes = 0;
  for (int i = 0; i < m; ++i) {
    forces[D * i] = y[i];
    if (!contact.contains(i)) {
      below = std::min(below, u[D * i]);
      EXPECT_GE(y[i], 0);
      pushes += y[i];
    } else {
      EXPECT_NEAR(u[D * i], 0, 1e-9);
    }
    sum += r[D * i];
    if (separated.contains(i)) {
      EXPECT_EQ(r[D * i], 0);
      continue;
    }
    const double mu = problem.friction[static_cast<std::size_t>(i)];
    below = std::min(below, mu * r[D * i] - r.segment(D * i + 1, D - 1).norm());
    weights += 1 / mu;
  }
  const Eigen::VectorXd w = problem.compliance * forces + problem.motions * beta;
  double tau = -1e300;
  double scale = pushes;
  for (int i = 0; i < m; ++i) {
    if (separated.contains(i)) continue;
    const double mu = problem.friction[static_cast<std::size_t>(i)];
    tau = std::max(tau, w[D * i] + mu * w.segment(D * i + 1, D - 1).norm());
    scale -= w[D * i] / mu;
  }
  scale += tau * weights;
  return {below / sum, tau / scale, (problem.motions.transpose() * r).norm(),
          (problem.motions.transpose() * forces).norm() / (1 + y.norm())};
}

template <int D>
void expect_both_sides_to_meet(int m, int nodes) {
  std::mt19937_64 generator(static_cast<unsigned>(100 * D + m));
  int feasible = 0, infeasible = 0, met = 0;
  for (int trial = 0; trial < nodes; ++trial) {
    const auto problem = random_unconstrained<D>(m, generator);
    const auto [contact, separated] = random_masks(m, generator);
    auto solver = solver_of<D>(problem);
    const auto answer =
        solver.solve(contact, separated, {.when_infeasible = false, .when_feasible = false});
    ASSERT_LE(answer.lower, answer.upper);
    feasible += answer.sign == Sign::feasible ? 1 : 0;
    infeasible += answer.sign == Sign::infeasible ? 1 : 0;
    // Equilibrium can leave a candidate of U without a reaction: the node is then degenerate.
    if (answer.sign == Sign::unproved) {
      EXPECT_NEAR(answer.lower, 0, 1e-9) << trial;
      EXPECT_NEAR(answer.upper, 0, 1e-9) << trial;
    }
    if (!answer.has_point || !std::isfinite(answer.upper)) continue;
    const auto sides = both_sides<D>(
        problem, solver, ordered_motions<D, double>(problem.motions, 0), contact, separated);
    EXPECT_LT(sides.unbalanced_reaction, 1e-9);
    EXPECT_LT(sides.unbalanced_forces, 1e-6);
    EXPECT_NEAR(sides.below, answer.lower, 1e-5 * std::max(1.0, std::abs(answer.lower)));
    EXPECT_NEAR(sides.above, answer.upper, 1e-5 * std::max(1.0, std::abs(answer.upper)));
    met += answer.upper - answer.lower < 1e-4 * std::abs(answer.upper) ? 1 : 0;
  }
  EXPECT_GT(feasible, nodes / 20);
  EXPECT_GT(infeasible, 0);
  EXPECT_GT(met, nodes / 5) << feasible << " alive, " << infeasible << " dead";
}

TEST(UnconstrainedBody, SatisfiesStrongDualityInThePlane) {
  expect_both_sides_to_meet<2>(5, 100);
  expect_both_sides_to_meet<2>(9, 100);
  expect_both_sides_to_meet<2>(20, 40);
}

TEST(UnconstrainedBody, SatisfiesStrongDualityInSpace) {
  expect_both_sides_to_meet<3>(6, 60);
  expect_both_sides_to_meet<3>(12, 60);
  expect_both_sides_to_meet<3>(24, 20);
}

// The coefficients of a cut multiply both parts of u_n = F_n r + H alpha.
template <int D>
UnconstrainedProblem with_candidates_for(const UnconstrainedProblem& problem,
                                         const std::vector<Cut>& cuts) {
  UnconstrainedProblem larger = problem;
  for (const Cut& cut : cuts) {
    const Eigen::Index size = larger.compliance.rows();
    larger.compliance =
        testing::with_candidate_for<D>(cut, larger.compliance, problem.compliance.rows());
    larger.motions.conservativeResize(size + D, Eigen::NoChange);
    larger.motions.bottomRows(D).setZero();
    larger.motions.row(size) =
        -cut.displacement / cut.level * larger.motions.row(Eigen::Index{D} * cut.candidate);
    larger.friction.push_back(1);
  }
  return larger;
}

template <int D>
void expect_cuts_to_be_rows_of_further_candidates(int m, int nodes) {
  std::mt19937_64 generator(static_cast<unsigned>(10 * D + m));
  std::uniform_real_distribution<double> number(0.2, 1.5);
  int compared = 0, binding = 0;
  for (int trial = 0; trial < nodes; ++trial) {
    const auto problem = random_unconstrained<D>(m, generator);
    const auto [contact, separated] = random_masks(m, generator);
    std::vector<Cut> cuts;
    for (int i = 0; i < m; ++i) {
      if (contact.contains(i) || separated.contains(i)) continue;
      cuts.push_back({.candidate = i,
                      .share = 0.5 * number(generator),
                      .displacement = trial % 3 == 0 ? 0 : number(generator),
                      .reaction = number(generator),
                      .level = number(generator)});
    }
    if (cuts.empty()) continue;
    constexpr StopEarly to_the_end{.when_infeasible = false, .when_feasible = false};
    auto solver = solver_of<D>(problem);
    const auto without = solver.solve(contact, separated, to_the_end);
    solver.make_room(static_cast<int>(cuts.size()));
    const auto answer = solver.solve(contact, separated, to_the_end, {}, cuts);
    const auto larger = with_candidates_for<D>(problem, cuts);
    IndexSet all = separated;
    for (int i = m; i < static_cast<int>(larger.friction.size()); ++i) all.insert(i);
    auto judge = solver_of<D>(larger);
    const auto expected = judge.solve(contact, all, to_the_end);
    ASSERT_LE(answer.lower, answer.upper);
    // Both are brackets of the same number.
    EXPECT_LE(answer.lower, expected.upper + 1e-9) << trial;
    EXPECT_GE(answer.upper, expected.lower - 1e-9) << trial;
    const double size = std::max(1e-3, std::abs(answer.upper));
    if (!(answer.upper - answer.lower < 1e-4 * size)) continue;
    if (!(expected.upper - expected.lower < 1e-4 * size)) continue;
    ++compared;
    binding += answer.upper < without.lower - 1e-3 ? 1 : 0;
  }
  EXPECT_GT(compared, nodes / 3);
  EXPECT_GT(binding, nodes / 10);
}

TEST(UnconstrainedBody, HasCutsEquivalentToRowsOfFurtherCandidatesInThePlane) {
  expect_cuts_to_be_rows_of_further_candidates<2>(5, 60);
  expect_cuts_to_be_rows_of_further_candidates<2>(9, 40);
}

TEST(UnconstrainedBody, HasCutsEquivalentToRowsOfFurtherCandidatesInSpace) {
  expect_cuts_to_be_rows_of_further_candidates<3>(7, 40);
  expect_cuts_to_be_rows_of_further_candidates<3>(12, 20);
}

// Two candidates on the walls of a groove with half angle theta, at one height: their reactions are
// opposite, at theta from the normals.
TEST(UnconstrainedBody, WedgesInAGrooveFromTheTangentOfItsHalfAngle) {
  for (const double degrees : {5.0, 15.0, 30.0}) {
    const double theta = degrees * std::numbers::pi / 180;
    UnconstrainedProblem problem;
    problem.motions.resize(4, 3);
    for (int i = 0; i < 2; ++i) {
      const double side = i == 0 ? 1 : -1;  // the normal of the left wall points to the right
      const Eigen::Vector2d n(side * std::cos(theta), std::sin(theta));
      const Eigen::Vector2d t(n[1], -n[0]);
      const Eigen::Vector2d turn(-0.3, -side);  // about a point above the middle, at x = -side
      for (int row = 0; row < 2; ++row) {
        const Eigen::Vector2d& axis = row == 0 ? n : t;
        problem.motions.row(2 * i + row) << axis[0], axis[1], axis.dot(turn);
      }
    }
    problem.compliance.setIdentity(4, 4);
    for (const double share : {1 - 1e-6, 1 + 1e-6}) {
      problem.friction = {share * std::tan(theta), share * std::tan(theta)};
      auto solver = solver_of<2>(problem);
      const auto root = solver.solve({}, {});
      const auto leaf = solver.solve(IndexSet::below(2), {});
      EXPECT_EQ(root.sign, share < 1 ? Sign::infeasible : Sign::feasible)
          << degrees << " " << share;
      EXPECT_EQ(leaf.sign, share < 1 ? Sign::infeasible : Sign::feasible)
          << degrees << " " << share << " " << leaf.lower << " " << leaf.upper;
    }
  }
}

// A block between two parallel walls: the mode that slides along both is not an unknown.
template <int D>
NodeSolver<D, numbers::Precise> judge_of(const UnconstrainedProblem& problem) {
  std::vector<int> owners(problem.friction.size());
  for (std::size_t i = 0; i < owners.size(); ++i) owners[i] = static_cast<int>(i);
  const numbers::PreciseMatrix motions = problem.motions.cast<numbers::Precise>();
  return NodeSolver<D, numbers::Precise>(problem.compliance.cast<numbers::Precise>(),
                                         problem.friction, owners, {}, 0,
                                         ordered_motions<D, numbers::Precise>(motions, 0));
}

template <int D>
void expect_own_points_examined(int m, unsigned seed) {
  std::mt19937_64 generator(seed);
  const auto problem = random_unconstrained<D>(m, generator);
  auto one = solver_of<D>(problem);
  auto judge = judge_of<D>(problem);
  const auto all = IndexSet::below(m);
  for (std::uint64_t separated = 0; separated + 1 < std::uint64_t{1} << m; ++separated) {
    for (const bool leaf : {false, true}) {
      const IndexSet apart(separated);
      const IndexSet contact = leaf ? all - apart : IndexSet();
      const auto first = one.solve(contact, apart);
      const auto examined = one.examine_with(judge);
      auto other = solver_of<D>(problem);
      const auto again = other.solve(contact, apart);
      const auto alone = other.examine_with(judge);
      EXPECT_EQ(first.lower, again.lower);
      EXPECT_EQ(examined.lower, alone.lower);
      EXPECT_EQ(examined.upper, alone.upper);
      const auto truth = judge.solve(contact, apart);
      EXPECT_LE(examined.lower, truth.upper);
      EXPECT_LE(truth.lower, examined.upper);
    }
  }
}

// A node that ends before its first point, as by a singular factor, has none of the node before.
TEST(UnconstrainedBody, HasNoPointOfANodeThatEndedBefore) {
  std::mt19937_64 generator(7);
  const auto problem = random_unconstrained<2>(4, generator);
  const Eigen::Matrix<long double, -1, -1> compliance = problem.compliance.cast<long double>();
  const Eigen::Matrix<long double, -1, -1> motions = problem.motions.cast<long double>();
  NodeSolver<2, long double> solver(compliance, problem.friction, {0, 1, 2, 3}, {}, 0,
                                    ordered_motions<2, long double>(motions, 0));
  auto judge = judge_of<2>(problem);
  solver.solve({}, {});
  EXPECT_GT(solver.examine_with(judge).lower, -1e300);
  solver.end_when([] { return true; });
  EXPECT_THROW(solver.solve({}, IndexSet::single(0)), support::Stopped);
  EXPECT_LT(solver.examine_with(judge).lower, -1e300);
}

TEST(UnconstrainedBody, HasThePointsOfItsOwnNodesExamined) {
  for (unsigned seed = 1; seed <= 20; ++seed) {
    expect_own_points_examined<2>(2 + static_cast<int>(seed % 3), seed);
    expect_own_points_examined<3>(3 + static_cast<int>(seed % 2), seed);
  }
}

TEST(UnconstrainedBody, SlidesBetweenParallelWalls) {
  Eigen::MatrixXd motions(4, 3);
  motions << 1, 0, -0.5, 0, -1, 1, -1, 0, 0.5, 0, 1, 1;
  const auto ordered = ordered_motions<2, double>(motions, 0);
  EXPECT_EQ(ordered.lifting, 1);
  EXPECT_EQ(ordered.at_cones(0, 1), 0);
  EXPECT_EQ(ordered.at_cones(2, 2), 0);
  EXPECT_LT((motions * ordered.combination - ordered.at_cones).cwiseAbs().maxCoeff(), 1e-15);
}

}  // namespace
}  // namespace kusabi::conic
