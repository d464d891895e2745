// Bounds of nodes by friction coefficients, and treatment of leaves.
#include "nodes/wedged/critical/critical_tree.hpp"

#include <algorithm>
#include <cmath>

#include "engine/search.hpp"
#include "problems/wedged/problem_block.hpp"

namespace kusabi::wedged {
namespace {

// Relative tolerance for comparisons of bounds with points of the grid, which are rounded products.
constexpr double rounding = 1e-15;

}  // namespace

CriticalTree::Block::Block(const problems::WedgedProblem& problem, double width,
                           Precision precision)
    : critical(problem, width, precision),
      candidates(problems::all_candidates(problem)),
      rule(problem, std::vector<double>(problem.contact_names.size(), 1), Branching::relative) {}

CriticalTree::CriticalTree(const problems::WedgedProblem& problem, double width,
                           std::int64_t maximum, CriticalDirection direction, double known,
                           Precision precision)
    : grid_(width), maximum_(maximum), direction_(direction), known_(known) {
  for (const auto& candidates : problems::blocks_of(problem)) {
    blocks_.emplace_back(problems::block_problem(problem, candidates), width, precision);
    blocks_.back().critical.end_when(interruption_.stop());
  }
}

CriticalTree::Tally CriticalTree::tally() const {
  auto tally = tally_;
  for (const Block& block : blocks_) tally.programs += block.critical.programs();
  return tally;
}

CriticalTree::Node CriticalTree::root() const {
  return {.place = {.block = blocks_.size() == 1 ? 0 : PatternNode::all_blocks, .pattern = {}},
          .bound = known_};
}

void CriticalTree::expand(Node&& node, engine::Expansion<CriticalTree>& out) {
  interruption_.run(out, node, [&] { open(node, out); });
}

void CriticalTree::open(const Node& node, engine::Expansion<CriticalTree>& out) {
  if (node.place.block == PatternNode::all_blocks) {
    for (std::uint32_t block = 0; block < blocks_.size(); ++block)
      out.branch({{.block = block, .pattern = {}}, node.bound});
    return;
  }
  Block& block = blocks_[node.place.block];
  const auto& [contact, separated, inactive] = node.place.pattern;
  if (separated == block.candidates) {  // no reaction at all
    ++tally_.infeasible;
    return;
  }
  const auto free = block.candidates - (contact | separated);
  const auto& bounds = block.critical.bounds();
  if (!bounds.empty()) {
    if (excludes_all(bounds, contact, separated)) {
      ++tally_.infeasible;
      return;
    }
    if (const auto known = one_sided(free, bounds)) return split(node, *known, out);
  }
  const auto bound = bound_of(block, node, std::min(out.cutoff(), block.critical.at(maximum_)));
  if (!bound) {
    ++tally_.infeasible;
    return;
  }
  if (free.empty()) return close_leaf({node.place, *bound}, out);
  // Branching uses the solution at the last coefficient.
  split({node.place, *bound}, block.rule.candidate(free, block.critical.solver()), out);
}

void CriticalTree::split(const Node& node, int candidate, engine::Expansion<CriticalTree>& out) {
  ++tally_.branched;
  const auto own = support::IndexSet::single(candidate);
  const auto& [contact, separated, inactive] = node.place.pattern;
  out.branch({{node.place.block, {contact | own, separated, {}}}, node.bound});
  out.branch({{node.place.block, {contact, separated | own, {}}}, node.bound});
}

std::optional<double> CriticalTree::bound_of(Block& block, const Node& node, double cutoff) const {
  // Nodes infeasible at the lower bound of the best cell cannot improve the bracket.
  const double maximum = block.critical.at(maximum_);
  const double lowest = cutoff < maximum ? cutoff - grid_.width() : maximum;
  const auto is_worth = [&](double bound) {
    return bound <= cutoff && bound < lowest + rounding * std::abs(lowest);
  };
  double bound = node.bound;
  if (direction_ == CriticalDirection::up)
    bound = block.critical.bound(node.place.pattern, bound, cutoff);
  else if (is_worth(bound))
    bound = std::max(bound, block.critical.infeasible_below(node.place.pattern, lowest));
  return is_worth(bound) ? std::optional(bound) : std::nullopt;
}

void CriticalTree::close_leaf(const Node& node, engine::Expansion<CriticalTree>& out) {
  auto& critical = blocks_[node.place.block].critical;
  const auto known = static_cast<std::int64_t>(node.bound / grid_.width());
  const auto cell = critical.locate(node.place.pattern, {known, CriticalCell::nowhere},
                                    CriticalMethod::newton, maximum_);
  if (cell.infeasible >= maximum_) {
    ++tally_.infeasible;
    return;
  }
  if (cell.feasible == CriticalCell::nowhere || cell.feasible - cell.infeasible > 1) {
    ++tally_.undecided;
    tally_.undecided_from += {critical.at(cell.infeasible)};
  }
  if (cell.feasible == CriticalCell::nowhere) return;
  ++tally_.leaves;
  out.solution({cell, node.place});
}

}  // namespace kusabi::wedged

template kusabi::engine::OutcomeOf<kusabi::wedged::CriticalTree> kusabi::engine::search(
    kusabi::wedged::CriticalTree&, kusabi::engine::Transport&, const kusabi::engine::Options&);
