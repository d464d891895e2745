// Proofs of single trees and states on the rank that records them, and of the conclusions on all.
#include "nodes/wedged/hold/exact_hold.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <utility>
#include <variant>

#include "engine/collectives.hpp"
#include "nodes/evidence/verified_structure.hpp"
#include "nodes/wedged/hold/block_hold.hpp"
#include "nodes/wedged/tree/evidence_check.hpp"
#include "problems/wedged/problem_block.hpp"
#include "verify/wedged/proof.hpp"

namespace kusabi::wedged {

using support::Standing;
using verify::contains;

namespace {

verify::LoadShare verified(const LoadShare& share) {
  return {.dead = share.dead, .reference = share.reference};
}

// True if no end has a wide bracket, relative to the larger number of both.
bool is_narrow(const HeldInterval& held) {
  if (held.low == held.high) return true;
  double size = 0;
  for (const double end : {held.low, held.high})
    if (std::isfinite(end)) size = std::max(size, std::abs(end));
  const auto near = [&](double end, double out) {
    return std::isinf(end) || std::abs(out - end) <= BlockHold::close_enough * size;
  };
  return near(held.low, held.low_out.value) && near(held.high, held.high_out.value);
}

verify::GripBound verified(const GripRestriction& grip) {
  using Bound = verify::GripBound::Kind;
  constexpr std::array kinds{Bound::above, Bound::below, Bound::equal};
  return {kinds.at(static_cast<std::size_t>(grip.kind)), grip.total};
}

}  // namespace

/// Evidence at one coefficient.
class ExactHold::Record final : public HoldRecord {
 public:
  Record(ExactHold& owner, HoldClaim claim, std::vector<double> friction,
         std::unique_ptr<HoldRecord> further)
      : owner_(owner), claim_(claim), certificate_(owner.header_), further_(std::move(further)) {
    certificate_.friction = std::move(friction);
    const auto& [problem, loads] = *owner.enclosure_;
    proof_.emplace(certificate_, problem.stiffness, problem.motions, loads);
    if (!proof_->min_eigenvalue()) proof_.reset();
  }

  bool tree(std::uint32_t block, const TreeEvidence& tree) override {
    verify::Theorem theorem{.block = block};
    for (const auto& share : tree.shares) theorem.shares.push_back(verified(share));
    if (tree.grip && !theorem.about_wedged()) theorem.grip = verified(*tree.grip);
    theorem.except_dead = tree.except_dead;
    theorem.weights = tree.weights;
    certificate_.theorems.push_back(std::move(theorem));
    proved_.theorems.push_back(false);
    if (!prove_bounds(tree)) return false;
    engine::Reduction own{.ranks = 1};
    for (const auto& node : tree.nodes.value()) {
      const auto result = proved_node(node);
      own.found += result.refusal ? 1 : 0;
      own.opened += result.except_large_displacements ? 1 : 0;
      own.closed += std::ldexp(1.0, -(node.pattern.contact | node.pattern.separated).size());
    }
    // The nodes, which are disjoint, cover all patterns if their shares of these add up to one.
    constexpr double whole = 1 - 1e-9;
    const auto all = engine::all_reduce(owner_.transport_, own);
    const bool proved = all.found == 0 && all.closed > whole;
    proved_.theorems.back() = proved;
    proved_.except_large_displacements = proved_.except_large_displacements || all.opened > 0;
    if (further_ && proved) further_->tree(block, tree);
    return true;
  }

  void state(std::uint32_t block, const std::optional<LoadShare>& share,
             const LoadedPattern& pattern, std::span<const double> numbers) override {
    verify::State state{.block = block,
                        .contact = pattern.contact,
                        .separated = pattern.separated,
                        .numbers = {numbers.begin(), numbers.end()}};
    if (share) state.share = verified(*share);
    const bool proved = proof_ && !proof_->refusal(state);
    proved_.states.push_back(proved);
    certificate_.states.push_back(std::move(state));
    if (further_ && proved) further_->state(block, share, pattern, numbers);
  }

  void finish() override {
    if (!proof_) return;
    auto conclusion = verify::conclude(certificate_, *proof_, proved_);
    if (conclusion.refusal) return;
    auto& claims = owner_.proved_[claim_] = std::move(*conclusion.loads);
    const bool proved = claim_ == HoldClaim::lower   ? contains(claims.none, 0, 0)
                        : claim_ == HoldClaim::upper ? contains(claims.held, 0, 0)
                                                     : !claims.held.empty() || !claims.none.empty();
    if (further_ && proved) further_->finish();
    if (proved_.except_large_displacements) {  // only states count
      claims.none.clear();
      claims.grip.below = 0;
      claims.grip.above.reset();
    }
  }

 private:
  // True if all bounds of the last theorem are proved.
  bool prove_bounds(const TreeEvidence& tree) {
    return !proof_ || std::ranges::all_of(tree.bounds, [&](const ProvedBound& bound) {
      return !proof_->add_bound(verified(bound, certificate_.theorems.size() - 1));
    });
  }

  [[nodiscard]] verify::ProofResult proved_node(const ClosedNode& node) const {
    if (!proof_) return {.refusal = "K is not enclosed"};
    return proof_->proof_result(
        {.claim = node.by_cuts ? verify::Claim::cut : verify::Claim::infeasible,
         .theorem = certificate_.theorems.size() - 1,
         .contact = node.pattern.contact,
         .separated = node.pattern.separated,
         .numbers = node.numbers});
  }

