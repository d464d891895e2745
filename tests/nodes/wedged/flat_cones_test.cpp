// Degenerate leaves: the list of maximal cones, solid or flat, compared with the extremal rays in
// the plane and with all leaves one by one in space.
#include <algorithm>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "dense.hpp"
#include "engine/search.hpp"
#include "engine/transport/single_process.hpp"
#include "nodes/wedged/pattern_search.hpp"
#include "nodes/wedged/tree/maximal_cones.hpp"
#include "nodes/wedged/tree/sign_pattern_tree.hpp"
#include "problems/families/space_truss.hpp"
#include "problems/files/problem_text.hpp"
#include "problems/files/structure_file.hpp"
#include "problems/wedged/precise_compliance.hpp"
#include "problems/wedged/problem_block.hpp"
#include "random_structure.hpp"
#include "solvers/rays/double_description.hpp"
#include "solvers/rays/maximal_cones.hpp"
#include "support/input_error.hpp"

namespace kusabi::wedged {
namespace {

/// (S, G): candidates with reactions and with gaps in a cone.
using Cones = std::set<std::pair<support::IndexSet, support::IndexSet>>;

std::vector<Configuration> leaves_of(const problems::WedgedProblem& problem, double mu) {
  SignPatternTree tree(problem, std::vector<double>(problem.contact_names.size(), mu));
  std::vector<Configuration> leaves;
  for (auto& found : engine::search(tree).solutions) leaves.push_back(std::move(found.solution));
  return maximal_cones(std::move(leaves));
}

// Every cone of one block with every cone of the others; nothing if a leaf is undecided.
std::optional<Cones> whole_cones(const problems::WedgedProblem& problem, double mu) {
  std::vector<Cones> of_blocks(problems::blocks_of(problem).size());
  for (const auto& leaf : leaves_of(problem, mu)) {
    if (leaf.state != LeafState::feasible && leaf.state != LeafState::flat) return std::nullopt;
    of_blocks[leaf.block].emplace(leaf.pattern.contact, leaf.pattern.separated);
  }
  Cones product{{0, 0}};
  for (const Cones& own : of_blocks) {
    if (own.empty()) continue;
    Cones longer;
    for (const auto& [contact, separated] : product)
      for (const auto& [more_contact, more_separated] : own)
        longer.emplace(contact | more_contact, separated | more_separated);
    product = std::move(longer);
  }
  product.erase({0, 0});
  return product;
}

std::optional<problems::WedgedProblem> problem_of(const problems::Structure& structure) {
  try {
    return problems::wedged_problem(checked(structure));
  } catch (const support::InputError&) {  // a mechanism, which is no fault of ours
    return std::nullopt;
  }
}

// The two candidates are decoupled, but the problem does not have the blocks. The first can stick
// by itself, with r_t = 2 r_n; the second is then inactive.
// The margin is 1.24e-13, by the oracle of bench/hostile.
TEST(FlatCones, ExcludeConesWithAMarginBelowTheTolerance) {
  const std::string path =
      KUSABI_SOURCE_DIR "/tests/nodes/wedged/cases/margin_below_tolerance.toml";
  const auto problem =
      problems::wedged_problem(problems::read_structure(problems::problem_text(path), path));
  const std::vector<double> friction(4, 1.8548356032431665);
  engine::SingleProcess alone;
  engine::Analysis analysis(alone);
  const auto findings = find_patterns(analysis, problem, friction);
  ASSERT_EQ(findings.leaves.size(), 1U);
  EXPECT_EQ(findings.leaves.front().state, LeafState::feasible);
  EXPECT_NEAR(findings.leaves.front().lower, 1.24e-13, 0.01e-13);
}

TEST(FlatCones, AreFoundOnceWithTheirInactiveCandidates) {
  problems::WedgedProblem problem;
  problem.dimension = 2;
  problem.contact_names = {"sticks", "rests"};
  problem.compliance.matrix = Eigen::MatrixXd::Identity(4, 4);
  problem.compliance.matrix(0, 1) = problem.compliance.matrix(1, 0) = -0.5;
  problem.compliance.stiffness = dense::inverse(problem.compliance.matrix);
  SignPatternTree tree(problem, std::vector<double>{3.0, 3.0});
  const auto outcome = engine::search(tree);
  ASSERT_EQ(outcome.solutions.size(), 1U);
  const auto& cone = outcome.solutions[0].solution;
  EXPECT_EQ(cone.state, LeafState::flat);
  EXPECT_EQ(cone.pattern, (SignPattern{.contact = 0b01, .separated = 0, .inactive = 0b10}));
  EXPECT_EQ(tree.tally().found, 0U);
  EXPECT_EQ(tree.tally().flat, 1U);
}

// A candidate that sticks displaces a body that can move between two opposite candidates: their
// gaps add up to 2 e r_n, below the rounding of the terms of u_n, 1e-12 of 0.9 r_n + 0.45 |r_t|. As
// long as one of both is not decided, equilibrium leaves it no reaction, and t* = 0, although there
// is a configuration in which both have a gap of e r_n.
TEST(FlatCones, HaveNoInactiveCandidateThatHasASmallGap) {
  constexpr double e = 2e-12;
  problems::WedgedProblem problem;
  problem.dimension = 2;
  problem.contact_names = {"sticks", "below", "above"};
  auto& compliance = problem.compliance.matrix;
  compliance = Eigen::MatrixXd::Identity(6, 6);
  compliance(0, 1) = compliance(1, 0) = -0.5;
  compliance(2, 0) = compliance(0, 2) = 0.9;
  compliance(2, 1) = compliance(1, 2) = -0.45 + e;
  compliance(2, 2) = 2;
  problem.compliance.stiffness = dense::inverse(compliance);
  problem.modes.matrix = Eigen::MatrixXd::Zero(6, 1);
  problem.modes.matrix(2, 0) = 1;
  problem.modes.matrix(4, 0) = -1;
  SignPatternTree tree(problem, std::vector<double>{3.0, 3.0, 3.0});
  const auto outcome = engine::search(tree);
  ASSERT_EQ(outcome.solutions.size(), 1U);
  const auto& leaf = outcome.solutions[0].solution;
  EXPECT_EQ(leaf.state, LeafState::feasible);
  EXPECT_EQ(leaf.pattern, (SignPattern{.contact = 0b001, .separated = 0b110, .inactive = 0}));
  EXPECT_NEAR(leaf.lower, e / problems::margin_unit(problem), 1e-3 * e);
  EXPECT_EQ(tree.tally().flat, 0U);
}

// With k inactive candidates 2^k leaves have the same cone.
TEST(FlatCones, OpenAtMostTwoNodesPerCandidate) {
  constexpr int candidates = 24;
  problems::WedgedProblem problem;
  problem.dimension = 2;
  problem.contact_names.resize(candidates);
  problem.compliance.matrix = Eigen::MatrixXd::Identity(2 * candidates, 2 * candidates);
  problem.compliance.matrix(0, 1) = problem.compliance.matrix(1, 0) = -0.5;
  problem.compliance.stiffness = dense::inverse(problem.compliance.matrix);
  SignPatternTree tree(problem, std::vector<double>(candidates, 3.0));
  const auto outcome = engine::search(tree);
  ASSERT_EQ(outcome.solutions.size(), 1U);
  EXPECT_EQ(outcome.solutions[0].solution.pattern.contact, 1U);
  EXPECT_LE(outcome.opened(), 2U * candidates + 1);
}

// Candidate 1 alone sticks with r_t = 2 r_n, and its influence on candidate 2 is proportional to
// its own u_n = 0: candidate 2 does not move. Both in contact have reactions.
TEST(FlatCones, FacesOfOtherConesAreOmitted) {
  problems::WedgedProblem problem;
  problem.dimension = 2;
  problem.contact_names = {"first", "second"};
  problem.compliance.matrix = Eigen::MatrixXd{{1.0, -0.5, 0.3, 0.0},  //
                                              {-0.5, 1.0, -0.15, 0.0},
                                              {0.3, -0.15, 1.0, -0.5},
                                              {0.0, 0.0, -0.5, 1.0}};
  problem.compliance.stiffness = dense::inverse(problem.compliance.matrix);
  SignPatternTree tree(problem, std::vector<double>{3.0, 3.0});
  EXPECT_EQ(engine::search(tree).solutions.size(), 3U);
  EXPECT_EQ(tree.tally().flat, 1U);
  EXPECT_EQ(whole_cones(problem, 3.0), (Cones{{0b10, 0b01}, {0b11, 0}}));
}

// W (11) compared with W (16): rays are found without sign patterns and blocks.
TEST(FlatCones, InThePlaneAreTheMaximalCliquesOfTheRays) {
  std::size_t cones = 0;
  std::size_t flat = 0;
  for (std::uint64_t seed = 1; seed <= 150; ++seed) {
    const auto structure = random_structure(2, seed);
    const auto problem = problem_of(structure);
    if (!problem) continue;
    for (const double mu : {0.7, 1.3, 3.1}) {
      const std::vector<double> friction(problem->contact_names.size(), mu);
      const rays::ReactionCone cone(problems::precise_compliance(*problem), friction);
      const auto found = rays::complementary_rays(cone);
      ASSERT_TRUE(found.health.sound()) << seed;
      Cones expected;
      for (const auto& each : rays::maximal_cones(found.rays, cone.all()))
        expected.emplace(each.reaction, each.separated);
      EXPECT_EQ(whole_cones(*problem, mu), expected) << seed << ' ' << mu;
      cones += expected.size();
      for (const auto& [contact, separated] : expected)
        flat += (contact | separated) != cone.all() ? 1 : 0;
    }
  }
  EXPECT_GT(cones, 200U);
  EXPECT_GT(flat, 100U);
}

// All 3^m states of candidates with a reaction, with a gap or inactive: the relative interior of
// each cone D(Y), leaf by leaf, and of these the maximal ones.
TEST(FlatCones, InSpaceAgreeWithAnEnumerationOfAllLeaves) {
  std::size_t cones = 0;
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    const auto problem = problem_of(random_structure(3, seed));
    if (!problem || problem->contact_names.size() > 6) continue;
    const double mu = 1.3;
    const std::vector<double> friction(problem->contact_names.size(), mu);
    auto one = *problem;
    one.blocks.clear();
    const auto all = problems::all_candidates(one);
    const auto leaves = std::uint64_t{1} << static_cast<unsigned>(all.size());
    ContactSolver solver(one, friction, {});
    std::vector<SignPattern> found;
    for (std::uint64_t ones = 1; ones < leaves; ++ones) {
      const support::IndexSet contact = ones;
      const auto separated = all - contact;
      const auto answer = solver.solve(contact, separated, {.when_feasible = false});
      if (answer.sign == conic::Sign::infeasible) continue;
      SignPattern pattern{.contact = contact, .separated = separated, .inactive = {}};
      if (answer.sign == conic::Sign::unproved) {
        const auto inside = solver.relative_interior(contact, separated);
        ASSERT_TRUE(inside) << seed;
        pattern = {.contact = inside->loaded, .separated = inside->moved, .inactive = {}};
      }
      found.push_back(pattern);
    }
    Cones expected;
    for (const auto& pattern : found) {
      const bool face = std::any_of(found.begin(), found.end(), [&](const auto& other) {
        return within(pattern, other) && !within(other, pattern);
      });
      if (!face) expected.emplace(pattern.contact, pattern.separated);
    }
    EXPECT_EQ(whole_cones(*problem, mu), expected) << seed;
    EXPECT_EQ(whole_cones(one, mu), expected) << seed;
    cones += expected.size();
  }
  EXPECT_GT(cones, 20U);
}

// On a truss of one bay each candidate is a block: as a single tree it has hundreds of degenerate
// nodes.
TEST(FlatCones, OfAOneBayTrussAreTheProductOfItsBlocks) {
  const auto problem = problems::wedged_problem(checked(problems::space_truss({5, 2, 1})));
  ASSERT_GT(problem.blocks.size(), 1U);
  auto one = problem;
  one.blocks.clear();
  for (const double mu : {0.65, 1.0}) EXPECT_EQ(whole_cones(one, mu), whole_cones(problem, mu));
}

TEST(MaximalCones, OfIndependentBlocksMultiply) {
  EXPECT_EQ(combinations(std::vector<std::uint64_t>{}), 0U);
  EXPECT_EQ(combinations(std::vector<std::uint64_t>{0, 0}), 0U);
  EXPECT_EQ(combinations(std::vector<std::uint64_t>{11, 0}), 11U);
  EXPECT_EQ(combinations(std::vector<std::uint64_t>{3, 1, 4}), 12U);
}

}  // namespace
}  // namespace kusabi::wedged
