// Decision and branching of nodes of the tree of sign patterns.
#include "nodes/wedged/tree/sign_pattern.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <stdexcept>
#include <utility>

namespace kusabi::wedged {

using support::IndexSet;

namespace {

std::vector<double> part_of(std::span<const double> numbers, const IndexSet& candidates) {
  std::vector<double> part;
  for (const int candidate : candidates)
    part.push_back(numbers[static_cast<std::size_t>(candidate)]);
  return part;
}

SignPattern in_whole(const SignPattern& own, const IndexSet& block) {
  return {.contact = problems::in_whole(own.contact, block),
          .separated = problems::in_whole(own.separated, block),
          .at_rest = problems::in_whole(own.at_rest, block)};
}

// The child in contact comes first.
std::array<PatternNode, 2> children(const PatternNode& node, int candidate) {
  const auto own = IndexSet::single(candidate);
  const auto& [contact, separated, at_rest] = node.pattern;
  return {
      {{node.block, {contact | own, separated, {}}}, {node.block, {contact, separated | own, {}}}}};
}

}  // namespace

SignPattern own_leaf(const Configuration& found, const IndexSet& block) {
  const auto& contact = found.pattern.contact;
  return {.contact = problems::in_block(contact, block),
          .separated = problems::in_block(block - contact, block),
          .at_rest = {}};
}

SignPatternTree::Block::Block(const problems::WedgedProblem& problem, IndexSet within_whole,
                              std::span<const double> friction, const SignPatternOptions& options)
    : candidates(std::move(within_whole)),
      all(problems::all_candidates(problem)),
      rule(problem, friction, options.branching),
      solver(problem, friction, options.tolerances, options.precision),
      mean_motion(problem) {
  if (options.facets != 0)
    outer.emplace(problem.compliance / solver.unit(), friction, options.facets, options.tolerances,
                  problem.compliance_error, problem.motions, problem.motion_error);
}

SignPatternTree::SignPatternTree(const problems::WedgedProblem& problem,
                                 std::span<const double> friction, SignPatternOptions options)
    : tolerances_(options.tolerances), probes_(options.probes), thorough_(options.thorough) {
  if (friction.size() != problem.contact_names.size())
    throw std::invalid_argument("every candidate needs a friction coefficient");
  for (const auto& candidates : problems::blocks_of(problem)) {
    blocks_.emplace_back(problems::block_problem(problem, candidates), candidates,
                         part_of(friction, candidates), options);
    blocks_.back().solver.end_when(pollable_.stop());
  }
}

double SignPatternTree::objective(const Solution& leaf) const {
  const auto& [contact, separated, at_rest] = leaf.pattern;
  return (contact | separated | at_rest).size();
}

double SignPatternTree::bound(const Node& node) const {
  return (node.pattern.contact | node.pattern.separated).size();
}

void SignPatternTree::tighten(std::size_t block, std::vector<CandidateBounds> bounds) {
  auto& own = blocks_[block];
  own.solver.make_room(static_cast<int>(bounds.size()));
  own.bounds = std::move(bounds);
}

void SignPatternTree::expand(Node&& node, engine::Expansion<SignPatternTree>& out) {
  auto fate = decide(node, out);
  if (!fate) return;
  if (fate->leaf) out.solution(std::move(*fate->leaf));
  for (const Node& child : fate->children) out.branch(child);
}

SignPatternTree::Fate SignPatternTree::decide(const Node& node) {
  if (node.block == Node::all_blocks) {
    Fate fate;
    for (std::uint32_t block = 0; block < blocks_.size(); ++block)
      fate.children.push_back({.block = block, .pattern = {}});
    return fate;
  }
  if (auto fate = decide_with_cuts(node)) return std::move(*fate);
  Block& block = blocks_[node.block];
  const auto& [contact, separated, at_rest] = node.pattern;
  const bool leaf = block.free(node.pattern).empty();
  // A feasible leaf is solved to full accuracy, since its margin is part of the answer.
  const conic::StopEarly stop{.when_dead = true, .when_alive = !leaf};
  double polyhedral = 0;
  if (block.outer) {
    const auto answer = block.outer->solve(contact, separated, stop);
    tally_.iterations += static_cast<std::uint64_t>(answer.iterations);
    if (answer.sign == conic::Sign::dead) return prune(node, block.outer->multipliers());
    polyhedral = answer.lower;
    if (!leaf && answer.sign == conic::Sign::alive)
      return split(node, block.rule.most_violated(block.free(node.pattern), [&block](int i) {
        return block.outer->normal_displacement(i) * block.outer->normal_reaction(i);
      }));
  }
  const auto answer = block.solver.solve(contact, separated, stop);
  tally_.iterations += static_cast<std::uint64_t>(answer.iterations);
  if (answer.precision_level > 0) ++tally_.escalated;
  if (block.outer && leaf) note_tested(node, polyhedral, answer);
  switch (answer.sign) {
    case conic::Sign::dead:
      return prune(node, block.solver.multipliers());
    case conic::Sign::alive:
      if (leaf) return close(node, configuration(node, LeafState::alive, answer));
      break;
    case conic::Sign::marginal:
      return decide_doubt(node, answer);
  }
  return branch_living(node);
}

// A candidate without configurations on one side is branched on before any program is solved, and
// the child on that side is infeasible by the bound alone. A node undecided with cuts is solved
// without them.
std::optional<SignPatternTree::Fate> SignPatternTree::decide_with_cuts(const Node& node) {
  Block& block = blocks_[node.block];
  const auto free = block.free(node.pattern);
  if (block.bounds.empty()) return {};
  const auto& [contact, separated, at_rest] = node.pattern;
  if (leaves_nothing(block.bounds, contact, separated)) {
    if (auto fate = prune_by_bounds(node)) return fate;
  }
  if (free.empty()) return {};
  if (const auto known = one_sided(free, block.bounds)) return split(node, *known);
  const auto cuts = cuts_of(free, block.bounds);
  const auto answer = block.solver.solve_with(cuts, contact, separated, {});
  tally_.iterations += static_cast<std::uint64_t>(answer.iterations);
  switch (answer.sign) {
    case conic::Sign::dead:
      return prune_with(cuts, node);
    case conic::Sign::alive:
      return branch_living(node);
    case conic::Sign::marginal:
      break;
  }
  return {};
}

void SignPatternTree::note_tested(const Node& leaf, double polyhedral,
                                  const conic::ConicResult& answer) {
  ++tally_.candidates;
  tally_.tested.push_back({.block = leaf.block,
                           .pattern = in_whole(leaf.pattern, blocks_[leaf.block].candidates),
                           .polyhedral = polyhedral,
                           .lower = answer.lower,
                           .upper = answer.upper});
}

// A degenerate node in which some candidate of U has no reaction is redundant: all its
// configurations are below the node with that candidate in R. Otherwise it is closed if the zeros
// of its relative interior leave no candidate to be decided.
SignPatternTree::Fate SignPatternTree::decide_doubt(const Node& node,
                                                    const conic::ConicResult& answer) {
  Block& block = blocks_[node.block];
  // A sign that no precision level resolves counts as zero, unless an exact test follows.
  const bool counts_as_zero = tolerances_.resolution >= rounding_of_files;
  const bool tie = counts_as_zero ? conic::is_tie(answer, tolerances_)
                                  : conic::is_resolved_tie(answer, tolerances_);
  const auto free = block.free(node.pattern);
  if (tie) {
    const Eigen::VectorXd multipliers = block.solver.multipliers();
    const auto inside =
        block.solver.relative_interior(node.pattern.contact, node.pattern.separated);
    if (inside && inside->loaded.empty()) {  // infeasible, though by less than the tolerance
      if (answer.upper < 0) return prune(node, multipliers);
      ++tally_.dead;
      report_open(node);
      return {};
    }
    const bool repeated = inside && !inside->loaded.includes(node.pattern.contact);
    if (repeated && (!thorough_ || free.empty())) {
      ++tally_.faces;
      report_open(node);
      return {};
    }
    if (inside && !repeated && !inside->loaded.meets(inside->moved)) {
      const SignPattern cone{.contact = inside->loaded,
                             .separated = inside->moved,
                             .at_rest = block.all - (inside->loaded | inside->moved)};
      // If equilibrium makes all reactions of the free candidates zero, the node is degenerate, but
      // the single leaf below it with configurations may be solid.
      if (cone.at_rest.empty() && !free.empty()) {
        if (thorough_ || recorder_) return branch(node, free);
        const auto own = block.solver.solve(cone.contact, cone.separated,
                                            {.when_dead = true, .when_alive = false});
        tally_.iterations += static_cast<std::uint64_t>(own.iterations);
        if (own.sign == conic::Sign::alive)
          return close(node, configuration({node.block, cone}, LeafState::alive, own));
        if (!conic::is_resolved_tie(own, tolerances_)) return branch(node, free);
      }
      auto flat = configuration({node.block, cone}, LeafState::flat, answer);
      const IndexSet doubtful = cone.at_rest & free;
      if (!doubtful.empty() && is_solid(block, cone)) return branch(node, doubtful);
      return close(node, std::move(flat));
    }
    const auto both = inside ? inside->loaded & inside->moved : IndexSet();
    if (!both.empty() || repeated) return branch(node, both.empty() ? free : both);
  }
  if (free.empty())
    return close(node,
                 configuration(node, tie ? LeafState::marginal : LeafState::undecided, answer));
  ++tally_.doubtful;
  return branch(node, free);
}

// The inactive candidates of a flat cone are those of negligible reactions and gaps. Their gaps may
// be positive nevertheless.
bool SignPatternTree::is_solid(Block& block, const SignPattern& cone) {
  const auto answer = block.solver.solve(cone.contact, block.all - cone.contact, {});
  tally_.iterations += static_cast<std::uint64_t>(answer.iterations);
  return answer.sign == conic::Sign::alive;
}

SignPatternTree::Fate SignPatternTree::branch(const Node& node, const IndexSet& open) {
  Block& block = blocks_[node.block];
  return split(node, block.rule.candidate(open, block.solver));
}

// Branches a feasible node by the last solution.
SignPatternTree::Fate SignPatternTree::branch_living(const Node& node) {
  Block& block = blocks_[node.block];
  const auto free = block.free(node.pattern);
  if (probes_ == 0 || block.outer) return branch(node, free);
  return split(node, probed(node, block.rule.best(free, block.solver, probes_)));
}

// Strong branching: a candidate with an infeasible child leaves one child; otherwise t* of both
// children measures their size, and the candidate with the smallest product is chosen.
int SignPatternTree::probed(const Node& node, std::span<const int> tried) {
  int best = tried.front();
  double least = std::numeric_limits<double>::infinity();
  for (const int candidate : tried) {
    double left = 1;
    for (const Node& child : children(node, candidate)) {
      const auto answer = probe(child);
      if (answer.sign == conic::Sign::dead) return candidate;
      left *= std::max(answer.lower, tolerances_.sign);
    }
    if (left < least) {
      least = left;
      best = candidate;
    }
  }
  return best;
}

// The child's program without escalation of undecided signs.
conic::ConicResult SignPatternTree::probe(const Node& child) {
  Block& block = blocks_[child.block];
  const auto& [contact, separated, at_rest] = child.pattern;
  const auto free = block.free(child.pattern);
  const conic::StopEarly stop{.when_dead = true, .when_alive = false};
  const bool has_cuts = !block.bounds.empty() && !free.empty();
  const auto answer =
      has_cuts ? block.solver.solve_with(cuts_of(free, block.bounds), contact, separated, stop)
               : block.solver.solve(contact, separated, stop);
  ++tally_.probed;
  tally_.iterations += static_cast<std::uint64_t>(answer.iterations);
  return answer;
}

SignPatternTree::Fate SignPatternTree::split(const Node& node, int candidate) {
  ++tally_.branched;
  const auto both = children(node, candidate);
  return {.children = {both.begin(), both.end()}, .leaf = {}};
}

// Passes the evidence of a closed node to the recorder, unless the exact test refuses it.
bool SignPatternTree::closes(const Node& node, Evidence::Kind kind,
                             std::span<const double> numbers) {
  const Evidence evidence{.kind = kind,
                          .block = node.block,
                          .node = in_whole(node.pattern, blocks_[node.block].candidates),
                          .numbers = numbers};
  const bool accepted = !judge_ || judge_(evidence);
  if (!accepted) {
    ++tally_.refused;
    if (binding_) return false;
    if (kind != Evidence::Kind::alive) ++tally_.doubted;
  } else if (kind == Evidence::Kind::alive) {
    ++tally_.proved;
  }
  if (recorder_) recorder_(evidence);
  return true;
}

// A node whose evidence is refused is branched, unless its subtree is too large; a leaf is left
// undecided.
SignPatternTree::Fate SignPatternTree::doubt(const Node& node) {
  constexpr int most_free = 8;
  Block& block = blocks_[node.block];
  const auto free = block.free(node.pattern);
  if (free.size() > most_free) {
    ++tally_.dead;
    ++tally_.doubted;
    report_open(node);
    return {};
  }
  if (block.outer) block.solver.solve(node.pattern.contact, node.pattern.separated, {});
  if (!free.empty()) return branch(node, free);
  constexpr double infinity = std::numeric_limits<double>::infinity();
  return close(node,
               configuration(node, LeafState::undecided, {.lower = -infinity, .upper = infinity}));
}

SignPatternTree::Fate SignPatternTree::prune(const Node& node, const Eigen::VectorXd& multipliers) {
  if (recorder_ || judge_) {
    const Block& block = blocks_[node.block];
    const auto numbers = block.mean_motion.with_multipliers(multipliers, block.solver.unit());
    if (!closes(node, Evidence::Kind::dead, numbers)) return doubt(node);
  }
  ++tally_.dead;
  return {};
}

std::optional<SignPatternTree::Fate> SignPatternTree::prune_with(std::span<const conic::Cut> cuts,
                                                                 const Node& node) {
  if (recorder_ || judge_) {
    const Block& block = blocks_[node.block];
    const auto numbers = cut_evidence(block.solver, block.mean_motion, cuts);
    if (!closes(node, Evidence::Kind::cut, numbers)) return {};
  }
  ++tally_.dead;
  return Fate{};
}

// Infeasible by the bounds alone.
std::optional<SignPatternTree::Fate> SignPatternTree::prune_by_bounds(const Node& node) {
  if (recorder_ || judge_) {
    const Block& block = blocks_[node.block];
    const std::vector<double> nothing(2 * block.bounds.size() +
                                      static_cast<std::size_t>(block.mean_motion.count()));
    if (!closes(node, Evidence::Kind::cut, nothing)) return {};
  }
  ++tally_.dead;
  return Fate{};
}

SignPatternTree::Fate SignPatternTree::close(const Node& node, Configuration leaf) {
  const bool alive = leaf.state == LeafState::alive;
  if (alive && !closes(node, Evidence::Kind::alive, evidence_of(node, leaf)))
    leaf.state = LeafState::undecided;
  switch (leaf.state) {
    case LeafState::alive:
      ++tally_.found;
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
  if (leaf.state != LeafState::alive) report_open(node);
  return {.children = {}, .leaf = std::move(leaf)};
}

Configuration SignPatternTree::configuration(const Node& node, LeafState state,
                                             const conic::ConicResult& answer) const {
  const Block& block = blocks_[node.block];
  const Eigen::VectorXd& r = block.solver.reaction();
  const Eigen::VectorXd u = block.solver.unit() * block.solver.displacement();
  return {.block = node.block,
          .pattern = in_whole(node.pattern, block.candidates),
          .state = state,
          .lower = answer.lower,
          .upper = answer.upper,
          .reaction = {r.begin(), r.end()},
          .displacement = {u.begin(), u.end()}};
}

std::vector<double> SignPatternTree::evidence_of(const Node& node,
                                                 const Configuration& leaf) const {
  const Block& block = blocks_[node.block];
  std::vector<double> numbers;  // tangential reactions first
  for (const int touching : node.pattern.contact) {
    const auto* const normal = leaf.reaction.data() + block.solver.normal(touching);
    numbers.insert(numbers.end(), normal + 1, normal + block.solver.dimension());
  }
  const Eigen::Map<const Eigen::VectorXd> u(leaf.displacement.data(),
                                            static_cast<Eigen::Index>(leaf.displacement.size()));
  const auto mean = block.mean_motion.of(u);
  numbers.insert(numbers.end(), mean.begin(), mean.end());
  return numbers;
}

void SignPatternTree::report_open(const Node& node) {
  const Evidence evidence{.kind = Evidence::Kind::marginal,
                          .block = node.block,
                          .node = in_whole(node.pattern, blocks_[node.block].candidates),
                          .numbers = {}};
  if (!judge_ || !judge_(evidence)) ++tally_.unproved;
  if (recorder_) recorder_(evidence);
}

}  // namespace kusabi::wedged
