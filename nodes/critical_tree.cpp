// How a node is bounded by a friction coefficient, and what becomes of a leaf.
#include "nodes/critical_tree.hpp"

#include <algorithm>

namespace kusabi::nodes {

CriticalTree::Tally& CriticalTree::Tally::operator+=(const Tally& other) {
  branched += other.branched;
  dead += other.dead;
  leaves += other.leaves;
  doubtful += other.doubtful;
  doubt = std::min(doubt, other.doubt);
  programs += other.programs;
  return *this;
}

CriticalTree::CriticalTree(const problems::WedgedProblem& problem, double width, std::int64_t most)
    : critical_(problem, width),
      candidates_(all_candidates(problem)),
      most_(most),
      weight_(branching_weights(problem, std::vector<double>(problem.contact_names.size(), 1),
                                Branching::relative)) {}

CriticalTree::Tally CriticalTree::tally() const {
  auto tally = tally_;
  tally.programs = critical_.programs();
  return tally;
}

void CriticalTree::expand(Node&& node, engine::Expansion<CriticalTree>& out) {
  if (node.pattern.separated == candidates_) {  // no reaction at all
    ++tally_.dead;
    return;
  }
  const double cutoff = std::min(out.cutoff(), critical_.at(most_));
  const double bound = critical_.bound(node.pattern, node.bound, cutoff);
  if (bound > cutoff) {
    ++tally_.dead;
    return;
  }
  if ((node.pattern.contact | node.pattern.separated) == candidates_)
    return close_leaf({node.pattern, bound}, out);
  ++tally_.branched;
  // By the point at the last coefficient of the bound.
  const auto free = candidates_ & ~(node.pattern.contact | node.pattern.separated);
  const int candidate =
      branching_candidate(free, weight_, [this](int i) { return critical_.solver().violation(i); });
  const auto split = std::uint64_t{1} << static_cast<unsigned>(candidate);
  out.branch({{node.pattern.contact | split, node.pattern.separated}, bound});
  out.branch({{node.pattern.contact, node.pattern.separated | split}, bound});
}

void CriticalTree::close_leaf(const Node& node, engine::Expansion<CriticalTree>& out) {
  const auto known = static_cast<std::int64_t>(node.bound / critical_.width());
  const auto cell =
      critical_.locate(node.pattern, {known, CriticalCell::nowhere}, CriticalMethod::newton, most_);
  if (cell.dead >= most_) {
    ++tally_.dead;
    return;
  }
  if (cell.alive == CriticalCell::nowhere) {
    ++tally_.doubtful;
    tally_.doubt = std::min(tally_.doubt, critical_.at(cell.dead));
    return;
  }
  ++tally_.leaves;
  critical_.probe(node.pattern, critical_.at(cell.alive));
  const auto& solver = critical_.solver();
  const Eigen::VectorXd& r = solver.reaction();
  const Eigen::VectorXd u = solver.unit() * solver.displacement();
  out.solution({node.pattern, cell, {r.begin(), r.end()}, {u.begin(), u.end()}});
}

}  // namespace kusabi::nodes
