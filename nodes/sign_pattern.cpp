// How a node of the sign-pattern tree is decided and split.
#include "nodes/sign_pattern.hpp"

#include <bit>
#include <cstddef>

namespace kusabi::nodes {
namespace {

std::uint64_t bit(int candidate) {
  return std::uint64_t{1} << static_cast<unsigned>(candidate);
}

std::uint64_t first_bits(std::size_t count) {
  return count >= 64 ? ~std::uint64_t{0} : (std::uint64_t{1} << count) - 1;
}

// 1 / c of Branching::relative. (The unit of F, alike for all, makes no difference.)
std::vector<double> branching_weights(const problems::WedgedProblem& problem,
                                      std::span<const double> friction, Branching branching) {
  std::vector<double> weights(friction.size(), 1);
  if (branching == Branching::product) return weights;
  const Eigen::Index d = problem.dimension;
  for (std::size_t i = 0; i < friction.size(); ++i) {
    const Eigen::Index normal = d * static_cast<Eigen::Index>(i);
    const auto own = problem.compliance.row(normal).segment(normal, d);
    weights[i] = 1 / (own[0] + friction[i] * own.tail(d - 1).norm());
  }
  return weights;
}

}  // namespace

SignPatternTally& SignPatternTally::operator+=(const SignPatternTally& other) {
  branched += other.branched;
  dead += other.dead;
  found += other.found;
  marginal += other.marginal;
  undecided += other.undecided;
  doubtful += other.doubtful;
  iterations += other.iterations;
  return *this;
}

SignPatternTree::SignPatternTree(const problems::WedgedProblem& problem,
                                 std::span<const double> friction, conic::Tolerances tolerances,
                                 Branching branching)
    : dimension_(problem.dimension),
      candidates_(first_bits(problem.contact_names.size())),
      unit_(problems::mean_normal_compliance(problem)),
      tolerances_(tolerances),
      weight_(branching_weights(problem, friction, branching)),
      solver_([&]() -> Solver {
        const Eigen::MatrixXd scaled = problem.compliance / unit_;
        if (problem.dimension == 2) return conic::NodeSolver<2>(scaled, friction, tolerances);
        return conic::NodeSolver<3>(scaled, friction, tolerances);
      }()) {}

void SignPatternTree::expand(Node&& node, engine::Expansion<SignPatternTree>& out) {
  auto fate = decide(node);
  if (fate.leaf) out.solution(std::move(*fate.leaf));
  for (const Node& child : fate.children) out.branch(child);
}

SignPatternTree::Fate SignPatternTree::decide(const Node& node) {
  const auto answer = solve(node);
  tally_.iterations += static_cast<std::uint64_t>(answer.iterations);
  if (answer.sign == conic::Sign::dead) {
    ++tally_.dead;
    if (witness_) report_dead(node);
    return {};
  }
  if (free_candidates(node) == 0) {
    auto leaf = configuration(node, answer);
    switch (leaf.state) {
      case LeafState::alive:
        ++tally_.found;
        break;
      case LeafState::marginal:
        ++tally_.marginal;
        break;
      case LeafState::undecided:
        ++tally_.undecided;
        break;
    }
    if (witness_) report_leaf(leaf);
    return {.children = {}, .leaf = std::move(leaf)};
  }
  ++tally_.branched;
  if (answer.sign == conic::Sign::marginal) ++tally_.doubtful;
  const auto split = bit(branching_candidate(node));
  return {
      .children = {{node.contact | split, node.separated}, {node.contact, node.separated | split}},
      .leaf = {}};
}

// A leaf that lives is worth its full accuracy: its margin is part of the answer.
conic::Answer SignPatternTree::solve(const Node& node) {
  const conic::StopEarly stop{.when_dead = true, .when_alive = free_candidates(node) != 0};
  return std::visit([&](auto& solver) { return solver.solve(node.contact, node.separated, stop); },
                    solver_);
}

// The candidate that violates complementarity most. Of equal ones the first, so that the tree is
// the same everywhere.
int SignPatternTree::branching_candidate(const Node& node) const {
  return std::visit(
      [&](const auto& solver) {
        const auto open = free_candidates(node);
        int best = std::countr_zero(open);
        double largest = -1;
        for (auto rest = open; rest != 0; rest &= rest - 1) {
          const int i = std::countr_zero(rest);
          const Eigen::Index normal = dimension_ * i;
          const double product = solver.displacement()(normal) * solver.reaction()(normal) *
                                 weight_[static_cast<std::size_t>(i)];
          if (product > largest) {
            largest = product;
            best = i;
          }
        }
        return best;
      },
      solver_);
}

LeafState SignPatternTree::leaf_state(const conic::Answer& answer) const {
  if (answer.sign == conic::Sign::alive) return LeafState::alive;
  const bool bracketed = answer.lower >= -tolerances_.sign && answer.upper <= tolerances_.sign;
  return bracketed ? LeafState::marginal : LeafState::undecided;
}

Configuration SignPatternTree::configuration(const Node& node, const conic::Answer& answer) const {
  return std::visit(
      [&](const auto& solver) {
        const Eigen::VectorXd& r = solver.reaction();
        const Eigen::VectorXd u = unit_ * solver.displacement();
        return Configuration{.pattern = node,
                             .state = leaf_state(answer),
                             .lower = answer.lower,
                             .upper = answer.upper,
                             .reaction = {r.begin(), r.end()},
                             .displacement = {u.begin(), u.end()}};
      },
      solver_);
}

void SignPatternTree::report_dead(const Node& node) const {
  std::visit(
      [&](const auto& solver) {
        const Eigen::VectorXd& y = solver.multipliers();
        const std::span<const double> numbers(y.data(), static_cast<std::size_t>(y.size()));
        witness_({.kind = Evidence::Kind::dead, .node = node, .numbers = numbers});
      },
      solver_);
}

void SignPatternTree::report_leaf(const Configuration& leaf) const {
  if (leaf.state != LeafState::alive) {
    witness_({.kind = Evidence::Kind::marginal, .node = leaf.pattern, .numbers = {}});
    return;
  }
  std::vector<double> tangential;
  for (auto touching = leaf.pattern.contact; touching != 0; touching &= touching - 1) {
    const auto* const normal =
        leaf.reaction.data() + std::ptrdiff_t{dimension_} * std::countr_zero(touching);
    tangential.insert(tangential.end(), normal + 1, normal + dimension_);
  }
  witness_({.kind = Evidence::Kind::alive, .node = leaf.pattern, .numbers = tangential});
}

}  // namespace kusabi::nodes
