// Opening of a node: bound, descent and branching.
#include "nodes/limit/search/sign_tree.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>

#include "engine/search.hpp"

namespace kusabi::limit {
namespace {

/// Rounds of cuts at a node below the root: the first ones bring most.
constexpr int rounds_per_node = 4;

/// A cut is made where the violation of the point exceeds this, and kept if the cut is violated by
/// more.
constexpr double min_violation = 1e-7;

/// Signs are not branched on where the violation is below this: the bound is then exact up to less
/// than the gap that closes a node.
constexpr double negligible_violation = 1e-10;

/// Reduction of the yield forces at a corner whose factor is `far_above` the least one known: its
/// proof needs no accuracy, and with more room it is found at once. Members elongate by less than
/// 500 in total, where the collapse dissipates about one.
constexpr double room_far_above = 1e-8;
constexpr double far_above = 1e-4;

std::vector<double> numbers(const Eigen::VectorXd& vector) {
  return {vector.begin(), vector.end()};
}

}  // namespace

ClosedNode closed_node(const StaticProof& proof, std::vector<StaticCut> own_cuts) {
  return {
      proof.signs,        proof.factor, numbers(proof.forces), proof.mu, numbers(proof.one_sided),
      std::move(own_cuts)};
}

SignTree::SignTree(const problems::LimitModel& model, double alpha, const RootResult& root,
                   bool keep_evidence, support::Stop stop, NoFactorProof proof)
    : model_(model),
      alpha_(alpha),
      root_(root),
      keep_evidence_(keep_evidence),
      stop_(std::move(stop)),
      proof_(std::move(proof)),
      load_factor_(model, stop_),
      states_(model, stop_),
      pricing_(model, stop_),
      master_(model, alpha, stop_) {
  for (const StaticCut& cut : root.cuts) master_.add(cut);
  load_factor_.start_from(root.nominal_basis);  // of every descent
}

SignTree::Node SignTree::root() const {
  return {Signs(model_.uncertain.size(), 0)};
}

SignTree::Tally SignTree::tally() const {
  Tally tally = tally_;
  tally.counts.load_factors += load_factor_.solves();
  tally.counts.relaxations = master_.solves();
  return tally;
}

// Nothing if the simplex method fails or is stopped.
std::optional<SignTree::Bounded> SignTree::bounded(const Node& node) {
  master_.drop_cuts_from(root_.cuts.size());
  own_cuts_.clear();
  master_.set_basis(root_.basis);
  master_.decide(node.signs);
  Bounded result;
  for (int round = 0;; ++round) {
    if (!master_.solve()) return {};
    result.bound = master_.objective();
    result.point = master_.relaxed();
    if (round == rounds_per_node) return result;
    const Eigen::VectorXd violations = violations_at(model_, result.point);
    std::vector<int> columns;
    for (int j = 0; j < model_.uncertain_count(); ++j) {
      if (violations(j) > min_violation) columns.push_back(j);
    }
    bool any = false;
    tally_.counts.pricings += columns.size();
    for (auto& cut : price_alone(pricing_, pricing_aim(result.point.z, 0), columns)) {
      if (result.point.gamma(cut.column) - cut.bound(result.point.z) < min_violation) continue;
      master_.add(cut);
      own_cuts_.push_back(std::move(cut));
      any = true;
    }
    if (!any) return result;
    ++tally_.counts.rounds;
  }
}

// Reports that a load has no factor, if the motion proves it. @return whether it does
bool SignTree::report_no_factor(const Eigen::VectorXd& zeta, const Eigen::VectorXd& motion,
                                engine::Expansion<SignTree>& out) {
  if (proof_ && !proof_(zeta, motion)) return false;
  out.solution({-linear::infinity, numbers(zeta), numbers(motion), {}});
  return true;
}

// Smaller improvements would make the answer depend on the number of ranks.
void SignTree::report(const Worst& worst, engine::Expansion<SignTree>& out) {
  const auto& [zeta, collapse] = worst;
  if (collapse.factor >= root_.worst->collapse.factor - closed_gap ||
      out.ruled_out(collapse.factor)) {
    return;
  }
  out.solution(
      {collapse.factor, numbers(zeta), numbers(collapse.motion), numbers(collapse.forces)});
}

// @return the least factor found here
double SignTree::descend_from(const Bounded& node, engine::Expansion<SignTree>& out) {
  const double known = std::min(out.cutoff(), root_.worst->collapse.factor);
  const Eigen::VectorXd plus = Eigen::VectorXd::Zero(model_.uncertain_count());
  load_factor_.restart();
  const auto found =
      descend(model_, load_factor_, alpha_, worst_for(model_, alpha_, node.point.motion, plus));
  if (found.status == LoadStatus::not_carried) {
    const bool shown = report_no_factor(found.overpowering_load, found.overpowering_motion, out);
    return shown ? -linear::infinity : known;
  }
  if (found.status != LoadStatus::collapses) return known;
  report(found.worst, out);
  return std::min(known, found.worst.collapse.factor);
}

void SignTree::close(const Signs& signs) {
  ++tally_.closed;
  if (!keep_evidence_) return;
  if (master_.solve_with_margin(first_room)) {
    tally_.evidence.push_back(closed_node(master_.proof(), own_cuts_));
  } else {
    tally_.evidence.push_back({signs, 0, {}, {}, {}, own_cuts_});
  }
}

void SignTree::branch_on(std::size_t column, bool positive_first, const Node& node,
                         engine::Expansion<SignTree>& out) {
  ++tally_.branched;
  for (const bool same : {true, false}) {
    Node child{node.signs};
    child.signs[column] = same == positive_first ? std::int8_t{1} : std::int8_t{-1};
    out.branch(std::move(child));
  }
}

// Branches without a bound. The first corner below a node is the nearest to the worst load known at
// the root.
void SignTree::divide(const Node& node, engine::Expansion<SignTree>& out) {
  const int j = first_undecided(model_, alpha_, node.signs);
  branch_on(static_cast<std::size_t>(j), root_.worst->zeta(j) >= 0, node, out);
}

// The proof of a corner: a state that needs only as little room as its factor is near to the least
// one known.
std::optional<StaticProof> SignTree::corner_proof(const Signs& signs) {
  states_.start_from(root_.nominal_basis);
  const double far = root_.worst->collapse.factor + far_above;
  for (const double room : {room_far_above, first_room}) {
    ++tally_.counts.load_factors;
    auto proof = proof_of_corner(states_, model_, alpha_, {}, signs, room, false);
    if (room == first_room || (proof && proof->factor >= far)) return proof;
  }
  return {};
}

// The factor of the corner's load is found by the program of its proof, whose yield forces are
// reduced; its collapse is of interest only if no smaller factor is known.
void SignTree::open_corner(Node&& node, engine::Expansion<SignTree>& out) {
  if (out.ruled_out(-linear::infinity)) return;
  const auto proof = corner_proof(node.signs);
  const double known = root_.worst->collapse.factor - closed_gap;
  const bool is_of_interest = !proof || (proof->factor < known && !out.ruled_out(proof->factor));
  Eigen::VectorXd zeta = corner_load(alpha_, node.signs);
  auto status = LoadStatus::collapses;
  if (is_of_interest) {
    load_factor_.restart();
    status = load_factor_.solve(dead_load(model_, zeta));
  }
  if (support::is_requested(stop_)) {
    out.branch(std::move(node));
    return;
  }
  ++tally_.closed;
  ++tally_.corners;
  if (status == LoadStatus::undetermined) ++tally_.unsolved;
  if (status == LoadStatus::not_carried)
    report_no_factor(zeta, load_factor_.overpowering_motion(), out);
  if (is_of_interest && status == LoadStatus::collapses)
    report({std::move(zeta), load_factor_.collapse()}, out);
  if (!keep_evidence_) return;
  tally_.evidence.push_back(proof ? closed_node(*proof, {})
                                  : ClosedNode{node.signs, 0, {}, {}, {}, {}});
}

void SignTree::open_relaxed(Node&& node, engine::Expansion<SignTree>& out) {
  const auto found = bounded(node);
  // A stopped search keeps the node, since its bound is incomplete.
  if (support::is_requested(stop_)) {
    out.branch(std::move(node));
    return;
  }
  if (!found) {
    divide(node, out);
    return;
  }
  const Bounded& here = *found;
  const double known = descend_from(here, out);
  const Eigen::VectorXd violations = violations_at(model_, here.point);
  Eigen::Index widest = 0;
  const double maximum = violations.size() == 0 ? 0 : violations.maxCoeff(&widest);
  if (here.bound >= known - closed_gap || maximum <= negligible_violation) {
    close(node.signs);
    return;
  }
  const auto j = static_cast<std::size_t>(widest);
  branch_on(j, model_.uncertain[j].along(here.point.motion) >= 0, node, out);
}

void SignTree::expand(Node&& node, engine::Expansion<SignTree>& out) {
  const int undecided = undecided_count(model_, alpha_, node.signs);
  if (undecided == 0) {
    open_corner(std::move(node), out);
  } else if (undecided <= root_.enumerated) {
    divide(node, out);
  } else {
    open_relaxed(std::move(node), out);
  }
}

}  // namespace kusabi::limit

template kusabi::engine::OutcomeOf<kusabi::limit::SignTree> kusabi::engine::search(
    kusabi::limit::SignTree&, kusabi::engine::Transport&, const kusabi::engine::Options&);
