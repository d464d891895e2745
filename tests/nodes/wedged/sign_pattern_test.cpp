// Tree of sign patterns compared with published counts, with all leaves one by one, and with the
// definition of a wedged configuration.
#include <algorithm>
#include <bit>
#include <cmath>
#include <fstream>
#include <iterator>
#include <map>
#include <numbers>
#include <random>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <Eigen/LU>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "engine/simulation.hpp"
#include "faces.hpp"
#include "nodes/wedged/tree/sign_pattern_tree.hpp"
#include "problems/files/structure_file.hpp"
#include "random_problem.hpp"

namespace kusabi::wedged {
namespace {

using ContactSet = std::vector<int>;

std::string content(const std::string& name) {
  std::ifstream file(std::string(KUSABI_SOURCE_DIR) + "/" + name);
  EXPECT_TRUE(file) << name;
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

problems::WedgedProblem named_example(const std::string& name) {
  return problems::wedged_problem(problems::read_structure(content("examples/" + name), name));
}

nlohmann::json named_reference(const std::string& name) {
  return nlohmann::json::parse(content("tests/reference/" + name));
}

SignPatternTree tree_of(const problems::WedgedProblem& problem, double mu) {
  return {problem, std::vector<double>(problem.contact_names.size(), mu)};
}

ContactSet positions(const support::IndexSet& set) {
  return {set.begin(), set.end()};
}

std::set<ContactSet> feasible_sets(const engine::Outcome<SignPatternTree>& outcome) {
  std::set<ContactSet> sets;
  for (const auto& found : outcome.solutions) {
    if (found.solution.state == LeafState::feasible)
      sets.insert(positions(found.solution.pattern.contact));
  }
  return sets;
}

class SpaceTruss : public ::testing::TestWithParam<const char*> {};

TEST_P(SpaceTruss, HasThePatternsOfTheReference) {
  const auto known = named_reference("space-truss.json");
  auto tree = tree_of(named_example("space-truss.toml"), std::stod(GetParam()));
  const auto outcome = engine::search(tree);
  EXPECT_EQ(feasible_sets(outcome), known["patterns"][GetParam()].get<std::set<ContactSet>>());
  EXPECT_EQ(tree.tally().found, known["counts"][GetParam()].get<std::uint64_t>());
  EXPECT_EQ(tree.tally().marginal, 0U);
  EXPECT_EQ(tree.tally().undecided, 0U);
}

// The tree prunes and branches; this test decides each of the 2^10 leaves by itself.
TEST_P(SpaceTruss, HasThePatternsOfAnEnumerationOfAllLeaves) {
  const auto problem = named_example("space-truss.toml");
  const double mu = std::stod(GetParam());
  auto tree = tree_of(problem, mu);
  double unit = 0;
  for (int i = 0; i < 10; ++i) unit += problem.compliance.matrix(3 * i, 3 * i) / 10;
  const std::vector<double> friction(10, mu);
  conic::NodeSolver<3> solver(problem.compliance.matrix / unit, friction);
  std::set<ContactSet> feasible;
  for (std::uint64_t contact = 0; contact < 1024; ++contact) {
    const auto answer = solver.solve(contact, 1023 & ~contact);
    EXPECT_NE(answer.sign, conic::Sign::unproved);
    if (answer.sign == conic::Sign::feasible) feasible.insert(positions(contact));
  }
  EXPECT_EQ(feasible_sets(engine::search(tree)), feasible);
}

INSTANTIATE_TEST_SUITE_P(AllFrictions, SpaceTruss,
                         ::testing::Values("0.55", "0.6", "0.65", "0.7", "1.0"));

// Proposition 2.1 (iii): a configuration for one coefficient is one for every larger one.
TEST(SignPatternTree, KeepsItsPatternsWhenFrictionGrows) {
  const auto problem = named_example("space-truss.toml");
  std::set<ContactSet> smaller;
  for (const double mu : {0.5, 0.63, 0.66, 0.8, 0.95, 1.5, 3.0}) {
    auto tree = tree_of(problem, mu);
    const auto larger = feasible_sets(engine::search(tree));
    EXPECT_TRUE(std::includes(larger.begin(), larger.end(), smaller.begin(), smaller.end())) << mu;
    smaller = larger;
  }
}

// The evidence is checked against (6), in the units of the file, without the cone solver.
TEST(SignPatternTree, EveryConfigurationSolvesTheWedgedProblem) {
  const auto problem = named_example("space-truss.toml");
  const double mu = 1.0;
  auto tree = tree_of(problem, mu);
  const auto outcome = engine::search(tree);
  ASSERT_EQ(outcome.solutions.size(), 251U);
  for (const auto& [path, found] : outcome.solutions) {
    const Eigen::Map<const Eigen::VectorXd> r(found.reaction.data(), 30);
    const Eigen::Map<const Eigen::VectorXd> u(found.displacement.data(), 30);
    const double size = u.lpNorm<Eigen::Infinity>();
    EXPECT_LE((problem.compliance.stiffness * u - r).lpNorm<Eigen::Infinity>(), 1e-9);
    double sum = 0;
    for (int i = 0; i < 10; ++i) {
      const bool contact = found.pattern.contact.contains(i);
      const double normal_reaction = r(3 * i);
      sum += normal_reaction;
      if (contact) {
        EXPECT_LE(std::abs(u(3 * i)), 1e-10 * size);
        EXPECT_GT(normal_reaction, 0);
        EXPECT_LT(r.segment(3 * i + 1, 2).norm(), mu * normal_reaction);
      } else {
        EXPECT_GT(u(3 * i), 0);
        EXPECT_EQ(r.segment(3 * i, 3).norm(), 0);
      }
    }
    EXPECT_NEAR(sum, 1, 1e-12);
    EXPECT_LE(found.lower, found.upper);
    EXPECT_LE(found.upper - found.lower, 1e-7);
  }
}

// Both branching rules find the same; one of them takes a third fewer nodes here.
TEST(SignPatternTree, FindsTheSamePatternsWithFewerNodesByTheRelativeRule) {
  const auto problem = named_example("space-truss.toml");
  for (const double mu : {0.5, 0.65, 0.8}) {
    const std::vector<double> friction(10, mu);
    SignPatternTree relative(problem, friction,
                             {.tolerances = {}, .branching = Branching::relative});
    SignPatternTree product(problem, friction, {.tolerances = {}, .branching = Branching::product});
    const auto few = engine::search(relative);
    const auto many = engine::search(product);
    EXPECT_EQ(feasible_sets(few), feasible_sets(many));
    EXPECT_LT(3 * few.opened(), 2 * many.opened() + 100) << mu;
  }
}

// Infeasible and feasible coefficients: on this face fewer nodes, a third where all are infeasible.
TEST(SignPatternTree, DeepestRuleOpensFewerNodesOnAFace) {
  const auto problem = cantilever_face(32);
  for (const double mu : {5.0, 6.0, 8.0}) {
    const std::vector<double> friction(problem.contact_names.size(), mu);
    SignPatternTree deepest(problem, friction, {.tolerances = {}, .branching = Branching::deepest});
    SignPatternTree relative(problem, friction,
                             {.tolerances = {}, .branching = Branching::relative});
    const auto few = engine::search(deepest);
    const auto many = engine::search(relative);
    EXPECT_EQ(feasible_sets(few), feasible_sets(many));
    EXPECT_LT(few.opened(), many.opened() / (mu == 5.0 ? 3 : 1)) << mu;
  }
}

// In space, where they do not have fewer.
TEST(SignPatternTree, FindsTheSamePatternsInSpaceByAllRules) {
  const auto problem = named_example("space-truss.toml");
  for (const double mu : {0.5, 0.65, 0.8, 1.0}) {
    const std::vector<double> friction(10, mu);
    SignPatternTree relative(problem, friction,
                             {.tolerances = {}, .branching = Branching::relative});
    const auto expected = feasible_sets(engine::search(relative));
    for (const Branching rule : {Branching::deepest, Branching::weighed}) {
      SignPatternTree tree(problem, friction, {.tolerances = {}, .branching = rule});
      EXPECT_EQ(feasible_sets(engine::search(tree)), expected);
    }
  }
}

// Compared with all leaves one by one, with different friction at every candidate.
TEST(SignPatternTree, UsesTheFrictionOfEachCandidate) {
  const auto problem = named_example("space-truss.toml");
  double unit = 0;
  for (int i = 0; i < 10; ++i) unit += problem.compliance.matrix(3 * i, 3 * i) / 10;
  for (unsigned seed = 1; seed <= 3; ++seed) {
    std::mt19937 random(seed);
    std::vector<double> friction(10);
    for (double& mu : friction) mu = std::uniform_real_distribution(0.4, 1.1)(random);
    SignPatternTree tree(problem, friction);
    const auto found = feasible_sets(engine::search(tree));
    EXPECT_GT(found.size(), 0U);
    conic::NodeSolver<3> solver(problem.compliance.matrix / unit, friction);
    std::set<ContactSet> feasible;
    for (std::uint64_t contact = 0; contact < 1024; ++contact) {
      const auto answer = solver.solve(contact, 1023 & ~contact);
      if (answer.sign == conic::Sign::feasible) feasible.insert(positions(contact));
    }
    EXPECT_EQ(found, feasible) << "seed " << seed;
  }
}

TEST(SignPatternTree, DoesNotDependOnTheUnits) {
  // Scaling the stiffness by a hundred thousand does not change the patterns.
  const auto problem = named_example("space-truss.toml");
  auto tree = tree_of(problem, 0.65);
  const auto expected = feasible_sets(engine::search(tree));
  for (const double factor : {1e-5, 1e5}) {
    auto scaled = problem;
    scaled.compliance.stiffness *= factor;
    scaled.compliance.matrix /= factor;
    auto other = tree_of(scaled, 0.65);
    EXPECT_EQ(feasible_sets(engine::search(other)), expected);
  }
}

// Coefficients far beyond physical ones, for which higher precision levels are required.
TEST(SignPatternTree, IsDecidedAtAnyFriction) {
  for (const double mu : {1e-6, 1e-3, 1e3, 1e6}) {
    auto tree = tree_of(named_example("space-truss.toml"), mu);
    const auto outcome = engine::search(tree);
    EXPECT_EQ(tree.tally().undecided + tree.tally().marginal + tree.tally().branched_undecided, 0U)
        << mu;
    EXPECT_EQ(tree.tally().found == 0, mu < 0.47) << mu;
  }
}

class PlaneTruss : public ::testing::TestWithParam<const char*> {};

TEST_P(PlaneTruss, HasAsManyPatternsAsTheReference) {
  const auto known = named_reference("plane-truss.json")["table"]["5"][GetParam()];
  auto tree = tree_of(named_example("plane-truss.toml"), std::stod(GetParam()));
  const auto outcome = engine::search(tree);
  EXPECT_EQ(feasible_sets(outcome).size(), known["patterns"].get<std::size_t>());
}

INSTANTIATE_TEST_SUITE_P(AllFrictions, PlaneTruss,
                         ::testing::Values("0.62", "0.65", "0.7", "0.8", "1.0"));

// Algorithm 5.8 compared with Algorithm 5.1: the same patterns from different numbers of
// candidates, which do not grow with the number of facets if each polygon contains the next.
TEST(PolyhedralFriction, HasThePatternsOfConesAndFewerCandidatesWithMoreFacets) {
  const auto problem = named_example("space-truss.toml");
  for (const double mu : {0.6, 0.65, 1.0}) {
    auto cones = tree_of(problem, mu);
    const auto patterns = feasible_sets(engine::search(cones));
    std::uint64_t fewer = std::uint64_t{1} << 10U;
    for (const int facets : {4, 8, 16, 32}) {
      SignPatternTree tree(problem, std::vector<double>(10, mu),
                           {.tolerances = {}, .facets = facets});
      EXPECT_EQ(feasible_sets(engine::search(tree)), patterns) << facets;
      const auto tally = tree.tally();
      EXPECT_GE(tally.polyhedral_leaves, patterns.size());
      EXPECT_LE(tally.polyhedral_leaves, fewer);
      EXPECT_EQ(tally.marginal + tally.undecided, 0U);
      fewer = tally.polyhedral_leaves;
    }
  }
}

// Step 1 and step 2 of Algorithm 5.8, each on all 2^10 leaves one by one.
TEST(PolyhedralFriction, ListsTheCandidatesWithTheirTestResults) {
  const auto problem = named_example("space-truss.toml");
  const std::vector<double> friction(10, 0.65);
  const int facets = 4;
  SignPatternTree tree(problem, friction, {.tolerances = {}, .facets = facets});
  const auto feasible = feasible_sets(engine::search(tree));
  std::map<support::IndexSet, bool> discarded;
  for (const auto& candidate : tree.tally().tested) {
    EXPECT_FALSE(candidate.pattern.contact.meets(candidate.pattern.separated));
    EXPECT_EQ(candidate.pattern.contact | candidate.pattern.separated, 1023U);
    EXPECT_TRUE(discarded.emplace(candidate.pattern.contact, candidate.discarded()).second);
    EXPECT_GT(candidate.polyhedral, 0);
  }
  const Eigen::MatrixXd scaled =
      problem.compliance.matrix / problems::mean_normal_compliance(problem);
  FacetBound polyhedral(scaled, friction, facets, {});
  conic::NodeSolver<3> cones(scaled, friction);
  std::map<support::IndexSet, bool> expected;
  for (std::uint64_t contact = 1; contact < 1024; ++contact) {
    if (polyhedral.solve(contact, 1023 & ~contact, {}).sign == conic::Sign::infeasible) continue;
    expected[contact] = cones.solve(contact, 1023 & ~contact).sign == conic::Sign::infeasible;
  }
  EXPECT_EQ(discarded, expected);
  EXPECT_GT(discarded.size(), feasible.size()) << "some are discarded";
}

// The tree, and the depth of each opened node.
struct Watched {
  using Node = SignPatternTree::Node;
  using Solution = SignPatternTree::Solution;

  SignPatternTree tree;
  std::vector<double> depths{};

  Node root() const { return tree.root(); }
  double objective(const Solution& leaf) const { return tree.objective(leaf); }
  double bound(const Node& node) const { return tree.bound(node); }
  void expand(Node&& node, engine::Expansion<Watched>& out) {
    depths.push_back(tree.bound(node));
    auto decision = tree.decide(node);
    if (decision.leaf) out.solution(std::move(*decision.leaf));
    for (const Node& child : decision.children) out.branch(child);
  }
};

// Remark 5.2: the order is arbitrary.
TEST(SignPatternTree, OpensTheSameNodesInBreadthFirstOrder) {
  const auto problem = named_example("space-truss.toml");
  const auto depths = [&](engine::Order order) {
    Watched watched{tree_of(problem, 0.65)};
    engine::Options options;
    options.order = order;
    const auto outcome = engine::search(watched, options);
    EXPECT_EQ(outcome.solutions.size(), named_reference("space-truss.json")["counts"]["0.65"]);
    return std::pair(watched.depths, outcome.fingerprint());
  };
  auto [deep, of_deep] = depths(engine::Order::depth_first);
  const auto [broad, of_broad] = depths(engine::Order::best_first);
  EXPECT_TRUE(std::ranges::is_sorted(broad));
  EXPECT_FALSE(std::ranges::is_sorted(deep));
  std::ranges::sort(deep);
  EXPECT_EQ(deep, broad);
  EXPECT_EQ(of_deep, of_broad);
}

// Pruning and branching compared with all leaves one by one, in the plane and in space.
TEST(SignPatternTree, HasThePatternsOfAnEnumerationOfAllLeaves) {
  std::size_t patterns = 0;
  for (std::uint64_t seed = 1; seed <= 48; ++seed) {
    const int m = 1 + static_cast<int>(seed % 8);
    const bool plane = seed % 2 == 0;
    const auto problem = random_problem(plane ? 2 : 3, m, seed);
    const std::vector<double> friction(static_cast<std::size_t>(m),
                                       0.8 + static_cast<double>(seed % 4));
    std::set<ContactSet> feasible;
    const auto decide_all = [&](auto solver) {
      const std::uint64_t all = (std::uint64_t{1} << static_cast<unsigned>(m)) - 1;
      for (std::uint64_t contact = 0; contact <= all; ++contact) {
        const auto answer = solver.solve(contact, all & ~contact);
        ASSERT_NE(answer.sign, conic::Sign::unproved);
        if (answer.sign == conic::Sign::feasible) feasible.insert(positions(contact));
      }
    };
    if (plane)
      decide_all(conic::NodeSolver<2>(problem.compliance.matrix, friction));
    else
      decide_all(conic::NodeSolver<3>(problem.compliance.matrix, friction));
    patterns += feasible.size();
    SignPatternTree cones(problem, friction);
    EXPECT_EQ(feasible_sets(engine::search(cones)), feasible) << seed;
    if (plane) continue;
    SignPatternTree polyhedral(problem, friction, {.tolerances = {}, .facets = 8});
    EXPECT_EQ(feasible_sets(engine::search(polyhedral)), feasible) << seed;
  }
  EXPECT_GT(patterns, 100U);
}

// One candidate in contact: the displacement of the tangents requires r_t along a direction between
// two edges, where the polygon has the width mu, or along an edge, where it is mu / cos(pi / F).
TEST(PolyhedralFriction, TouchesTheFrictionConeInTheMiddleOfEachFacet) {
  const double mu = 0.5;
  const int facets = 8;
  const double edge = mu / std::cos(std::numbers::pi / facets);
  for (const bool along_an_edge : {true, false}) {
    const double angle = along_an_edge ? std::numbers::pi / facets : 0;
    for (const double factor : {0.999, 1.001}) {
      // u_n = r_n - c (cos, sin) r_t vanishes if |r_t| = r_n / c in that direction.
      const double c = factor / (along_an_edge ? edge : mu);
      Eigen::MatrixXd compliance = 10 * Eigen::MatrixXd::Identity(3, 3);
      compliance(0, 0) = 1;
      compliance(0, 1) = compliance(1, 0) = -c * std::cos(angle);
      compliance(0, 2) = compliance(2, 0) = -c * std::sin(angle);
      FacetBound bound(compliance, std::vector<double>{mu}, facets, {});
      const auto answer = bound.solve(1, 0, {});
      EXPECT_EQ(answer.sign, factor < 1 ? conic::Sign::infeasible : conic::Sign::feasible)
          << along_an_edge << ' ' << factor;
      EXPECT_NEAR(bound.normal_reaction(0), 1, 1e-9);
    }
  }
}

TEST(SignPatternTree, OpensTheSameNodesOnAnyNumberOfSimulatedRanks) {
  const auto problem = named_example("space-truss.toml");
  auto tree = tree_of(problem, 1.0);
  const auto alone = engine::search(tree);
  for (const int ranks : {2, 3, 8, 40}) {
    const engine::MachineModel machine{.latency = 2e-6, .node = 20e-6};
    const auto many = engine::simulate(tree_of(problem, 1.0), ranks, 7, machine);
    EXPECT_EQ(many.outcome.fingerprint(), alone.fingerprint()) << ranks;
    ASSERT_EQ(many.outcome.solutions.size(), alone.solutions.size());
    for (std::size_t i = 0; i < alone.solutions.size(); ++i) {
      EXPECT_EQ(many.outcome.solutions[i].solution.lower, alone.solutions[i].solution.lower);
      EXPECT_EQ(many.outcome.solutions[i].solution.reaction, alone.solutions[i].solution.reaction);
    }
  }
}

}  // namespace
}  // namespace kusabi::wedged
