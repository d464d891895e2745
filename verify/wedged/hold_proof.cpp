// Claims of each block, and their consequences for the whole structure.
#include "verify/wedged/hold_proof.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "verify/wedged/cover.hpp"
#include "verify/wedged/proof.hpp"

namespace kusabi::verify {

using support::IndexSet;

namespace {

constexpr double unbounded_end = std::numeric_limits<double>::infinity();

}  // namespace

HoldProof::HoldProof(const HoldCertificate& certificate, const LoadedEnclosure& enclosure,
                     const std::vector<double>& clearances)
    : certificate_(certificate) {
  const auto& header = certificate.header;
  const auto& [problem, loads] = enclosure;
  for (const auto& load : loads) work_on_other_modes_.push_back(load.work.others);
  sizes_of_work_ = loads[0].work.sizes_of_others;
  for (const auto& block : header.blocks) {
    auto own = contact_block(header, problem.stiffness, problem.motions, block, loads);
    Part part{.unconstrained = own.motions.count > 0};
    for (const int i : block) {
      const auto candidate = static_cast<std::size_t>(i);
      own.clearance.push_back(clearances[candidate]);
      part.dead = part.dead || clearances[candidate] != 0 || loads[0].acts[candidate];
      part.reference = part.reference || loads[1].acts[candidate];
    }
    if (own.motions.count != header.motions_of(block).size()) {
      minimum_.reset();
      return;
    }
    parts_.push_back(part);
    blocks_.emplace_back(std::move(own));
    const auto& minimum = blocks_.back().min_eigenvalue();
    if (!minimum) {
      minimum_.reset();
      return;
    }
    if (!minimum_ || *minimum < *minimum_) minimum_ = minimum;
  }
  if (!certificate.total) return;
  // The only block: the dead share has the total, also without a load, and a state requires a
  // proof.
  auto& part = parts_.front();
  part = {.unconstrained = true, .dead = true, .reference = part.reference};
}

ProofResult HoldProof::proof_result(const HoldNode& node) const {
  const auto& tree = certificate_.trees[node.tree];
  const auto& block = certificate_.header.blocks[tree.block];
  std::span<const double> numbers = node.record.numbers;
  std::optional<GripTerm> grip;
  if (tree.grip) {
    const double multiplier = numbers.back();
    numbers = numbers.first(numbers.size() - 1);
    if ((tree.grip->kind == GripBound::Kind::above && multiplier < 0) ||
        (tree.grip->kind == GripBound::Kind::below && multiplier > 0))
      return {.refusal = "the multiplier of the sum has the wrong sign"};
    grip = GripTerm{tree.grip->total, multiplier};
  }
  return blocks_[tree.block].prove_no_state(within(block, node.record.contact),
                                            within(block, node.record.separated), tree.shares,
                                            numbers, grip);
}

std::optional<std::string> HoldProof::refusal_of_unbalanced(LoadShare share) const {
  for (std::size_t mode = 0; mode < work_on_other_modes_[0].size(); ++mode) {
    const mpq_class work = mpq_class(share.dead) * work_on_other_modes_[0][mode] +
                           mpq_class(share.reference) * work_on_other_modes_[1][mode];
    if (sgn(work) != 0) return "its load does work on a motion that displaces no candidate";
  }
  return {};
}

std::optional<std::string> HoldProof::refusal(const HoldState& state) const {
  const auto& block = certificate_.header.blocks[state.block];
  const auto contact = within(block, state.contact);
  const auto& proof = blocks_[state.block];
  if (!state.share) {
    if (certificate_.total) return "a wedged configuration has no total";
    if (!proof.resists_all_motions(contact))
      return "its contacts do not resist every rigid-body mode";
    return proof.refusal_of_feasible(contact, state.numbers);
  }
  if (auto why = refusal_of_unbalanced(*state.share)) return why;
  if (!certificate_.total) return proof.refusal_of_held_state(contact, *state.share, state.numbers);
  Grip grip;
  if (auto why = proof.refusal_of_held_state(contact, *state.share, state.numbers, &grip))
    return why;
  const mpq_class total(*certificate_.total);
  const mpq_class off = total * mpq_class(total_tolerance);
  if (grip.minimum < total - off || grip.maximum > total + off)
    return "its normal reactions do not add up to the total";
  return {};
}

std::optional<std::string> HoldProof::flaw(std::size_t tree) const {
  std::vector<const Record*> records;
  for (const auto& node : certificate_.nodes) {
    if (node.tree == tree) records.push_back(&node.record);
  }
  return flaw_of_cover(certificate_.header,
                       certificate_.header.blocks[certificate_.trees[tree].block], records);
}

// The load factors whose loads are in the cone of the shares.
std::optional<FactorRange> HoldProof::excluded(const HoldTree& tree) const {
  const auto& part = parts_[tree.block];
  if (tree.grip && tree.grip->kind != GripBound::Kind::equal) return {};
  FactorRange range{unbounded_end, -unbounded_end};
  bool upward = false;
  bool downward = false;
  for (const auto& [dead, reference] : tree.shares) {
    if (dead == 0) {
      upward = upward || reference > 0;
      downward = downward || reference < 0;
      continue;
    }
    range.low = std::min(range.low, reference);
    range.high = std::max(range.high, reference);
  }
  if (!part.dead) {  // the factor is a multiple: all of one sign, or none
    const double minimum = std::nextafter(0.0, unbounded_end);
    if (upward != downward && !(range.low <= range.high))
      return upward ? FactorRange{minimum, unbounded_end} : FactorRange{-unbounded_end, -minimum};
    return {};
  }
  if (!(range.low <= range.high)) return {};
  if (!part.reference) return FactorRange{};
  if (downward) range.low = -unbounded_end;
  if (upward) range.high = unbounded_end;
  return range;
}

std::vector<FactorRange> HoldProof::held_by(std::size_t block,
                                            const std::vector<bool>& states) const {
  const auto& part = parts_[block];
  std::map<std::pair<IndexSet, IndexSet>, FactorRange> points;  // by pattern
  std::map<std::pair<IndexSet, IndexSet>, std::pair<bool, bool>> directions;
  std::vector<FactorRange> all;
  for (std::size_t k = 0; k < states.size(); ++k) {
    const auto& state = certificate_.states[k];
    if (state.block != block || !states[k]) continue;
    if (!state.share) return {FactorRange{}};
    const std::pair pattern(state.contact, state.separated);
    const auto& [dead, reference] = *state.share;
    if (dead == 0) {
      auto& [up, down] = directions[pattern];
      up = up || reference > 0;
      down = down || reference < 0;
      continue;
    }
    if (!part.reference) return {FactorRange{}};
    auto [place, is_new] = points.emplace(pattern, FactorRange{reference, reference});
    place->second.low = std::min(place->second.low, reference);
    place->second.high = std::max(place->second.high, reference);
  }
  if (!part.dead) all.push_back({0, 0});
  for (const auto& [pattern, range] : points) all.push_back(range);
  for (const auto& [pattern, way] : directions) {
    const auto point = points.find(pattern);
    if (part.dead && point == points.end()) continue;
    all.push_back(part.dead ? point->second : FactorRange{0, 0});
    if (way.first) all.back().high = unbounded_end;
    if (way.second) all.back().low = -unbounded_end;
  }
  return joined(std::move(all));
}

// The dead load and every multiple of the reference load do work on a motion that displaces no
// candidate: by more than a share of the magnitudes of which it consists, which may be the rounding
// of positions and directions in the file.
bool HoldProof::out_of_equilibrium() const {
  constexpr double rounded = 0x1p-30;
  for (std::size_t mode = 0; mode < work_on_other_modes_[0].size(); ++mode) {
    if (sgn(work_on_other_modes_[1][mode]) == 0 &&
        std::abs(work_on_other_modes_[0][mode].get_d()) > rounded * sizes_of_work_[mode])
      return true;
  }
  return false;
}

// Without dead load and wedged configurations all reactions of a block are zero.
GripRange HoldProof::grip_of(std::size_t block, const std::vector<bool>& trees,
                             const std::vector<bool>& states) const {
  GripRange range;
  constexpr LoadShare dead{1, 0};
  if (!parts_[block].dead) range.states = FactorRange{0, 0};
  for (std::size_t t = 0; t < trees.size(); ++t) {
    const auto& tree = certificate_.trees[t];
    if (!trees[t] || tree.block != block) continue;
    if (tree.shares.empty() && !parts_[block].dead) range.above = 0;
    if (!tree.grip || tree.shares != std::vector{dead}) continue;
    const double total = tree.grip->total;
    if (tree.grip->kind == GripBound::Kind::above)
      range.above = std::min(range.above.value_or(unbounded_end), total);
    if (tree.grip->kind == GripBound::Kind::below) range.below = std::max(range.below, total);
  }
  for (std::size_t k = 0; k < states.size(); ++k) {
    const auto& state = certificate_.states[k];
    if (!states[k] || state.block != block || state.share != dead) continue;
    const auto& own = certificate_.header.blocks[block];
    Grip grip;
    if (blocks_[block].refusal_of_held_state(within(own, state.contact), dead, state.numbers,
                                             &grip))
      continue;
    if (!range.states) range.states = FactorRange{unbounded_end, -unbounded_end};
    range.states->low = std::min(range.states->low, rounded_up(grip.maximum));
    range.states->high = std::max(range.states->high, rounded_down(grip.minimum));
  }
  return range;
}

// Sums of the bounds and of the states of all blocks, rounded so that they remain true.
std::optional<GripRange> HoldProof::whole_grip(const std::vector<bool>& trees,
                                               const std::vector<bool>& states) const {
  const bool asked = std::ranges::any_of(certificate_.trees, [](const auto& tree) {
    return tree.grip && tree.grip->kind != GripBound::Kind::equal;
  });
  if (!asked) return {};
  const auto sum = [](double one, double other, double toward) {
    if (one == 0 || other == 0) return one + other;
    return std::nextafter(one + other, toward);
  };
  GripRange whole{.below = 0, .above = 0, .states = FactorRange{0, 0}};
  for (std::size_t block = 0; block < blocks_.size(); ++block) {
    const auto own = grip_of(block, trees, states);
    whole.below = sum(whole.below, own.below, 0);
    if (whole.above && own.above)
      whole.above = sum(*whole.above, *own.above, unbounded_end);
    else
      whole.above.reset();
    if (whole.states && own.states) {
      whole.states->low = sum(whole.states->low, own.states->low, unbounded_end);
      whole.states->high = sum(whole.states->high, own.states->high, 0);
    } else {
      whole.states.reset();
    }
  }
  return whole;
}

HoldClaims HoldProof::claims(const std::vector<bool>& trees,
                             const std::vector<bool>& states) const {
  HoldClaims claims;
  claims.total = certificate_.total;
  claims.held = {FactorRange{}};
  if (out_of_equilibrium()) {
    claims.held.clear();
    claims.none = {FactorRange{}};
    return claims;
  }
  for (std::size_t block = 0; block < blocks_.size(); ++block) {
    const auto& part = parts_[block];
    if (part.unconstrained && (part.dead || part.reference))
      claims.held = common(claims.held, held_by(block, states));
  }
  claims.grip = whole_grip(trees, states);
  bool unbalanced = false;  // the reference load is in equilibrium at one factor at most
  for (const auto& work : work_on_other_modes_[1]) unbalanced = unbalanced || sgn(work) != 0;
  for (const auto& work : work_on_other_modes_[0]) unbalanced = unbalanced || sgn(work) != 0;
  if (unbalanced) claims.held.clear();
  for (std::size_t t = 0; t < trees.size(); ++t) {
    const auto range = trees[t] ? excluded(certificate_.trees[t]) : std::nullopt;
    if (range) claims.none.push_back(*range);
  }
  claims.none = joined(std::move(claims.none));
  return claims;
}

std::vector<FactorRange> common(const std::vector<FactorRange>& one,
                                const std::vector<FactorRange>& other) {
  std::vector<FactorRange> result;
  for (const auto& a : one) {
    for (const auto& b : other) {
      const FactorRange both{std::max(a.low, b.low), std::min(a.high, b.high)};
      if (both.low <= both.high) result.push_back(both);
    }
  }
  return joined(std::move(result));
}

std::vector<FactorRange> joined(std::vector<FactorRange> ranges) {
  std::ranges::sort(ranges, {}, &FactorRange::low);
  std::vector<FactorRange> result;
  for (const auto& each : ranges) {
    if (result.empty() || each.low > result.back().high) {
      result.push_back(each);
    } else {
      result.back().high = std::max(result.back().high, each.high);
    }
  }
  return result;
}

}  // namespace kusabi::verify
