// Signs of nodes under load, and branching.
#include "nodes/wedged/hold/hold_tree.hpp"

#include <algorithm>
#include <utility>

#include "problems/wedged/problem_block.hpp"

namespace kusabi::wedged {

using support::IndexSet;

namespace {

/// As CriticalFriction::tolerances: t* near a limit is a small multiple of the distance from it.
constexpr conic::Tolerances hold_tolerances{.sign = 1e-14, .value = 1e-15, .iterations = 100};

}  // namespace

HoldNodes::HoldNodes(const LoadedProblem& loaded, std::span<const LoadShare> shares, double mu,
                     Precision precision)
    : all_(problems::all_candidates(loaded.problem)),
      loaded_(&loaded),
      problem_(with_loads(loaded, shares)),
      rule_(loaded.problem, friction_with_loads(loaded.problem, mu, 0), Branching::relative),
      solver_(problem_, friction_with_loads(loaded.problem, mu, shares.size()), hold_tolerances,
              precision, static_cast<int>(shares.size())) {
  // If the file has a dead part, only combinations with it are states of the file.
  const bool dead = std::ranges::any_of(shares, [](const auto& share) { return share.dead != 0; });
  for (const LoadShare& share : shares) {
    const int number = all_.size() + static_cast<int>(scales_.size());
    if (!dead || share.dead != 0) acting_.insert(number);
    scales_.push_back(scale_of(loaded, share));
  }
}

void HoldNodes::set_friction(double mu) {
  solver_.set_friction(friction_with_loads(loaded_->problem, mu, scales_.size()));
}

HoldSign HoldNodes::sign(const LoadedPattern& node) {
  ++programs_;
  const bool leaf = (node.contact | node.separated) == all_;
  if (scales_.empty() && node.separated == all_) return HoldSign::infeasible;
  const auto answer = solver_.solve(node.contact, node.separated, {});
  iterations_ += static_cast<std::uint64_t>(answer.iterations);
  if (answer.sign == conic::Sign::infeasible) return HoldSign::infeasible;
  if (answer.sign == conic::Sign::feasible) return leaf ? HoldSign::feasible : HoldSign::open;
  return conic::is_resolved_tie(answer, hold_tolerances) ? tie(node, answer.upper) : HoldSign::open;
}

// Some candidate of U has no reaction: all states are also those of the node with it in R.
HoldSign HoldNodes::tie(const LoadedPattern& node, double upper) {
  const auto inside = solver_.relative_interior(node.contact, node.separated);
  if (!inside) return HoldSign::open;
  if (inside->loaded.empty() && upper < 0) return HoldSign::infeasible;
  const bool acts = scales_.empty() ? !inside->loaded.empty() : inside->loaded.meets(acting_);
  if (!acts) return HoldSign::nothing;
  const IndexSet loaded = inside->loaded & all_;
  const bool leaf = (node.contact | node.separated) == all_;
  if (leaf && !loaded.includes(node.contact)) return HoldSign::face;
  if (!loaded.includes(node.contact) || loaded.meets(inside->moved)) return HoldSign::open;
  return HoldSign::limit;
}

LoadedLeaf HoldNodes::leaf(const LoadedPattern& pattern) const {
  LoadedLeaf leaf{.pattern = pattern, .amounts = {}, .reaction = {}};
  const Eigen::VectorXd& r = solver_.reaction();
  const Eigen::Index own = solver_.normal(all_.size());
  leaf.reaction.assign(r.begin(), r.begin() + own);
  for (std::size_t j = 0; j < scales_.size(); ++j)
    leaf.amounts.push_back(r[solver_.normal(all_.size() + static_cast<int>(j))] / scales_[j]);
  return leaf;
}

void HoldTree::expand(Node&& node, engine::Expansion<HoldTree>& out) {
  pollable_.within(out, node, [&] {
    open(node, out);
    return true;
  });
}

void HoldTree::open(const Node& node, engine::Expansion<HoldTree>& out) {
  const HoldSign sign = nodes_.sign(node);
  const IndexSet free = nodes_.all() - (node.contact | node.separated);
  switch (sign) {
    case HoldSign::infeasible:
      ++tally_.infeasible;
      return;
    case HoldSign::feasible:
      out.solution(nodes_.leaf(node));
      return;
    case HoldSign::limit:
      tally_.limits.push_back(nodes_.leaf(node));
      return;
    case HoldSign::nothing:
    case HoldSign::face:
      ++tally_.computed;
      return;
    case HoldSign::open:
      break;
  }
  if (free.empty()) {
    ++tally_.undecided;
    return;
  }
  ++tally_.branched;
  const IndexSet own = IndexSet::single(nodes_.candidate(free));
  out.branch({node.contact | own, node.separated});
  out.branch({node.contact, node.separated | own});
}

}  // namespace kusabi::wedged
