// More candidates than bits in a word, with known answers.
#include <cstdint>
#include <set>
#include <vector>

#include <gtest/gtest.h>

#include "engine/search.hpp"
#include "engine/simulation.hpp"
#include "nodes/wedged/tree/sign_pattern_tree.hpp"
#include "random_problem.hpp"
#include "solvers/conic/node_solver.hpp"

namespace kusabi::wedged {
namespace {

using support::IndexSet;

constexpr int candidates = 72;
constexpr double two_blocks_mu = 4;

// A block of six, spread over both words of a set.
const std::vector<int> places{0, 1, 63, 64, 65, 71};

IndexSet block_of_six() {
  IndexSet block;
  for (const int place : places) block.insert(place);
  return block;
}

// A random block of six; all others are posts of two bars (examples/two-bars.toml), which can wedge
// if and only if the friction coefficient is at least two.
problems::WedgedProblem posts_around(const problems::WedgedProblem& six) {
  problems::WedgedProblem problem;
  problem.dimension = 2;
  problem.compliance.stiffness = Eigen::MatrixXd::Zero(2 * candidates, 2 * candidates);
  problem.compliance.matrix = problem.compliance.stiffness;
  const auto block = block_of_six();
  for (int i = 0; i < candidates; ++i) {
    problem.contact_names.push_back(fmt::format("c{}", i));
    if (i == 0) problem.blocks.push_back(block);
    if (block.contains(i)) continue;
    problem.blocks.push_back(IndexSet::single(i));
    problem.compliance.stiffness.block<2, 2>(2 * i, 2 * i) << 2, 1, 1, 2;
    problem.compliance.matrix.block<2, 2>(2 * i, 2 * i) << 2.0 / 3, -1.0 / 3, -1.0 / 3, 2.0 / 3;
  }
  for (int k = 0; k < 6; ++k) {
    for (int l = 0; l < 6; ++l) {
      const int row = 2 * places[static_cast<std::size_t>(k)];
      const int column = 2 * places[static_cast<std::size_t>(l)];
      problem.compliance.stiffness.block<2, 2>(row, column) =
          six.compliance.stiffness.block<2, 2>(2 * k, 2 * l);
      problem.compliance.matrix.block<2, 2>(row, column) =
          six.compliance.matrix.block<2, 2>(2 * k, 2 * l);
    }
  }
  return problem;
}

// Every third post has too little friction.
std::vector<double> frictions() {
  const auto block = block_of_six();
  std::vector<double> friction;
  for (int i = 0; i < candidates; ++i)
    friction.push_back(block.contains(i) || i % 3 != 0 ? two_blocks_mu : 1.5);
  return friction;
}

std::set<IndexSet> contact_sets(const engine::Outcome<SignPatternTree>& outcome) {
  std::set<IndexSet> sets;
  for (const auto& found : outcome.solutions) {
    if (found.solution.state == LeafState::feasible) sets.insert(found.solution.pattern.contact);
  }
  return sets;
}

// Of the six by all their leaves, one by one; of the posts by their closed form.
std::set<IndexSet> expected(const problems::WedgedProblem& six) {
  std::set<IndexSet> sets;
  conic::NodeSolver<2> solver(six.compliance.matrix / problems::mean_normal_compliance(six),
                              std::vector<double>(6, two_blocks_mu));
  for (unsigned contact = 1; contact < 64; ++contact) {
    const auto sign = solver.solve(contact, 63U & ~contact).sign;
    EXPECT_NE(sign, conic::Sign::unproved);
    if (sign != conic::Sign::feasible) continue;
    IndexSet set;
    for (const int k : IndexSet(contact)) set.insert(places[static_cast<std::size_t>(k)]);
    sets.insert(set);
  }
  const auto friction = frictions();
  for (int i = 0; i < candidates; ++i) {
    if (!block_of_six().contains(i) && friction[static_cast<std::size_t>(i)] > 2)
      sets.insert(IndexSet::single(i));
  }
  return sets;
}

TEST(ManyCandidates, HaveThePatternsOfTheirBlocks) {
  std::size_t of_six = 0;
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    const auto six = random_problem(2, 6, seed);
    const auto known = expected(six);
    SignPatternTree tree(posts_around(six), frictions());
    EXPECT_EQ(contact_sets(engine::search(tree)), known) << seed;
    of_six += known.size() - 44;  // posts with enough friction
  }
  EXPECT_GT(of_six, 6U);
}

// Nodes and leaves are transferred with sets of two words.
TEST(ManyCandidates, HaveTheSamePatternsOnAnyNumberOfRanks) {
  const auto problem = posts_around(random_problem(2, 6, 1));
  SignPatternTree alone(problem, frictions());
  const auto expected = engine::search(alone);
  for (const int ranks : {2, 5}) {
    const auto many = engine::simulate(SignPatternTree(problem, frictions()), ranks, 7,
                                       {.latency = 2e-6, .node = 20e-6});
    EXPECT_EQ(many.outcome.fingerprint(), expected.fingerprint()) << ranks;
  }
}

}  // namespace
}  // namespace kusabi::wedged
