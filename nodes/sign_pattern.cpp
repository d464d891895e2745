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

}  // namespace

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
    : dimension_(problem.dimension),
      candidates_(first_bits(problem.contact_names.size())),
      unit_(problems::mean_normal_compliance(problem)),
      tolerances_(options.tolerances),
      weight_(branching_weights(problem, friction, options.branching)),
      solver_([&]() -> Solver {
        const Eigen::MatrixXd scaled = problem.compliance / unit_;
        if (problem.dimension == 2) return conic::NodeSolver<2>(scaled, friction, tolerances_);
        return conic::NodeSolver<3>(scaled, friction, tolerances_);
      }()) {
  if (options.facets != 0)
    outer_.emplace(problem.compliance / unit_, friction, options.facets, tolerances_);
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
    answer = solve(node, {.when_dead = true, .when_alive = !leaf});
    tally_.iterations += static_cast<std::uint64_t>(answer.iterations);
    if (answer.sign == conic::Sign::dead) {
      prune(node, multipliers());
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
  const auto split = bit(branching_candidate(node));
  return {
      .children = {{node.contact | split, node.separated}, {node.contact, node.separated | split}},
      .leaf = {}};
}

conic::Answer SignPatternTree::solve(const Node& node, conic::StopEarly stop) {
  return std::visit([&](auto& solver) { return solver.solve(node.contact, node.separated, stop); },
                    solver_);
}

const Eigen::VectorXd& SignPatternTree::multipliers() const {
  return std::visit(
      [](const auto& solver) -> const Eigen::VectorXd& { return solver.multipliers(); }, solver_);
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
  return std::visit(
      [&](const auto& solver) {
        const Eigen::Index normal = Eigen::Index{dimension_} * candidate;
        return solver.displacement()(normal) * solver.reaction()(normal);
      },
      solver_);
}

// The candidate that violates complementarity most. Of equal ones the first, so that the tree is
// the same everywhere.
int SignPatternTree::branching_candidate(const Node& node) const {
  const auto open = free_candidates(node);
  int best = std::countr_zero(open);
  double largest = -1;
  for (auto rest = open; rest != 0; rest &= rest - 1) {
    const int i = std::countr_zero(rest);
    const double product = violation(i) * weight_[static_cast<std::size_t>(i)];
    if (product > largest) {
      largest = product;
      best = i;
    }
  }
  return best;
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
