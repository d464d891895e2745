// How a node is bounded by a friction coefficient, and what becomes of a leaf.
#include "nodes/critical_tree.hpp"

#include <algorithm>
#include <bit>

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
      dimension_(problem.dimension),
      candidates_(problem.contact_names.size() == 64
                      ? ~std::uint64_t{0}
                      : (std::uint64_t{1} << problem.contact_names.size()) - 1),
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
  const auto split = std::uint64_t{1} << static_cast<unsigned>(branching_candidate(node.pattern));
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
  const Eigen::VectorXd& r = critical_.reaction();
  const Eigen::VectorXd u = critical_.unit() * critical_.displacement();
  out.solution({node.pattern, cell, {r.begin(), r.end()}, {u.begin(), u.end()}});
}

// The candidate that violates complementarity most, at the last coefficient of the bound.
int CriticalTree::branching_candidate(const SignPattern& pattern) const {
  const auto open = candidates_ & ~(pattern.contact | pattern.separated);
  int best = std::countr_zero(open);
  double largest = -1;
  for (auto rest = open; rest != 0; rest &= rest - 1) {
    const int i = std::countr_zero(rest);
    const Eigen::Index normal = Eigen::Index{dimension_} * i;
    const double product = critical_.displacement()[normal] * critical_.reaction()[normal] *
                           weight_[static_cast<std::size_t>(i)];
    if (product > largest) {
      largest = product;
      best = i;
    }
  }
  return best;
}

}  // namespace kusabi::nodes
