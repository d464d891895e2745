// Blocks of a structure under load: load factors are those held by all, the coefficient is the
// largest of all.
#include "nodes/wedged/hold/hold_search.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <utility>

#include "nodes/wedged/hold/block_hold.hpp"
#include "problems/wedged/problem_block.hpp"

namespace kusabi::wedged {
namespace {

using Candidates = std::vector<support::IndexSet>;

// True if a load acts on one of the blocks from `first` on: it may hold less than those before.
bool is_loaded_from(const LoadedProblem& loaded, const Candidates& blocks, std::size_t first) {
  return std::ranges::any_of(std::span(blocks).subspan(first), [&](const auto& candidates) {
    return is_loaded(loaded_block(loaded, candidates));
  });
}

bool is_under_reference(const LoadedProblem& block) {
  return block.has_reference && acts(block, block.has_dead ? 1 : 0);
}

// Load factors held by both; brackets of ends are kept.
// @param open set if brackets of ends overlap, so that both may hold a factor between them
std::vector<HeldInterval> common(const std::vector<HeldInterval>& one,
                                 const std::vector<HeldInterval>& other, bool& open) {
  std::vector<HeldInterval> result;
  for (const auto& a : one) {
    for (const auto& b : other) {
      HeldInterval both = a.high < b.high ? a : b;  // a may be unbounded, without a pattern
      const auto& lower = a.low >= b.low ? a : b;
      both.low = lower.low;
      both.low_out = lower.low_out;
      both.low_proved = lower.low_proved;
      both.proved = a.proved && b.proved;
      if (both.low <= both.high)
        result.push_back(both);
      else
        open = open || std::max(a.low_out, b.low_out) < std::min(a.high_out, b.high_out);
    }
  }
  std::ranges::sort(result, {}, &HeldInterval::low);
  return result;
}

// The reference load moves a body in a direction that no candidate resists: at most one factor is
// in equilibrium.
std::optional<double> only_factor(const LoadedProblem& loaded) {
  const Eigen::Index reference = loaded.has_dead ? 1 : 0;
  const Eigen::VectorXd work = loaded.loads.other_modes.row(reference).transpose().cast<double>();
  Eigen::Index mode = 0;
  work.cwiseAbs().maxCoeff(&mode);
  if (!loaded.has_dead) return 0;
  const double dead = numbers::rounded(loaded.loads.other_modes(0, mode));
  const double factor = -dead / work[mode];
  if (work_on_other_modes(loaded, {1, factor}) > negligible_work) return {};
  return factor;
}

// States at that one factor.
HeldFactors at_one_factor(engine::Analysis& analysis, const LoadedProblem& loaded, double mu,
                          const HoldParameters& parameters) {
  const auto factor = only_factor(loaded);
  if (!factor) return {.one_factor_at_most = true, .not_in_equilibrium = true};
  LoadedProblem fixed = loaded;  // the dead load of that factor alone
  if (loaded.has_dead) {
    fixed.loads.displacements.col(0) +=
        numbers::Precise(*factor) * loaded.loads.displacements.col(1);
    fixed.loads.motions.row(0) += numbers::Precise(*factor) * loaded.loads.motions.row(1);
  }
  fixed.has_reference = false;
  const Eigen::Index kept = fixed.has_dead ? 1 : 0;
  const double sizes = loaded.has_dead ? std::abs(*factor) : 0;
  if (kept == 1) {
    const double own = std::sqrt(numbers::rounded(loaded.loads.work(0, 0))) +
                       sizes * std::sqrt(numbers::rounded(loaded.loads.work(1, 1)));
    fixed.loads.work(0, 0) = numbers::Precise(own * own);
    fixed.loads.sizes[0] += sizes * loaded.loads.sizes[1];
  }
  fixed.loads.displacements = numbers::PreciseMatrix(fixed.loads.displacements.leftCols(kept));
  fixed.loads.motions = numbers::PreciseMatrix(fixed.loads.motions.topRows(kept));
  fixed.loads.other_modes = numbers::PreciseMatrix(kept, 0);  // in equilibrium at this factor
  fixed.loads.sizes = Eigen::VectorXd(fixed.loads.sizes.head(kept));
  auto at = held_factors(analysis, fixed, mu, parameters);
  at.any_by_supports = false;
  at.one_factor_at_most = true;
  // The factor is that of equilibrium up to its rounding.
  for (auto& each : at.intervals) {
    each.low = each.high = *factor;
    each.low_out = std::nextafter(std::nextafter(*factor, -unbounded_end), -unbounded_end);
    each.high_out = std::nextafter(std::nextafter(*factor, unbounded_end), unbounded_end);
    each.proved = false;
    if (each.state) each.state->factor = *factor;
  }
  return at;
}

// States whose normal reactions add up to a given sum. @pre one block
HeldFactors with_total(engine::Analysis& analysis, const LoadedProblem& loaded, double mu,
                       const HoldParameters& parameters, HoldRecord* record) {
  const auto candidates = problems::blocks_of(loaded.problem).front();
  const LoadedProblem block = loaded_block(loaded, candidates);
  std::vector<HoldCost> costs;
  BlockHold hold(analysis, block, parameters, costs, record != nullptr);
  auto found = is_under_reference(block) ? hold.factors(mu, true) : hold.dead_alone(mu);
  found.costs = std::move(costs);
  if (record != nullptr && found.status == engine::Status::solved)
    hold.record({block, candidates, 0, mu, parameters.precision}, *record);
  return found;
}

}  // namespace

HeldFactors held_factors(engine::Analysis& analysis, const LoadedProblem& loaded, double mu,
                         const HoldParameters& parameters, HoldRecord* record) {
  HeldFactors found;
  found.any_by_supports = loaded.problem.modes.matrix.cols() == 0;
  if (loaded.has_reference && work_on_other_modes(loaded, {0, 1}) > negligible_work)
    return at_one_factor(analysis, loaded, mu, parameters);
  if (work_on_other_modes(loaded, {1, 0}) > negligible_work) {
    found.any_by_supports = false;
    found.not_in_equilibrium = true;
    return found;
  }
  if (parameters.total) return with_total(analysis, loaded, mu, parameters, record);
  found.intervals.push_back({-unbounded_end, -unbounded_end, unbounded_end, unbounded_end});
  bool searched = false;
  bool wedged = true;
  const auto blocks = problems::blocks_of(loaded.problem);
  for (std::uint32_t number = 0; number < blocks.size(); ++number) {
    const LoadedProblem block = loaded_block(loaded, blocks[number]);
    if (block.problem.modes.matrix.cols() == 0) continue;
    const bool reference = is_under_reference(block);
    if (!reference && !is_under_dead(block)) continue;
    BlockHold hold(analysis, block, parameters, found.costs, record != nullptr);
    auto own = reference ? hold.factors(mu, is_under_dead(block)) : hold.dead_alone(mu);
    searched = true;
    wedged = wedged && own.any_by_wedging;
    for (auto& each : own.intervals) each.block = number;
    if (own.status != engine::Status::solved) found.status = own.status;
    found.proved = found.proved && own.proved;
    found.unresolved = found.unresolved || own.unresolved;
    bool open = false;
    found.intervals = common(found.intervals, own.intervals, open);
    found.proved = found.proved && !open;
    found.unresolved = found.unresolved || open;
    if (found.status != engine::Status::solved) {
      if (is_loaded_from(loaded, blocks, number + 1)) found.intervals.clear();
      found.proved = false;
      found.unresolved = true;
      break;
    }
    if (record != nullptr)
      hold.record({block, blocks[number], number, mu, parameters.precision}, *record);
  }
  found.any_by_wedging = searched && wedged;
  return found;
}

namespace {

/// Evidence of a holding friction coefficient: a tree of the block that decides the lower bound,
/// and a pattern of each block at the upper one.
struct FrictionEvidence {
  std::uint32_t lower_block = 0;
  std::optional<TreeEvidence> tree{};
  std::vector<std::optional<LoadedPattern>> patterns{};
};

void record_friction(engine::Analysis& analysis, const LoadedProblem& loaded,
                     const HoldingFriction& found, const FrictionEvidence& evidence,
                     const HoldParameters& parameters) {
  constexpr LoadShare dead{1, 0};
  const auto blocks = problems::blocks_of(loaded.problem);
  if (found.not_in_equilibrium || (found.lower_proved && evidence.tree)) {
    const auto record = parameters.recorder(HoldClaim::lower, found.lower);
    if (evidence.tree) {
      const auto number = evidence.lower_block;
      const LoadedProblem block = loaded_block(loaded, blocks[number]);
      record_tree(analysis, {block, blocks[number], number, found.lower, parameters.precision},
                  *evidence.tree, *record);
    }
    record->finish();
  }
  if (!found.upper || !found.upper_proved) return;
  const auto record = parameters.recorder(HoldClaim::upper, *found.upper);
  for (std::uint32_t number = 0; number < evidence.patterns.size(); ++number) {
    const auto& pattern = evidence.patterns[number];
    if (!pattern) continue;
    const LoadedProblem block = loaded_block(loaded, blocks[number]);
    record_state(analysis, {block, blocks[number], number, *found.upper, parameters.precision},
                 *pattern, dead, {}, *record);
  }
  record->finish();
}

}  // namespace

HoldingFriction holding_friction(engine::Analysis& analysis, const LoadedProblem& loaded,
                                 const HoldParameters& parameters) {
  HoldingFriction found;
  found.upper = 0;
  found.maximum = parameters.maximum;
  found.any_by_supports = loaded.problem.modes.matrix.cols() == 0;
  if (work_on_other_modes(loaded, {1, 0}) > negligible_work) {
    found.not_in_equilibrium = true;
    found.upper.reset();
    found.lower_known = true;
    if (parameters.recorder) record_friction(analysis, loaded, found, {}, parameters);
    return found;
  }
  const auto blocks = problems::blocks_of(loaded.problem);
  FrictionEvidence evidence;
  evidence.patterns.resize(blocks.size());
  for (std::uint32_t number = 0; number < blocks.size(); ++number) {
    const LoadedProblem block = loaded_block(loaded, blocks[number]);
    if (block.problem.modes.matrix.cols() == 0 || !is_under_dead(block)) continue;
    BlockHold hold(analysis, block, parameters, found.costs,
                   static_cast<bool>(parameters.recorder));
    auto own = hold.friction();
    if (own.upper) own.state = hold.state(own.pattern, 0, *own.upper);
    if (own.status != engine::Status::solved) found.status = own.status;
    if (own.lower_known && (!found.lower_known || own.lower > found.lower)) {
      found.lower = own.lower;
      found.lower_known = true;
      found.lower_proved = own.lower_proved;
      evidence.lower_block = number;
      evidence.tree = hold.tree_at(own.lower);
    }
    evidence.patterns[number] = own.pattern;
    found.upper_proved = found.upper_proved && own.upper_proved;
    const bool decides = !own.upper || (found.upper && *own.upper >= *found.upper);
    if (decides) {
      found.upper = own.upper;
      found.block = number;
      found.pattern = own.pattern;
      found.state = own.state;
    }
    if (!found.upper) found.maximum = own.maximum;
    if (found.status != engine::Status::solved && is_loaded_from(loaded, blocks, number + 1)) {
      found.upper.reset();
      found.pattern.reset();
      found.state.reset();
    }
    if (found.status != engine::Status::solved || !found.upper) break;
  }
  if (parameters.recorder && found.status == engine::Status::solved)
    record_friction(analysis, loaded, found, evidence, parameters);
  return found;
}

}  // namespace kusabi::wedged
