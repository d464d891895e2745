// Signs of nodes under load, and branching.
#include "nodes/wedged/hold/hold_tree.hpp"

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include <Eigen/SVD>

#include "nodes/wedged/hold/rigid_contradiction.hpp"
#include "problems/wedged/problem_block.hpp"

namespace kusabi::wedged {

using support::IndexSet;

namespace {

/// Singular values of the rows of U below this part of the largest belong to modes that these do
/// not resist, as in solvers/conic/motion_bounds.cpp.
constexpr double not_resisted = 1e-10;

/// Parts of the largest normal reaction above which a candidate is suggested to be in contact: from
/// all with a reaction to those that carry the load.
constexpr std::array shares_in_contact{1e-9, 1e-5, 1e-4, 1e-3, 3e-3, 1e-2, 3e-2, 1e-1};

conic::SideEquation equation_of(const std::optional<GripRestriction>& grip) {
  if (!grip) return conic::SideEquation::none;
  return grip->kind == GripRestriction::Kind::equal ? conic::SideEquation::exact
                                                    : conic::SideEquation::with_slack;
}

}  // namespace

bool resists_all(const problems::WedgedProblem& problem, const support::IndexSet& contact,
                 double mu) {
  const Eigen::Index p = problem.modes.matrix.cols();
  const Eigen::Index d = problem.dimension;
  std::vector<Eigen::Index> rows;
  for (const int i : contact) {
    const bool rough = mu * problem.friction[static_cast<std::size_t>(i)] > 0;
    for (Eigen::Index axis = 0; axis < (rough ? d : 1); ++axis) rows.push_back(d * i + axis);
  }
  if (p == 0) return true;
  if (static_cast<Eigen::Index>(rows.size()) < p) return false;
  const Eigen::MatrixXd part = problem.modes.matrix(rows, Eigen::all);
  const auto values = Eigen::BDCSVD<Eigen::MatrixXd>(part).singularValues();
  return values[p - 1] > not_resisted * values[0];
}

HoldNodes::HoldNodes(const LoadedProblem& loaded, std::span<const LoadShare> shares, double mu,
                     Precision precision, const std::optional<GripRestriction>& grip)
    : all_(problems::all_candidates(loaded.problem)),
      shares_(shares.begin(), shares.end()),
      loads_(shares.size() + (grip && grip->kind != GripRestriction::Kind::equal ? 1 : 0)),
      equation_(equation_of(grip)),
      loaded_(&loaded),
      mu_(mu),
      precision_(precision),
      problem_(grip ? with_grip(loaded, shares, *grip) : with_loads(loaded, shares)),
      rule_(loaded.problem, friction_with_loads(loaded.problem, mu, 0), Branching::relative),
      solver_(problem_, friction_with_loads(loaded.problem, mu, loads_), hold_tolerances, precision,
              static_cast<int>(loads_), equation_),
      mean_motion_(loaded.problem),
      grip_unit_(grip ? 1 / grip_scale(loaded, shares, *grip) : 1) {
  // If the file has a dead part, only combinations with it are states of the file.
  const bool dead = std::ranges::any_of(shares, [](const auto& share) { return share.dead != 0; });
  for (const LoadShare& share : shares) {
    const int number = all_.size() + static_cast<int>(scales_.size());
    if (!dead || share.dead != 0) acting_.insert(number);
    scales_.push_back(scale_of(loaded, share));
  }
}

void HoldNodes::except_dead() {
  for (std::size_t j = 0; j < shares_.size(); ++j)
    if (shares_[j].dead != 1 || shares_[j].reference != 0)
      besides_dead_.insert(all_.size() + static_cast<int>(j));
}

void HoldNodes::set_friction(double mu) {
  mu_ = mu;
  solver_.set_friction(friction_with_loads(loaded_->problem, mu, loads_));
}

CandidateBounding HoldNodes::bounding() const {
  return {problem_, friction_with_loads(loaded_->problem, mu_, loads_), hold_tolerances,
          load_part(), mean_motion_};
}

void HoldNodes::tighten(std::vector<CandidateBounds> bounds) {
  solver_.make_room(static_cast<int>(bounds.size()));
  bounds_ = std::move(bounds);
}

// Nothing: the node is to be solved without cuts.
std::optional<HoldResult> HoldNodes::solve_with_cuts(const LoadedPattern& node) {
  one_sided_.reset();
  by_cuts_.reset();
  if (bounds_.empty()) return {};
  if (excludes_all(bounds_, node.contact, node.separated)) {
    if (wants_evidence_)
      by_cuts_.emplace(2 * bounds_.size() + static_cast<std::size_t>(mean_motion_.count()) +
                       (load_part().has_equation() ? 1 : 0));
    return HoldResult::infeasible;
  }
  const IndexSet free = all_ - (node.contact | node.separated);
  if (free.empty()) return {};
  one_sided_ = one_sided(free, bounds_);
  if (one_sided_) return HoldResult::unresolved;
  const auto cuts = cuts_of(free, bounds_);
  const auto answer = solver_.solve_with(cuts, node.contact, node.separated, {});
  iterations_ += static_cast<std::uint64_t>(answer.iterations);
  if (answer.sign == conic::Sign::infeasible) {
    if (wants_evidence_) by_cuts_ = cut_evidence(solver_, mean_motion_, cuts, load_part());
    return HoldResult::infeasible;
  }
  if (answer.sign == conic::Sign::feasible) return HoldResult::unresolved;
  return {};
}

HoldResult HoldNodes::solve(const LoadedPattern& node) {
  ++programs_;
  if (const auto known = solve_with_cuts(node)) return *known;
  const bool leaf = (node.contact | node.separated) == all_;
  if (scales_.empty() && node.separated == all_) {
    multipliers_ = Eigen::VectorXd::Zero(all_.size() + problem_.modes.matrix.cols());
    return HoldResult::infeasible;
  }
  const auto answer = solver_.solve(node.contact, node.separated, {});
  iterations_ += static_cast<std::uint64_t>(answer.iterations);
  multipliers_ = solver_.multipliers();
  if (answer.sign == conic::Sign::infeasible) return HoldResult::infeasible;
  if (answer.sign == conic::Sign::feasible)
    return leaf ? HoldResult::feasible : HoldResult::unresolved;
  return conic::is_unresolvable(answer, hold_tolerances) ? degenerate(node, answer.upper)
                                                         : HoldResult::unresolved;
}

// Some candidate of U has no reaction: all states are also those of the node with it in R.
HoldResult HoldNodes::degenerate(const LoadedPattern& node, double upper) {
  const auto inside = solver_.relative_interior(node.contact, node.separated);
  if (!inside) return HoldResult::unresolved;
  if (inside->loaded.empty() && upper < 0) return HoldResult::infeasible;
  const bool acts = scales_.empty()
                        ? !inside->loaded.empty()
                        : inside->loaded.meets(acting_) &&
                              (besides_dead_.empty() || inside->loaded.meets(besides_dead_));
  const IndexSet loaded = inside->loaded & all_;
  limited_to_ = inside->loaded & IndexSet::below(all_.size() + static_cast<int>(shares_.size()));
  if (!acts) return is_contradiction(node) ? HoldResult::infeasible : HoldResult::unloaded;
  const bool leaf = (node.contact | node.separated) == all_;
  if (leaf && !loaded.includes(node.contact)) return HoldResult::face;
  if (!loaded.includes(node.contact) || loaded.meets(inside->moved)) return HoldResult::unresolved;
  limit_ = {loaded, all_ - loaded};
  return HoldResult::at_limit;
}

bool HoldNodes::is_contradiction(const LoadedPattern& node) {
  const auto beta = rigid_contradiction(*loaded_, shares_, mu_, precision_,
                                        {limited_to_, all_ - (node.separated | limited_to_)});
  if (!beta) return false;
  multipliers_.setZero();
  multipliers_.tail(problem_.modes.matrix.cols()).head(beta->size()) = *beta;
  return true;
}

ClosedNode HoldNodes::closed(const LoadedPattern& node) const {
  if (by_cuts_) return {node, *by_cuts_, true};
  return {node, node_evidence(multipliers_, problem_.modes.matrix.cols(), solver_.unit(),
                              mean_motion_, load_part())};
}

std::array<double, 3> HoldNodes::works() const {
  const Eigen::Index m = all_.size();
  const Eigen::Index modes = mean_motion_.count();
  const Eigen::VectorXd y = multipliers_.head(m) / solver_.unit();
  const Eigen::VectorXd beta = multipliers_.tail(problem_.modes.matrix.cols()).head(modes);
  const auto& loads = loaded_->loads;
  Eigen::Index column = 0;
  const auto next = [&](bool present) {
    if (!present) return 0.0;
    const Eigen::VectorXd w = loads.displacements.col(column).cast<double>();
    double work = beta.dot(loads.motions.row(column).transpose().cast<double>());
    for (Eigen::Index i = 0; i < m; ++i) work += y[i] * w[solver_.dimension() * i];
    ++column;
    return work;
  };
  const double dead = next(loaded_->has_dead) + y.dot(loaded_->clearance);
  const double reference = next(loaded_->has_reference);
  return {dead, reference, next(loaded_->has_second)};
}

std::vector<double> HoldNodes::state_numbers(const LoadedPattern& pattern) const {
  const LoadedLeaf own = leaf(pattern);
  const double amount = own.amounts.empty() ? 1 : own.amounts.front();
  const double dead = shares_.empty() ? 0 : shares_.front().dead;
  const Eigen::Index d = solver_.dimension();
  std::vector<double> numbers;
  for (const int i : pattern.contact) {
    for (Eigen::Index axis = 1; axis < d; ++axis)
      numbers.push_back(own.reaction[static_cast<std::size_t>(d * i + axis)] / amount);
  }
  Eigen::VectorXd u = solver_.displacement().head(d * all_.size()) * (solver_.unit() / amount);
  for (int i = 0; i < all_.size(); ++i)
    u[d * i] = pattern.contact.contains(i) ? 0 : u[d * i] - dead * loaded_->clearance[i];
  const Eigen::VectorXd mean = mean_motion_.of(u);
  numbers.insert(numbers.end(), mean.begin(), mean.end());
  return numbers;
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

std::vector<LoadedPattern> HoldNodes::suggested(const LoadedPattern& node) const {
  if (!bounds_.empty()) return {};  // the tree without them has tried
  const IndexSet free = all_ - (node.contact | node.separated);
  double largest = 0;
  for (const int i : all_) largest = std::max(largest, solver_.normal_reaction(i));
  std::vector<LoadedPattern> leaves;
  for (const double share : shares_in_contact) {
    LoadedPattern leaf = node;
    for (const int i : free)
      (solver_.normal_reaction(i) > share * largest ? leaf.contact : leaf.separated).insert(i);
    if (leaves.empty() || !(leaf == leaves.back())) leaves.push_back(std::move(leaf));
  }
  return leaves;
}

void HoldTree::expand(Node&& node, engine::Expansion<HoldTree>& out) {
  interruption_.run(out, node, [&] { open(node, out); });
}

// The leaf of all states of a node can have t* > 0 although the node has not: in the node, free
// candidates whose reaction vanishes in all states are among C.
void HoldTree::take_limit(const Node& node, engine::Expansion<HoldTree>& out) {
  const LoadedPattern limit = nodes_.limit();
  LoadedLeaf leaf = nodes_.leaf(limit);
  const bool proved = node.contact.includes(limit.contact) && nodes_.is_contradiction(node);
  if (limit == node || nodes_.solve(limit) != HoldResult::feasible) {
    tally_.limits.push_back(std::move(leaf));
    return;
  }
  if (!proved) ++tally_.computed;  // that there are no other states
  out.solution(nodes_.leaf(limit));
}

// True if the point of the root suggests a leaf that has a state: one node in place of a path of
// as many as there are candidates.
bool HoldTree::take_suggested(const Node& node, engine::Expansion<HoldTree>& out) {
  for (const auto& leaf : nodes_.suggested(node)) {
    if (nodes_.solve(leaf) != HoldResult::feasible) continue;
    out.solution(nodes_.leaf(leaf));
    return true;
  }
  return false;
}

void HoldTree::open(const Node& node, engine::Expansion<HoldTree>& out) {
  const HoldResult result = nodes_.solve(node);
  const IndexSet free = nodes_.all() - (node.contact | node.separated);
  switch (result) {
    case HoldResult::infeasible:
      ++tally_.infeasible;
      if (reporter_) reporter_(nodes_.closed(node));
      return;
    case HoldResult::feasible:
      out.solution(nodes_.leaf(node));
      return;
    case HoldResult::at_limit:
      return take_limit(node, out);
    case HoldResult::face:
      ++(nodes_.is_contradiction(node) ? tally_.of_other_leaves : tally_.computed);
      return;
    case HoldResult::unloaded:
      ++tally_.computed;
      return;
    case HoldResult::unresolved:
      break;
  }
  const int candidate = free.empty() ? 0 : nodes_.candidate(free);
  const bool root = free == nodes_.all() && free.size() > 1;
  if (tries_suggested_ && root && take_suggested(node, out)) return;
  if (free.empty()) {
    ++(resists_all(nodes_.problem(), node.contact, nodes_.friction()) ? tally_.undecided
                                                                      : tally_.undecided_on_line);
    return;
  }
  ++tally_.branched;
  const IndexSet own = IndexSet::single(candidate);
  out.branch({node.contact | own, node.separated});
  out.branch({node.contact, node.separated | own});
}

}  // namespace kusabi::wedged
