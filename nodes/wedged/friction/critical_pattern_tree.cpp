// Nodes of the bisection: ranges of patterns, and cells of one pattern.
#include "nodes/wedged/friction/critical_pattern_tree.hpp"

#include <algorithm>
#include <utility>

#include "engine/search.hpp"
#include "problems/wedged/problem_block.hpp"

namespace kusabi::wedged {

CriticalPatternTree::CriticalPatternTree(const problems::WedgedProblem& problem, double width,
                                         std::vector<Pattern> patterns, std::int64_t start,
                                         CriticalMethod method, std::int64_t sections)
    : patterns_(std::move(patterns)),
      start_(start),
      method_(method),
      sections_(std::max<std::int64_t>(1, sections)) {
  for (const auto& candidates : problems::blocks_of(problem)) {
    critical_.emplace_back(problems::block_problem(problem, candidates), width);
    critical_.back().end_when(interruption_.stop());
  }
}

CriticalPatternTree::Tally CriticalPatternTree::tally() const {
  Tally tally;
  for (const auto& block : critical_) tally.programs += block.programs();
  return tally;
}

CriticalPatternTree::Node CriticalPatternTree::root() const {
  return {.first = 0, .count = static_cast<std::uint32_t>(patterns_.size()), .cell = {0, start_}};
}

void CriticalPatternTree::expand(Node&& node, engine::Expansion<CriticalPatternTree>& out) {
  if (node.count == 0) return;
  if (node.count > 1) {
    const auto half = node.count / 2;
    out.branch({node.first, half, node.cell});
    out.branch({node.first + half, node.count - half, node.cell});
    return;
  }
  const bool undivided = node.claimed && node.cell == CriticalCell{0, start_};
  if (patterns_[node.first].feasible && method_ == CriticalMethod::bisection && sections_ > 1 &&
      undivided)
    return begin(node, out);
  const auto work = interruption_.within(out, node, [&] { return locate(node); });
  if (!work || !*work) return;
  const auto& [cell, done] = **work;
  if (done)
    out.solution({node.first, cell});
  else
    out.branch({node.first, 1, cell});
}

std::optional<CriticalPatternTree::Located> CriticalPatternTree::locate(Node node) {
  const auto& [leaf, feasible] = patterns_[node.first];
  const auto& pattern = leaf.pattern;
  auto& critical = critical_[leaf.block];
  if (!feasible) {
    const CriticalCell unknown{0, CriticalCell::nowhere};
    return Located{critical.locate(pattern, unknown, CriticalMethod::newton, start_), true};
  }
  if (method_ == CriticalMethod::newton)
    return Located{critical.locate(pattern, node.cell, method_, start_), true};
  if (!node.claimed) {
    // The change is within the cell if the lower bound is infeasible and the upper one is not. A
    // numerically undecided upper bound belongs to this cell, which is then extended to a proved
    // feasible point.
    if (node.cell.infeasible > 0 && !critical.infeasible(pattern, node.cell.infeasible)) return {};
    if (node.cell.feasible < start_) {
      if (critical.infeasible(pattern, node.cell.feasible)) return {};
      node.cell = critical.feasible_from(pattern, node.cell, start_);
    }
  }
  const auto half = critical.halve(pattern, node.cell);
  return Located{half, half == node.cell || half.feasible - half.infeasible == 1};
}

void CriticalPatternTree::begin(const Node& node, engine::Expansion<CriticalPatternTree>& out) {
  const auto sections = std::min(sections_, start_);
  for (std::int64_t k = 0; k < sections; ++k) {
    out.branch({node.first, 1, {start_ * k / sections, start_ * (k + 1) / sections}, false});
  }
}

}  // namespace kusabi::wedged

template kusabi::engine::OutcomeOf<kusabi::wedged::CriticalPatternTree> kusabi::engine::search(
    kusabi::wedged::CriticalPatternTree&, kusabi::engine::Transport&,
    const kusabi::engine::Options&);