  ExactHold& owner_;
  HoldClaim claim_;
  verify::Certificate certificate_;
  std::unique_ptr<HoldRecord> further_;
  std::optional<verify::Proof> proof_;
  verify::Proved proved_;
};

ExactHold::ExactHold(engine::Transport& transport, const LoadedProblem& loaded,
                     const problems::Structure& structure, std::optional<double> total,
                     bool of_any_size, const support::LongWork& work)
    : transport_(transport), loaded_(loaded), header_(header_of(loaded.problem)) {
  header_.theorems.clear();
  header_.total = total;
  header_.loads.emplace().clearance = {loaded.clearance.begin(), loaded.clearance.end()};
  if (!any_modes() && !of_any_size) return;  // nothing is to be proved
  if (structure.coordinates.size() > max_enclosed_displacements && !of_any_size) return;
  auto enclosed = verify::enclosed_loads(evidence::verified_under_load(structure), work);
  if (auto* found = std::get_if<verify::LoadedEnclosure>(&enclosed)) enclosure_ = std::move(*found);
}

void ExactHold::note_statics(HoldParameters& parameters) const {
  if (!can_prove()) return;
  const auto& loads = enclosure_->loads;
  const auto none = verify::out_of_equilibrium(loads[0].work, loads[1].work);
  parameters.dead_out_of_equilibrium = contains(none, 0, 0);
  parameters.never_in_equilibrium = contains(none, -unbounded_end, unbounded_end);
}

std::unique_ptr<HoldRecord> ExactHold::record(HoldClaim claim, double mu,
                                              std::unique_ptr<HoldRecord> further) {
  proved_.erase(claim);
  auto friction = friction_with_loads(loaded_.problem, mu, 0);
  return std::make_unique<Record>(*this, claim, std::move(friction), std::move(further));
}

const verify::HoldClaims* ExactHold::claims(HoldClaim claim) const {
  const auto found = proved_.find(claim);
  return found == proved_.end() ? nullptr : &found->second;
}

bool ExactHold::proves_factors() const {
  const auto* const known = claims(HoldClaim::factors);
  return known != nullptr && (!known->held.empty() || !known->none.empty());
}

void ExactHold::set_standings(HeldFactors& found) const {
  if (!any_modes()) return;
  const auto* const known = claims(HoldClaim::factors);
  const auto held = [&](double low, double high) {
    return support::proved_if(known != nullptr && contains(known->held, low, high));
  };
  const auto none = [&](double low, double high) {
    return support::proved_if(low > high || (known != nullptr && contains(known->none, low, high)));
  };
  auto outside = Standing::proved;
  bool narrow = true;
  double below = -unbounded_end;  // the end of the interval before
  for (std::size_t k = 0; k < found.intervals.size(); ++k) {
    auto& each = found.intervals[k];
    each.standing = held(each.low, each.high);
    // At a closed end without a bracket there is a state.
    const double low_out = each.low_out.value == each.low ? std::nextafter(each.low, -unbounded_end)
                                                          : each.low_out.value;
    const double high_out = each.high_out.value == each.high
                                ? std::nextafter(each.high, unbounded_end)
                                : each.high_out.value;
    each.low_out.standing = std::isinf(each.low) ? each.standing : none(below, low_out);
    below = high_out;
    const bool last = k + 1 == found.intervals.size();
    each.high_out.standing =
        std::isinf(each.high)
            ? each.standing
            : none(below, last ? unbounded_end : found.intervals[k + 1].low_out.value);
    outside = both(outside, both(each.low_out.standing, each.high_out.standing));
    narrow = narrow && is_narrow(each);
  }
  if (found.intervals.empty()) outside = none(-unbounded_end, unbounded_end);
  // Patterns that are undecided may hold factors within the brackets of the ends only.
  if (is_proved(outside) && narrow && found.status == engine::Status::solved) {
    found.unresolved = false;
    found.outside = outside;
  }
  found.outside = both(found.outside, outside);
}

void ExactHold::set_standings(GripRange& found) const {
  if (!any_modes()) return;
  const auto* const known = claims(HoldClaim::factors);
  const auto* const grip = known != nullptr ? &known->grip : nullptr;
  found.standing = support::proved_if(known != nullptr &&
                                      contains(found.held ? known->held : known->none, 0, 0));
  // The state of the evidence may have another sum in the same bracket.
  const auto set = [&](GripEnd& end, double state, bool bounded) {
    if (!end.known || end.unbounded) return;
    const double low = std::min(end.held.value, end.out.value);
    const double high = std::max(end.held.value, end.out.value);
    const double room = std::max(high - low, verify::total_tolerance * high);
    const bool near = state >= low - room && state <= high + room;
    if (near) end.held.value = state;
    end.held.standing = support::proved_if(near);
    end.out.standing = support::proved_if(bounded);
  };
  const bool has_states = grip != nullptr && grip->states;
  const double unknown = std::nan("");
  set(found.minimum, has_states ? grip->states->low : unknown,
      found.minimum.out.value <= 0 || (grip != nullptr && grip->below >= found.minimum.out.value));
  set(found.maximum, has_states ? grip->states->high : unknown,
      grip != nullptr && grip->above && *grip->above <= found.maximum.out.value);
}

void ExactHold::set_standings(HoldingFriction& found) const {
  if (!any_modes()) return;
  const auto* const below = claims(HoldClaim::lower);
  const auto* const above = claims(HoldClaim::upper);
  auto& [lower, upper] = found.bracket;
  // A bracket that begins at zero has no coefficient below.
  if (lower)
    lower->standing = support::proved_if(below != nullptr ? contains(below->none, 0, 0)
                                                          : lower->value == 0 && upper);
  if (upper) upper->standing = support::proved_if(above != nullptr && contains(above->held, 0, 0));
}

}  // namespace kusabi::wedged
