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

using support::Bound;
using support::Standing;
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
      // One may be unbounded, without a pattern.
      HeldInterval common = a.high < b.high ? a : b;
      const auto& lower = a.low >= b.low ? a : b;
      common.low = lower.low;
      common.low_out = lower.low_out;
      common.standing = both(a.standing, b.standing);
      if (common.low <= common.high)
        result.push_back(common);
      else
        open = open || std::max(a.low_out.value, b.low_out.value) <
                           std::min(a.high_out.value, b.high_out.value);
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
  if (std::abs(dead) <= negligible_work * loaded.loads.sizes[0]) return 0;
  const double factor = -dead / work[mode];
  if (work_on_other_modes(loaded, {1, factor}) > negligible_work) return {};
  return factor;
}

const HeldFactors never_in_equilibrium{.outside = Standing::proved, .not_in_equilibrium = true};

// States at that one factor.
HeldFactors at_one_factor(engine::Analysis& analysis, const LoadedProblem& loaded, double mu,
                          const HoldParameters& parameters, HoldRecord* record) {
  const auto factor = only_factor(loaded);
  if (!factor) return never_in_equilibrium;
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
  auto at = held_factors(analysis, fixed, mu, parameters, *factor == 0 ? record : nullptr);
  at.any_by_supports = false;
  // The factor is that of equilibrium up to its rounding.
  for (auto& each : at.intervals) {
    each.low = each.high = *factor;
    each.standing = Standing::computed;
    each.low_out.value = each.high_out.value = *factor;
    if (*factor != 0) {
      each.low_out.value = std::nextafter(std::nextafter(*factor, -unbounded_end), -unbounded_end);
      each.high_out.value = std::nextafter(std::nextafter(*factor, unbounded_end), unbounded_end);
    }
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
    hold.record(recorded_block(block, candidates, 0, mu, parameters), *record);
  return found;
}

}  // namespace

void restrict_to(HeldFactors& found, const HeldFactors& other) {
  if (other.status != engine::Status::solved) found.status = other.status;
  bool open = false;
  found.intervals = common(found.intervals, other.intervals, open);
  found.unresolved = found.unresolved || other.unresolved || open;
  found.outside = both(found.outside, open ? Standing::computed : other.outside);
}

bool raise_to(support::Bracket& found, const support::Bracket& other) {
  const auto& [lower, upper] = other;
  if (lower && lower->value > found.at_least()) found.lower = lower;
  const auto standing =
      upper && found.upper ? both(found.upper->standing, upper->standing) : Standing::computed;
  const bool more = !upper || (found.upper && upper->value >= found.upper->value);
  if (more) found.upper = upper;
  if (found.upper) found.upper->standing = standing;
  return more;
}

bool is_dead_unbalanced(const LoadedProblem& loaded, const HoldParameters& parameters) {
  return parameters.dead_out_of_equilibrium ||
         work_on_other_modes(loaded, {1, 0}) > negligible_work;
}

RecordedBlock recorded_block(const LoadedProblem& block, const support::IndexSet& candidates,
                             std::uint32_t number, double mu, const HoldParameters& parameters) {
  return {block, candidates, number, mu, parameters.precision};
}

HeldFactors held_factors(engine::Analysis& analysis, const LoadedProblem& loaded, double mu,
                         const HoldParameters& parameters, HoldRecord* record) {
  if (parameters.never_in_equilibrium) return never_in_equilibrium;
  HeldFactors found{.outside = Standing::proved};
  found.any_by_supports = is_constrained(loaded);
  if (loaded.has_reference && work_on_other_modes(loaded, {0, 1}) > negligible_work)
    return at_one_factor(analysis, loaded, mu, parameters, record);
  if (work_on_other_modes(loaded, {1, 0}) > negligible_work) return never_in_equilibrium;
  if (parameters.total) return with_total(analysis, loaded, mu, parameters, record);
  found.intervals.push_back(HeldInterval::from(-unbounded_end, unbounded_end, Standing::proved));
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
    restrict_to(found, own);
    if (found.status != engine::Status::solved) {
      if (is_loaded_from(loaded, blocks, number + 1)) found.intervals.clear();
      found.outside = Standing::computed;
      found.unresolved = true;
      break;
    }
    if (record != nullptr)
      hold.record(recorded_block(block, blocks[number], number, mu, parameters), *record);
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
  const auto& [lower, upper] = found.bracket;
  if (is_proved(lower) && (found.not_in_equilibrium || evidence.tree)) {
    const auto record = parameters.recorder(HoldClaim::lower, lower->value);
    if (evidence.tree) {
      const auto number = evidence.lower_block;
      const LoadedProblem block = loaded_block(loaded, blocks[number]);
      record_tree(analysis, recorded_block(block, blocks[number], number, lower->value, parameters),
                  *evidence.tree, *record);
    }
    record->finish();
  }
  if (!is_proved(upper)) return;
  const auto record = parameters.recorder(HoldClaim::upper, upper->value);
  for (std::uint32_t number = 0; number < evidence.patterns.size(); ++number) {
    const auto& pattern = evidence.patterns[number];
    if (!pattern) continue;
    const LoadedProblem block = loaded_block(loaded, blocks[number]);
    record_state(analysis, recorded_block(block, blocks[number], number, upper->value, parameters),
                 *pattern, dead, {}, *record);
  }
  record->finish();
}

}  // namespace

HoldingFriction holding_friction(engine::Analysis& analysis, const LoadedProblem& loaded,
                                 const HoldParameters& parameters) {
  HoldingFriction found;
  found.bracket.upper = Bound{0, Standing::proved};
  found.maximum = parameters.maximum;
  found.any_by_supports = is_constrained(loaded);
  if (is_dead_unbalanced(loaded, parameters)) {
    found.not_in_equilibrium = true;
    found.any_by_supports = false;
    found.bracket = {.lower = Bound{0, Standing::proved}};
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
    const auto& [lower, upper] = own.bracket;
    if (upper) own.state = hold.state(own.pattern, 0, upper->value);
    if (own.status != engine::Status::solved) found.status = own.status;
    if (lower && lower->value > found.bracket.at_least()) {
      evidence.lower_block = number;
      evidence.tree = hold.tree_at(lower->value);
    }
    evidence.patterns[number] = own.pattern;
    if (raise_to(found.bracket, own.bracket)) {
      found.block = number;
      found.pattern = own.pattern;
      found.state = own.state;
    }
    if (!found.bracket.upper) found.maximum = own.maximum;
    if (found.status != engine::Status::solved && is_loaded_from(loaded, blocks, number + 1)) {
      found.bracket.upper.reset();
      found.pattern.reset();
      found.state.reset();
    }
    if (found.status != engine::Status::solved || !found.bracket.upper) break;
  }
  if (parameters.recorder && found.status == engine::Status::solved)
    record_friction(analysis, loaded, found, evidence, parameters);
  return found;
}

}  // namespace kusabi::wedged
