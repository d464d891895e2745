// Bounding, closing and splitting of nodes of the zero-one tree.
#include "nodes/zero_one/tree.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

#include "engine/search.hpp"

namespace kusabi::zero_one {
namespace {

using linear::LinearStatus;

// Parameters of look-ahead branching, measured on random programs (bench/history.md): more
// candidates or steps cost more linear programs than they save nodes.
constexpr std::size_t look_ahead_candidates = 8;
constexpr int look_ahead_steps = 15;
// Minimum rise of a bound in the product of both, in steps of the resolution.
constexpr double min_rise = 1;

// Tolerance below a grid point, relative to the grid's width: the bound is safe, but the costs that
// make the grid are rounded sums.
constexpr double grid_slack = 1e-6;

}  // namespace

// The best way to split a node, with the bounds of the children by look-ahead.
struct ZeroOneTree::Split {
  std::size_t binary = 0;
  std::array<double, 2> bound = {};
  std::array<linear::Basis, 2> basis = {};
  std::array<double, 2> rise = {};  // of the bound, before it is raised to the grid
};

ZeroOneTree::ZeroOneTree(ZeroOneRoot root, ZeroOneBranching branching)
    : root_(std::move(root)),
      branching_(branching),
      programs_before_(root_.relaxation.programs()),
      iterations_before_(root_.relaxation.iterations()) {}

ZeroOneNode ZeroOneTree::root() const {
  return {root_.relaxation.root(), root_.basis, root_.bound};
}

ZeroOneTally ZeroOneTree::tally() const {
  Tally tally = tally_;
  tally.programs = root_.relaxation.programs() - programs_before_;
  tally.iterations = root_.relaxation.iterations() - iterations_before_;
  return tally;
}

// A node pruned unopened has a bound that rounds to a step not below that of the optimum.
double ZeroOneTree::lower_bound(double outcome_bound, const Tally& total) const {
  if (!std::isfinite(outcome_bound)) return std::min(outcome_bound, total.least_bound.value);
  constexpr double half = 0.5 * (1 + 1e-9);
  const double half_step = half * step_width(outcome_bound);
  if (in_steps(total.least_bound.value) < outcome_bound) return total.least_bound.value;
  return raised(outcome_bound - half_step);
}

// If objectives lie on a grid, a bound between two of its points is raised to the upper one.
double ZeroOneTree::raised(double bound) const {
  if (root_.grid == 0 || !std::isfinite(bound)) return bound;
  const double constant = root_.relaxation.program().constant;
  const double steps = std::ceil((bound - constant) / root_.grid - grid_slack);
  using linear::rounded::product_down;
  using linear::rounded::sum_down;
  const double on_it = sum_down(constant, product_down(steps, root_.grid));
  return std::max(bound, sum_down(on_it, -root_.grid_error));
}

bool ZeroOneTree::worse_than_root_point(double bound) const {
  return root_.point && in_steps(raised(bound)) > in_steps(root_.point->objective);
}

// The free binaries, those furthest from 0 and 1 in the last solve first; of equal ones the first,
// such that the tree is the same everywhere.
std::vector<std::size_t> ZeroOneTree::free_binaries(const Node& node) const {
  std::vector<std::pair<double, std::size_t>> list;
  for (std::size_t k = 0; k < root_.relaxation.binaries(); ++k) {
    if (!node.fixings.free(k)) continue;
    const double at = root_.relaxation.value(k);
    list.emplace_back(-at * (1 - at), k);
  }
  std::sort(list.begin(), list.end());
  std::vector<std::size_t> binaries;
  binaries.reserve(list.size());
  for (const auto& [order, k] : list) binaries.push_back(k);
  return binaries;
}

void ZeroOneTree::expand(Node&& node, Out& out) {
  if (root_.point && node.fixings == root_.relaxation.root()) out.solution(*root_.point);
  for (;;) {
    if (settle(node, out)) return;
    const double bound = root_.relaxation.bound();
    fix_by_reduced_cost(node);
    const auto free = free_binaries(node);
    const bool whole = std::all_of(free.begin(), free.end(), [this](std::size_t k) {
      const double at = root_.relaxation.value(k);
      return std::min(at, 1 - at) <= integrality_tolerance;
    });
    if (whole) {
      if (close_if_whole(node, out)) return;
      // Rounding has changed the objective: branch on the binary that it changed most.
      branch(node, {free.front(), {node.bound, node.bound}, {node.basis, node.basis}}, true, out);
      return;
    }
    if (!root_.point && !root_.as_printed) try_rounding(node, out);
    if (branching_ == ZeroOneBranching::paper) {
      branch(node, {free.front(), {node.bound, node.bound}, {node.basis, node.basis}}, true, out);
      return;
    }
    if (const auto split = look_ahead(node, free, bound)) {
      branch(node, *split, split->rise[1] <= split->rise[0], out);
      return;
    }
  }
}

// Solves the relaxation.
// @return true if the node is closed by it, or split since it is undecided; otherwise the node has
//   the new bound and basis
bool ZeroOneTree::settle(Node& node, Out& out) {
  auto& relaxation = root_.relaxation;
  const double cutoff = out.cutoff();
  auto status =
      relaxation.solve(node.fixings, node.basis,
                       {.cutoff = std::isfinite(cutoff) ? cutoff + step_width(cutoff) : cutoff});
  if (status == LinearStatus::cut_off && !out.ruled_out(in_steps(raised(relaxation.bound())))) {
    status = relaxation.solve(node.fixings, node.basis);
  }
  if (status == LinearStatus::interrupted) {
    node.bound = std::max(node.bound, raised(relaxation.bound()));
    out.branch(std::move(node));  // unchanged: the search ends soon, and may be resumed from it
    return true;
  }
  if (status == LinearStatus::infeasible) {
    if (!relaxation.contradiction()) {
      close_without_proof(node);
    } else {
      ++tally_.infeasible;
    }
    return true;
  }
  if (status != LinearStatus::optimal && status != LinearStatus::cut_off) {
    const auto& fixings = node.fixings;
    for (std::size_t k = 0; k < relaxation.binaries(); ++k) {
      if (!fixings.free(k)) continue;
      branch(node, {k, {node.bound, node.bound}, {}}, true, out);
      return true;
    }
    close_without_proof(node);
    return true;
  }
  node.bound = std::max(node.bound, raised(relaxation.bound()));
  node.basis = relaxation.basis();
  if (!out.ruled_out(in_steps(node.bound))) return false;
  close(node, tally_.above);
  return true;
}

void ZeroOneTree::close(const Node& node, std::uint64_t& how) {
  ++how;
  tally_.least_bound += {node.bound};
}

// Only its bound is recorded.
void ZeroOneTree::close_without_proof(const Node& node) {
  close(node, tally_.unproved);
}

// Fixes all binaries of an optimum that are 0 or 1 within the tolerance exactly, and solves again.
bool ZeroOneTree::close_if_whole(const Node& node, Out& out) {
  const auto fixings = rounded_fixings(root_.relaxation, node.fixings);
  auto point = point_at(root_.relaxation, fixings, node.basis);
  const bool was_whole = fixings == node.fixings;
  if (!point) {
    if (!was_whole) return false;
    const auto status = root_.relaxation.status();
    if (status == LinearStatus::interrupted) {
      out.branch(Node(node));
    } else if (status == LinearStatus::infeasible && root_.relaxation.contradiction()) {
      ++tally_.infeasible;
    } else {
      close_without_proof(node);
    }
    return true;
  }
  const bool nothing_lost = in_steps(point->objective) <= in_steps(node.bound);
  out.solution(*std::move(point));
  if (was_whole || nothing_lost) {
    Node closed = node;
    // An exact point also gives a better bound.
    if (was_whole) closed.bound = std::max(closed.bound, raised(root_.relaxation.bound()));
    close(closed, tally_.leaves);
    return true;
  }
  ++tally_.points;
  return false;
}

// Reduced-cost fixing of binaries whose other value would bring the bound above the point known
// from the root. (The incumbent is not used, since the result of a node must not depend on the time
// when it is opened.)
void ZeroOneTree::fix_by_reduced_cost(Node& node) {
  if (!root_.point || root_.as_printed) return;
  for (std::size_t k = 0; k < root_.relaxation.binaries(); ++k) {
    if (!node.fixings.free(k)) continue;
    for (const bool at_one : {false, true}) {
      if (!worse_than_root_point(root_.relaxation.bound_if(k, !at_one))) continue;
      node.fixings.fix(k, at_one);
      ++tally_.held;
      break;
    }
  }
}

void ZeroOneTree::try_rounding(const Node& node, Out& out) {
  auto point =
      point_at(root_.relaxation, rounded_fixings(root_.relaxation, node.fixings), node.basis);
  if (!point) return;
  ++tally_.points;
  out.solution(*std::move(point));
}

// None if a binary had to be fixed: the node has then changed and is solved again.
std::optional<ZeroOneTree::Split> ZeroOneTree::look_ahead(
    Node& node, const std::vector<std::size_t>& candidates, double before) {
  auto& relaxation = root_.relaxation;
  linear::SolveLimits limits{.iterations = look_ahead_steps};
  if (root_.point) limits.cutoff = root_.point->objective + step_width(root_.point->objective);
  std::optional<Split> best;
  double maximum = -1;
  const double minimum = min_rise * step_width(before);
  bool fixed = false;
  const std::size_t count = std::min(candidates.size(), look_ahead_candidates);
  for (std::size_t i = 0; i < count; ++i) {
    Split split{candidates[i], {}, {}};
    std::array<bool, 2> closed{};
    for (const bool at_one : {false, true}) {
      const std::size_t side = at_one ? 1 : 0;
      Fixings fixings = node.fixings;
      fixings.fix(split.binary, at_one);
      const auto status = relaxation.solve(fixings, node.basis, limits);
      const bool failed = status == LinearStatus::failed || status == LinearStatus::unbounded ||
                          status == LinearStatus::interrupted;
      split.basis[side] = failed ? node.basis : relaxation.basis();
      split.bound[side] = std::max(node.bound, raised(relaxation.bound()));
      split.rise[side] = std::max(relaxation.bound() - before, minimum);
      closed[side] = (status == LinearStatus::infeasible && relaxation.contradiction()) ||
                     worse_than_root_point(split.bound[side]);
    }
    if (closed[0] || closed[1]) {
      node.fixings.fix(split.binary, closed[0]);
      ++tally_.held;
      fixed = true;
      if (closed[0] && closed[1]) break;
      continue;
    }
    const double score = split.rise[0] * split.rise[1];
    if (score > maximum) {
      maximum = score;
      best = std::move(split);
    }
  }
  if (fixed) return {};
  return best;
}

void ZeroOneTree::branch(const Node& node, const Split& split, bool one_first, Out& out) {
  ++tally_.branched;
  for (const bool at_one : {one_first, !one_first}) {
    const std::size_t side = at_one ? 1 : 0;
    Node child{node.fixings, split.basis[side], split.bound[side]};
    child.fixings.fix(split.binary, at_one);
    out.branch(std::move(child));
  }
}

}  // namespace kusabi::zero_one

template kusabi::engine::OutcomeOf<kusabi::zero_one::ZeroOneTree> kusabi::engine::search(
    kusabi::zero_one::ZeroOneTree&, kusabi::engine::Transport&, const kusabi::engine::Options&);
