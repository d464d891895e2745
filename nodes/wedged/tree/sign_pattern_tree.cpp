// Decision and branching of nodes of the tree of sign patterns.
#include "nodes/wedged/tree/sign_pattern_tree.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <stdexcept>
#include <utility>

#include "engine/search.hpp"
#include "nodes/wedged/relaxation/degenerate_node.hpp"
#include "problems/wedged/problem_block.hpp"

namespace kusabi::wedged {

using support::IndexSet;

namespace {

std::vector<double> part_of(std::span<const double> numbers, const IndexSet& candidates) {
  std::vector<double> part;
  for (const int candidate : candidates)
    part.push_back(numbers[static_cast<std::size_t>(candidate)]);
  return part;
}

// The child in contact comes first.
std::array<PatternNode, 2> children(const PatternNode& node, int candidate) {
  const auto own = IndexSet::single(candidate);
  const auto& [contact, separated, inactive] = node.pattern;
  return {
      {{node.block, {contact | own, separated, {}}}, {node.block, {contact, separated | own, {}}}}};
}

}  // namespace

SignPatternTree::SignPatternTree(const problems::WedgedProblem& problem,
                                 std::span<const double> friction, SignPatternOptions options)
    : tolerances_(options.tolerances), probes_(options.probes), thorough_(options.thorough) {
  if (friction.size() != problem.contact_names.size())
    throw std::invalid_argument("every candidate needs a friction coefficient");
  for (const auto& candidates : problems::blocks_of(problem)) {
    blocks_.emplace_back(problems::block_problem(problem, candidates), candidates,
                         part_of(friction, candidates), options);
    blocks_.back().solver.end_when(interruption_.stop());
  }
  tally_.of_block.resize(blocks_.size());
}

double SignPatternTree::objective(const Solution& leaf) const {
  const auto& [contact, separated, inactive] = leaf.pattern;
  return (contact | separated | inactive).size();
}

double SignPatternTree::bound(const Node& node) const {
  return (node.pattern.contact | node.pattern.separated).size();
}

void SignPatternTree::tighten(std::size_t block, std::vector<CandidateBounds> bounds) {
  auto& own = blocks_[block];
  own.solver.make_room(static_cast<int>(bounds.size()));
  own.bounds = std::move(bounds);
}

bool SignPatternTree::emit(const engine::Path& /*path*/, Solution& leaf) {
  if (!keep_ || leaf.state != LeafState::feasible) return false;
  keep_(leaf);
  tally_.keep(leaf);
  return true;
}

void SignPatternTree::expand(Node&& node, engine::Expansion<SignPatternTree>& out) {
  auto decision = decide(node, out);
  if (!decision) return;
  if (decision->leaf) out.solution(std::move(*decision->leaf));
  for (const Node& child : decision->children) out.branch(child);
}

SignPatternTree::NodeResult SignPatternTree::decide(const Node& node) {
  if (node.block == Node::all_blocks) {
    NodeResult decision;
    for (std::uint32_t block = 0; block < blocks_.size(); ++block)
      decision.children.push_back({.block = block, .pattern = {}});
    return decision;
  }
  if (auto decision = decide_with_cuts(node)) return std::move(*decision);
  BlockRelaxation& block = blocks_[node.block];
  const auto& [contact, separated, inactive] = node.pattern;
  const bool leaf = block.free(node.pattern).empty();
  // A feasible leaf is solved to full accuracy, since its margin is part of the answer.
  const conic::StopEarly stop{.when_infeasible = true, .when_feasible = !leaf};
  double polyhedral = 0;
  if (block.outer) {
    const auto answer = block.outer->solve(contact, separated, stop);
    tally_.iterations += static_cast<std::uint64_t>(answer.iterations);
    if (answer.sign == conic::Sign::infeasible) return prune(node, block.outer->multipliers());
    polyhedral = answer.lower;
    if (!leaf && answer.sign == conic::Sign::feasible)
      return split(node, block.rule.most_violated(block.free(node.pattern), [&block](int i) {
        return block.outer->normal_displacement(i) * block.outer->normal_reaction(i);
      }));
  }
  const auto answer = block.solver.solve(contact, separated, stop);
  tally_.iterations += static_cast<std::uint64_t>(answer.iterations);
  if (answer.precision_level > 0) ++tally_.escalated;
  if (block.outer && leaf) note_tested(node, polyhedral, answer);
  switch (answer.sign) {
    case conic::Sign::infeasible:
      return prune(node, block.solver.multipliers());
    case conic::Sign::feasible:
      if (leaf) return close(node, block.configuration(node, LeafState::feasible, answer));
      break;
    case conic::Sign::unproved:
      return decide_undecided(node, answer);
  }
  return branch_feasible(node);
}

// A candidate without configurations on one side is branched on before any program is solved, and
// the child on that side is infeasible by the bound alone. A node undecided with cuts is solved
// without them.
std::optional<SignPatternTree::NodeResult> SignPatternTree::decide_with_cuts(const Node& node) {
  BlockRelaxation& block = blocks_[node.block];
  const auto free = block.free(node.pattern);
  if (block.bounds.empty()) return {};
  const auto& [contact, separated, inactive] = node.pattern;
  if (excludes_all(block.bounds, contact, separated)) {
    const auto nothing = [](const BlockRelaxation& own) {
      return std::vector<double>(2 * own.bounds.size() +
                                 static_cast<std::size_t>(own.mean_motion.count()));
    };
    if (auto decision = prune_by_cuts(node, nothing)) return decision;
  }
  if (free.empty()) return {};
  if (const auto known = one_sided(free, block.bounds)) return split(node, *known);
  const auto cuts = cuts_of(free, block.bounds);
  const auto answer = block.solver.solve_with(cuts, contact, separated, {});
  tally_.iterations += static_cast<std::uint64_t>(answer.iterations);
  switch (answer.sign) {
    case conic::Sign::infeasible:
      return prune_by_cuts(node, [&](const BlockRelaxation& own) {
        return cut_evidence(own.solver, own.mean_motion, cuts);
      });
    case conic::Sign::feasible:
      return branch_feasible(node);
    case conic::Sign::unproved:
      break;
  }
  return {};
}

void SignPatternTree::note_tested(const Node& leaf, double polyhedral,
                                  const conic::ConicResult& answer) {
  ++tally_.polyhedral_leaves;
  tally_.tested.push_back({.block = leaf.block,
                           .pattern = blocks_[leaf.block].in_whole(leaf.pattern),
                           .polyhedral = polyhedral,
                           .lower = answer.lower,
                           .upper = answer.upper});
}

SignPatternTree::NodeResult SignPatternTree::decide_undecided(const Node& node,
                                                              const conic::ConicResult& answer) {
  using Kind = DegenerateNode::Kind;
  BlockRelaxation& block = blocks_[node.block];
  const auto free = block.free(node.pattern);
  const DegenerateClassifier classifier(tolerances_, thorough_, evidence_.records());
  const bool degenerate = classifier.is_degenerate(answer);
  if (degenerate) {
    auto found = classifier.classify(block, node, answer, tally_.iterations);
    switch (found.kind) {
      case Kind::infeasible:
        if (answer.upper < 0) return prune(node, found.multipliers);
        ++tally_.infeasible;
        record_unclaimed(node);
        return {};
      case Kind::redundant:
        ++tally_.faces;
        record_unclaimed(node);
        return {};
      case Kind::leaf:
        return close(node, std::move(*found.leaf));
      case Kind::split:
        return branch(node, found.undecided);
      case Kind::unknown:
        break;
    }
  }
  if (free.empty())
    return close(node, block.configuration(
                           node, degenerate ? LeafState::marginal : LeafState::undecided, answer));
  ++tally_.branched_undecided;
  return branch(node, free);
}

SignPatternTree::NodeResult SignPatternTree::branch(const Node& node, const IndexSet& undecided) {
  BlockRelaxation& block = blocks_[node.block];
  return split(node, block.rule.candidate(undecided, block.solver));
}

// Branches a feasible node by the last solution.
SignPatternTree::NodeResult SignPatternTree::branch_feasible(const Node& node) {
  BlockRelaxation& block = blocks_[node.block];
  const auto free = block.free(node.pattern);
  if (probes_ == 0 || block.outer) return branch(node, free);
  return split(node, probed(node, block.rule.best(free, block.solver, probes_)));
}

// Strong branching: a candidate with an infeasible child leaves one child; otherwise t* of both
// children measures their size, and the candidate with the smallest product is chosen.
int SignPatternTree::probed(const Node& node, std::span<const int> tried) {
  int best = tried.front();
  double minimum = std::numeric_limits<double>::infinity();
  for (const int candidate : tried) {
    double left = 1;
    for (const Node& child : children(node, candidate)) {
      const auto answer = probe(child);
      if (answer.sign == conic::Sign::infeasible) return candidate;
      left *= std::max(answer.lower, tolerances_.sign);
    }
    if (left < minimum) {
      minimum = left;
      best = candidate;
    }
  }
  return best;
}

// The child's program without escalation of undecided signs.
conic::ConicResult SignPatternTree::probe(const Node& child) {
  BlockRelaxation& block = blocks_[child.block];
  const auto& [contact, separated, inactive] = child.pattern;
  const auto free = block.free(child.pattern);
  const conic::StopEarly stop{.when_infeasible = true, .when_feasible = false};
  const bool has_cuts = !block.bounds.empty() && !free.empty();
  const auto answer =
      has_cuts ? block.solver.solve_with(cuts_of(free, block.bounds), contact, separated, stop)
               : block.solver.solve(contact, separated, stop);
  ++tally_.probed;
  tally_.iterations += static_cast<std::uint64_t>(answer.iterations);
  return answer;
}

SignPatternTree::NodeResult SignPatternTree::split(const Node& node, int candidate) {
  ++tally_.branched;
  const auto both = children(node, candidate);
  return {.children = {both.begin(), both.end()}, .leaf = {}};
}

// False: the exact test refuses the evidence, and refused claims are not used.
bool SignPatternTree::closes(const Node& node, Evidence::Kind kind,
                             std::span<const double> numbers) {
  return evidence_.passes({.kind = kind,
                           .block = node.block,
                           .node = blocks_[node.block].in_whole(node.pattern),
                           .numbers = numbers},
                          tally_);
}

// A node whose evidence is refused is branched, unless its subtree is too large; a leaf is left
// undecided.
SignPatternTree::NodeResult SignPatternTree::branch_unproved(const Node& node) {
  constexpr int max_free = 8;
  BlockRelaxation& block = blocks_[node.block];
  const auto free = block.free(node.pattern);
  if (free.size() > max_free) {
    ++tally_.infeasible;
    ++tally_.closed_unproved;
    record_unclaimed(node);
    return {};
  }
  if (block.outer) block.solver.solve(node.pattern.contact, node.pattern.separated, {});
  if (!free.empty()) return branch(node, free);
  constexpr double infinity = std::numeric_limits<double>::infinity();
  return close(node, block.configuration(node, LeafState::undecided,
                                         {.lower = -infinity, .upper = infinity}));
}

SignPatternTree::NodeResult SignPatternTree::prune(const Node& node,
                                                   const Eigen::VectorXd& multipliers) {
  if (evidence_.wants_evidence()) {
    const BlockRelaxation& block = blocks_[node.block];
    if (!closes(node, Evidence::Kind::infeasible, block.infeasible_numbers(multipliers)))
      return branch_unproved(node);
  }
  ++tally_.infeasible;
  return {};
}

// Infeasible by cuts, or by the bounds alone.
std::optional<SignPatternTree::NodeResult> SignPatternTree::prune_by_cuts(
    const Node& node, const std::function<std::vector<double>(const BlockRelaxation&)>& numbers) {
  if (evidence_.wants_evidence() &&
      !closes(node, Evidence::Kind::cut, numbers(blocks_[node.block])))
    return {};
  ++tally_.infeasible;
  return NodeResult{};
}

SignPatternTree::NodeResult SignPatternTree::close(const Node& node, Configuration leaf) {
  const bool feasible = leaf.state == LeafState::feasible;
  if (feasible &&
      !closes(node, Evidence::Kind::feasible, blocks_[node.block].feasible_numbers(node, leaf)))
    leaf.state = LeafState::undecided;
  switch (leaf.state) {
    case LeafState::feasible:
      ++tally_.found;
      ++tally_.of_block[leaf.block];
      break;
    case LeafState::flat:
      ++tally_.flat;
      break;
    case LeafState::marginal:
      ++tally_.marginal;
      break;
    case LeafState::undecided:
      ++tally_.undecided;
      break;
  }
  if (leaf.state != LeafState::feasible) record_unclaimed(node);
  return {.children = {}, .leaf = std::move(leaf)};
}

void SignPatternTree::record_unclaimed(const Node& node) {
  evidence_.pass_open({.kind = Evidence::Kind::no_claim,
                       .block = node.block,
                       .node = blocks_[node.block].in_whole(node.pattern),
                       .numbers = {}},
                      tally_);
}

}  // namespace kusabi::wedged

template kusabi::engine::OutcomeOf<kusabi::wedged::SignPatternTree> kusabi::engine::search(
    kusabi::wedged::SignPatternTree&, kusabi::engine::Transport&, const kusabi::engine::Options&);
