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
      pricing_(model, stop_),
      master_(model, alpha, stop_) {
  for (const StaticCut& cut : root.cuts) master_.add(cut);
  load_factor_.solve(model.dead);  // initial basis of every descent
}

SignTree::Node SignTree::root() const {
  return {Signs(model_.uncertain.size(), 0)};
}

SignTree::Tally SignTree::tally() const {
  Tally tally = tally_;
  tally.counts.load_factors = load_factor_.solves();
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

// @return the least factor found here
double SignTree::descend_from(const Bounded& node, engine::Expansion<SignTree>& out) {
  const double known = std::min(out.cutoff(), root_.worst->collapse.factor);
  const Eigen::VectorXd plus = Eigen::VectorXd::Zero(model_.uncertain_count());
  load_factor_.restart();
  const auto found =
      descend(model_, load_factor_, alpha_, worst_for(model_, alpha_, node.point.motion, plus));
  if (found.status == LoadStatus::not_carried) {
    if (proof_ && !proof_(found.overpowering_load, found.overpowering_motion)) return known;
    out.solution({-linear::infinity,
                  numbers(found.overpowering_load),
                  numbers(found.overpowering_motion),
                  {}});
    return -linear::infinity;
  }
  if (found.status != LoadStatus::collapses) return known;
  // Smaller improvements would make the answer depend on the number of ranks.
  const double worst = found.worst.collapse.factor;
  if (worst < root_.worst->collapse.factor - closed_gap && worst < out.cutoff()) {
    const auto& [zeta, collapse] = found.worst;
    out.solution({worst, numbers(zeta), numbers(collapse.motion), numbers(collapse.forces)});
  }
  return std::min(known, worst);
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

// Branches on the first undecided sign; with none, the node is closed without a proof.
void SignTree::split_unsolved(const Node& node, engine::Expansion<SignTree>& out) {
  const auto open = std::ranges::find(node.signs, 0);
  if (open == node.signs.end()) {
    ++tally_.closed;
    ++tally_.unsolved;
    if (keep_evidence_) tally_.evidence.push_back({node.signs, 0, {}, {}, {}, {}});
    return;
  }
  ++tally_.branched;
  for (const std::int8_t sign : {std::int8_t{1}, std::int8_t{-1}}) {
    Node child{node.signs};
    child.signs[static_cast<std::size_t>(open - node.signs.begin())] = sign;
    out.branch(std::move(child));
  }
}

void SignTree::expand(Node&& node, engine::Expansion<SignTree>& out) {
  const auto found = bounded(node);
  // A stopped search keeps the node, since its bound is incomplete.
  if (support::is_requested(stop_)) {
    out.branch(std::move(node));
    return;
  }
  if (!found) {
    split_unsolved(node, out);
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
  ++tally_.branched;
  const auto j = static_cast<std::size_t>(widest);
  const bool positive = model_.uncertain[j].along(here.point.motion) >= 0;
  for (const bool same : {true, false}) {
    Node child{node.signs};
    child.signs[j] = same == positive ? std::int8_t{1} : std::int8_t{-1};
    out.branch(std::move(child));
  }
}

}  // namespace kusabi::limit

template kusabi::engine::OutcomeOf<kusabi::limit::SignTree> kusabi::engine::search(
    kusabi::limit::SignTree&, kusabi::engine::Transport&, const kusabi::engine::Options&);
