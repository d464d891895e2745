// How a node is bounded by a friction coefficient, and what becomes of a leaf.
#include "nodes/wedged/critical_tree.hpp"

#include <algorithm>
#include <cmath>

namespace kusabi::wedged {
namespace {

// Bounds are compared with points of the grid, relatively: a product of two numbers is rounded.
constexpr double rounding = 1e-15;

}  // namespace

CriticalTree::Block::Block(const problems::WedgedProblem& problem, double width)
    : critical(problem, width),
      candidates(problems::all_candidates(problem)),
      rule(problem, std::vector<double>(problem.contact_names.size(), 1), Branching::relative) {}

CriticalTree::CriticalTree(const problems::WedgedProblem& problem, double width, std::int64_t most)
    : width_(width), most_(most) {
  for (const auto& candidates : problems::blocks_of(problem))
    blocks_.emplace_back(problems::block_problem(problem, candidates), width);
}

CriticalTree::Tally CriticalTree::tally() const {
  auto tally = tally_;
  for (const Block& block : blocks_) tally.programs += block.critical.programs();
  return tally;
}

CriticalTree::Node CriticalTree::root() const {
  return {.place = {.block = blocks_.size() == 1 ? 0 : PatternNode::all_blocks, .pattern = {}},
          .bound = 0};
}

void CriticalTree::expand(Node&& node, engine::Expansion<CriticalTree>& out) {
  if (node.place.block == PatternNode::all_blocks) {
    for (std::uint32_t block = 0; block < blocks_.size(); ++block)
      out.branch({{.block = block, .pattern = {}}, 0});
    return;
  }
  Block& block = blocks_[node.place.block];
  const auto& [contact, separated, at_rest] = node.place.pattern;
  if (separated == block.candidates) {  // no reaction at all
    ++tally_.dead;
    return;
  }
  const double most = block.critical.at(most_);
  const double cutoff = std::min(out.cutoff(), most);
  const double bound = block.critical.bound(node.place.pattern, node.bound, cutoff);
  // What is dead at the lower end of the best cell has nothing to add to the bracket.
  const double lowest = out.cutoff() - width_;
  if (bound > cutoff || bound >= lowest + rounding * std::abs(lowest)) {
    ++tally_.dead;
    return;
  }
  const auto free = block.candidates - (contact | separated);
  if (free.empty()) return close_leaf({node.place, bound}, out);
  ++tally_.branched;
  // By the point at the last coefficient of the bound.
  const auto& solver = block.critical.solver();
  const auto split = support::IndexSet::single(
      block.rule.most_violated(free, [&solver](int i) { return solver.violation(i); }));
  out.branch({{node.place.block, {contact | split, separated, {}}}, bound});
  out.branch({{node.place.block, {contact, separated | split, {}}}, bound});
}

void CriticalTree::close_leaf(const Node& node, engine::Expansion<CriticalTree>& out) {
  auto& critical = blocks_[node.place.block].critical;
  const auto known = static_cast<std::int64_t>(node.bound / width_);
  const auto cell = critical.locate(node.place.pattern, {known, CriticalCell::nowhere},
                                    CriticalMethod::newton, most_);
  if (cell.dead >= most_) {
    ++tally_.dead;
    return;
  }
  if (cell.alive == CriticalCell::nowhere || cell.alive - cell.dead > 1) {
    ++tally_.doubtful;
    tally_.doubt += {critical.at(cell.dead)};
  }
  if (cell.alive == CriticalCell::nowhere) return;
  ++tally_.leaves;
  out.solution({cell});
}

}  // namespace kusabi::wedged
