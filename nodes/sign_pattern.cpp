// How a node of the sign-pattern tree is decided and split.
#include "nodes/sign_pattern.hpp"

#include <bit>
#include <cstddef>

namespace kusabi::nodes {
namespace {

std::uint64_t bit(int candidate) {
  return std::uint64_t{1} << static_cast<unsigned>(candidate);
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
  candidates += other.candidates;
  return *this;
}

SignPatternTree::SignPatternTree(const problems::WedgedProblem& problem,
                                 std::span<const double> friction, SignPatternOptions options)
    : candidates_(all_candidates(problem)),
      tolerances_(options.tolerances),
      weight_(branching_weights(problem, friction, options.branching)),
      solver_(problem, friction, tolerances_) {
  if (options.facets != 0)
    outer_.emplace(problem.compliance / solver_.unit(), friction, options.facets, tolerances_);
}

void SignPatternTree::expand(Node&& node, engine::Expansion<SignPatternTree>& out) {
  auto fate = decide(node);
  if (fate.leaf) out.solution(std::move(*fate.leaf));
  for (const Node& child : fate.children) out.branch(child);
}

SignPatternTree::Fate SignPatternTree::decide(const Node& node) {
  const bool leaf = free_candidates(node) == 0;
  conic::Answer answer;
  if (outer_) {
    answer = outer_->solve(node.contact, node.separated, {});
    tally_.iterations += static_cast<std::uint64_t>(answer.iterations);
    if (answer.sign == conic::Sign::dead) {
      prune(node, outer_->multipliers());
      return {};
    }
    if (leaf) ++tally_.candidates;
  }
  if (!outer_ || leaf) {
    // A leaf that lives is worth its full accuracy: its margin is part of the answer.
    answer = solver_.solve(node.contact, node.separated, {.when_dead = true, .when_alive = !leaf});
    tally_.iterations += static_cast<std::uint64_t>(answer.iterations);
    if (answer.sign == conic::Sign::dead) {
      prune(node, solver_.multipliers());
      return {};
    }
  }
  if (leaf) {
    auto found = configuration(node, answer);
    switch (found.state) {
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
    if (witness_) report_leaf(found);
    return {.children = {}, .leaf = std::move(found)};
  }
  ++tally_.branched;
  if (answer.sign == conic::Sign::marginal) ++tally_.doubtful;
  const auto split = bit(
      branching_candidate(free_candidates(node), weight_, [this](int i) { return violation(i); }));
  return {
      .children = {{node.contact | split, node.separated}, {node.contact, node.separated | split}},
      .leaf = {}};
}

void SignPatternTree::prune(const Node& node, const Eigen::VectorXd& multipliers) {
  ++tally_.dead;
  if (!witness_) return;
  const std::span<const double> numbers(multipliers.data(),
                                        static_cast<std::size_t>(multipliers.size()));
  witness_({.kind = Evidence::Kind::dead, .node = node, .numbers = numbers});
}

double SignPatternTree::violation(int candidate) const {
  if (outer_) return outer_->normal_displacement(candidate) * outer_->normal_reaction(candidate);
  return solver_.violation(candidate);
}

LeafState SignPatternTree::leaf_state(const conic::Answer& answer) const {
  if (answer.sign == conic::Sign::alive) return LeafState::alive;
  const bool bracketed = answer.lower >= -tolerances_.sign && answer.upper <= tolerances_.sign;
  return bracketed ? LeafState::marginal : LeafState::undecided;
}

Configuration SignPatternTree::configuration(const Node& node, const conic::Answer& answer) const {
  const Eigen::VectorXd& r = solver_.reaction();
  const Eigen::VectorXd u = solver_.unit() * solver_.displacement();
  return {.pattern = node,
          .state = leaf_state(answer),
          .lower = answer.lower,
          .upper = answer.upper,
          .reaction = {r.begin(), r.end()},
          .displacement = {u.begin(), u.end()}};
}

void SignPatternTree::report_leaf(const Configuration& leaf) const {
  if (leaf.state != LeafState::alive) {
    witness_({.kind = Evidence::Kind::marginal, .node = leaf.pattern, .numbers = {}});
    return;
  }
  std::vector<double> tangential;
  for (auto touching = leaf.pattern.contact; touching != 0; touching &= touching - 1) {
    const auto* const normal = leaf.reaction.data() + solver_.normal(std::countr_zero(touching));
    tangential.insert(tangential.end(), normal + 1, normal + solver_.dimension());
  }
  witness_({.kind = Evidence::Kind::alive, .node = leaf.pattern, .numbers = tangential});
}

}  // namespace kusabi::nodes
