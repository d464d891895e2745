// Exact decisions by the trees of nodes/wedged/tree and the test of verify/wedged.
#include "nodes/wedged/critical/bound_decisions.hpp"

#include <utility>

#include "engine/collectives.hpp"
#include "nodes/wedged/friction/critical_friction.hpp"
#include "nodes/wedged/tree/candidate_friction.hpp"
#include "nodes/wedged/tree/maximal_cones.hpp"
#include "nodes/wedged/tree/preparation.hpp"
#include "nodes/wedged/tree/sign_pattern_tree.hpp"
#include "problems/wedged/problem_block.hpp"
#include "problems/wedged/scale_ratio.hpp"

namespace kusabi::wedged {

BoundDecisions::BoundDecisions(engine::Analysis& analysis,
                               const problems::CheckedStructure& structure,
                               const problems::WedgedProblem& problem, Precision precision,
                               Tightening tightening, const BoundRecorder& recorder,
                               std::vector<CriticalCost>& costs)
    : analysis_(analysis),
      structure_(structure),
      problem_(problem),
      precision_(precision),
      tightening_(tightening),
      recorder_(recorder),
      costs_(costs),
      badly_scaled_(problem.modes.matrix.cols() > 0 &&
                    problems::scale_ratio(structure, problem) > max_safe_scale_ratio) {}

bool BoundDecisions::enclose() {
  if (!stiffness_) stiffness_ = enclosed_within(analysis_, structure_, enclosed_stiffness);
  return stiffness_.has_value();
}

bool BoundDecisions::is_exact() const {
  return stiffness_ && std::holds_alternative<verify::EnclosedProblem>(*stiffness_);
}

bool BoundDecisions::needs_bisection() const {
  return badly_scaled_ && precision_ == Precision::escalating && is_exact();
}

std::shared_ptr<const EvidenceCheck> BoundDecisions::check(
    std::span<const double> friction, std::span<const ProvedBound> bounds) const {
  const auto* const stiffness = std::get_if<verify::EnclosedProblem>(&*stiffness_);
  if (stiffness == nullptr) return nullptr;
  return std::make_shared<const EvidenceCheck>(
      problem_, *stiffness, friction, bounds,
      badly_scaled_ ? LargeDisplacements::counted : LargeDisplacements::left_out);
}

ExactNodeTest BoundDecisions::test(std::shared_ptr<const EvidenceCheck> check) const {
  return [badly_scaled = badly_scaled_, check = std::move(check)](const Evidence& evidence) {
    if (check) return check->proof(evidence);
    return !badly_scaled && evidence.kind != Evidence::Kind::no_claim ? NodeProof::complete
                                                                      : NodeProof::refused;
  };
}

std::function<bool(const Evidence&)> BoundDecisions::acceptance(
    std::shared_ptr<const EvidenceCheck> check) {
  return [this, proof_of = test(std::move(check))](const Evidence& evidence) {
    const auto proof = proof_of(evidence);
    leaves_out_ = leaves_out_ || proof == NodeProof::except_large_displacements;
    return proof != NodeProof::refused;
  };
}

conic::Tolerances BoundDecisions::tolerances() const {
  auto tolerances = CriticalFriction::tolerances;
  if (badly_scaled_) tolerances.resolution = exact_test_resolution;
  return tolerances;
}

bool BoundDecisions::roots_are_infeasible(double factor) {
  return analysis_.by_first_rank([&] {
    const auto friction = candidate_friction(problem_, factor);
    SignPatternTree tree(
        problem_, friction,
        {.tolerances = CriticalFriction::tolerances, .precision = Precision::doubles});
    tree.end_when(analysis_.budget().stop());
    const auto accepts = acceptance(check(friction));
    bool holds = true;
    tree.report_to([&](const auto& evidence) {
      holds = holds && evidence.kind == Evidence::Kind::infeasible && accepts(evidence);
    });
    const auto blocks = static_cast<std::uint32_t>(problems::blocks_of(problem_).size());
    try {
      for (std::uint32_t block = 0; block < blocks && holds; ++block) {
        const auto decision = tree.decide({.block = block, .pattern = {}});
        holds = holds && decision.children.empty() && !decision.leaf;
      }
    } catch (const support::Stopped&) {
      return false;
    }
    return holds;
  });
}

bool BoundDecisions::are_proved(std::span<const Evidence> claims, double factor) {
  return analysis_.by_first_rank([&] {
    return std::ranges::all_of(claims, acceptance(check(candidate_friction(problem_, factor))));
  });
}

DecidedLeaf BoundDecisions::leaf(const PatternNode& leaf, double factor, LeafRecord kind) {
  const auto friction = candidate_friction(problem_, factor);
  const auto record =
      kind == LeafRecord::none ? nullptr : recorder_(BracketSide::upper, factor, friction);
  const auto decide = [&] {
    DecidedLeaf decided;
    SignPatternTree tree(problem_, friction,
                         {.tolerances = tolerances(), .thorough = true, .precision = precision_});
    if (kind != LeafRecord::after_stop) tree.end_when(analysis_.budget().stop());
    const auto accepts = acceptance(check(friction));
    tree.report_to([&](const auto& evidence) {
      if (record) record->add(evidence);
      decided.holds = evidence.kind == Evidence::Kind::feasible && accepts(evidence);
      decided.degenerate = evidence.kind == Evidence::Kind::no_claim;
    });
    try {
      auto decision = tree.decide(leaf);
      if (decision.leaf) decided.found.push_back(std::move(*decision.leaf));
    } catch (const support::Stopped&) {
    }
    return decided;
  };
  // A record is written by one rank.
  auto decided = record ? engine::from_first_rank(analysis_.transport(), decide)
                        : analysis_.by_first_rank(decide);
  if (record) record->end({}, BoundClaim::one_pattern, decided.holds);
  costs_.push_back({CriticalPhase::upper_bound, factor, 1, 1});
  return decided;
}

DecidedTree BoundDecisions::tree(BracketSide side, double factor, CriticalPhase phase,
                                 const BoundRecorder& recorder,
                                 const std::function<bool(const DecidedTree&)>& wanted,
                                 std::uint64_t nodes) {
  const auto friction = candidate_friction(problem_, factor);
  const SignPatternOptions options{.tolerances = tolerances(),
                                   .tightening = tightening_,
                                   .thorough = true,
                                   .precision = precision_};
  SignPatternTree tree(problem_, friction, options);
  auto prepared = prepare(analysis_, problem_, friction, options);
  const auto exact = check(friction, proved_bounds(prepared));
  if (exact && exact->can_prove() && !exact->proves_bounds()) remove_bounds(prepared);
  configure(tree, prepared);
  const auto bounds = proved_bounds(prepared);
  const auto record = recorder ? recorder(side, factor, friction) : nullptr;
  tree.test_with(test(exact), badly_scaled_);
  // One feasible pattern proves an upper bound; other nodes may be marginal.
  const bool one_pattern = phase == CriticalPhase::upper_bound;
  if (record) {
    tree.report_to([&](const auto& evidence) {
      if (!one_pattern || evidence.kind == Evidence::Kind::feasible) record->add(evidence);
    });
  }
  engine::Options search;
  search.limits.nodes = nodes;
  // A record is written by one rank.
  auto outcome = record ? analysis_.search_anew(tree, search) : analysis_.search(tree, search);
  costs_.push_back({phase, factor, outcome.opened(), outcome.opened()});
  auto decided = engine::from_first_rank(analysis_.transport(), [&] {
    std::vector<Configuration> leaves;
    for (auto& found : outcome.solutions) leaves.push_back(std::move(found.solution));
    const auto tally = outcome.tally();
    return DecidedTree{.status = outcome.status,
                       .leaves = maximal_cones(std::move(leaves)),
                       .feasible = tally.proved,
                       .unproved = tally.closed_unproved + tally.unproved,
                       .except_large_displacements = tally.except_large_displacements > 0};
  });
  leaves_out_ = leaves_out_ || decided.except_large_displacements;
  if (!record) return decided;
  if (one_pattern)
    record->end({}, BoundClaim::one_pattern, decided.solved() && decided.feasible > 0);
  else
    record->end(bounds, BoundClaim::all_patterns, decided.solved() && wanted(decided));
  return decided;
}

}  // namespace kusabi::wedged
