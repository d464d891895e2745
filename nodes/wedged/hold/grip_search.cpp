// Both ends by the same search: a leaf is followed to its own end, and a tree beyond it is
// infeasible or has another leaf.
#include "nodes/wedged/hold/grip_search.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "nodes/wedged/hold/bounded_search.hpp"
#include "problems/wedged/problem_block.hpp"

namespace kusabi::wedged {
namespace {

constexpr int max_steps = 70;
/// Relative distances beyond a leaf's own end at which the tree is searched if it is degenerate
/// there.
constexpr std::array<double, 4> steps_beyond{0, 1e-8, 1e-6, 1e-4};
constexpr LoadShare dead_load{1, 0};

/// Share of the sum of a state below which another sum is zero.
constexpr double negligible_sum = 1e-12;

/// Width of a bracket at a largest sum of zero, relative to the size of the dead load and the
/// clearances as a force.
constexpr double min_sum_share = 1e-9;

using Kind = GripRestriction::Kind;

class BlockGrip {
 public:
  BlockGrip(engine::Analysis& analysis, const LoadedProblem& block, double mu,
            const HoldParameters& parameters, std::vector<HoldCost>& costs, bool recorded)
      : analysis_(analysis),
        block_(block),
        mu_(mu),
        parameters_(parameters),
        costs_(costs),
        recorded_(recorded) {}

  /// Both ends; nothing if there is no state, proved.
  std::optional<GripOfBlock> range();
  [[nodiscard]] engine::Status status() const { return status_; }
  /// Trees without states beyond both ends; of a block without dead load, the tree without wedged
  /// configurations.
  [[nodiscard]] const std::vector<TreeEvidence>& trees() const { return trees_; }

 private:
  GripEnd end(Kind kind, const LoadedLeaf& leaf);  // in one direction from a state
  HoldOutcome search(std::span<const LoadShare> shares, const std::optional<GripRestriction>& grip);
  [[nodiscard]] bool reaches(const LoadedPattern& pattern,
                             const std::optional<GripRestriction>& grip) const;
  [[nodiscard]] std::optional<GripEnd> no_end(const LoadedPattern& pattern) const;
  void follow(GripEnd& end, Kind kind) const;
  [[nodiscard]] double sum_of(const LoadedLeaf& leaf) const;

  engine::Analysis& analysis_;
  const LoadedProblem& block_;
  double mu_;
  const HoldParameters& parameters_;
  std::vector<HoldCost>& costs_;
  bool recorded_;
  std::vector<TreeEvidence> trees_;
  engine::Status status_ = engine::Status::solved;
};

HoldOutcome BlockGrip::search(std::span<const LoadShare> shares,
                              const std::optional<GripRestriction>& grip) {
  TreeEvidence evidence{mu_, {shares.begin(), shares.end()}, grip};
  auto found = search_for_state(analysis_, block_, evidence, parameters_, recorded_);
  costs_.push_back({mu_, 0, 0, found.opened, found.tally.iterations});
  const bool needed = grip || (shares.empty() && !is_under_dead(block_));
  if (recorded_ && needed && found.is_infeasible()) trees_.push_back(std::move(evidence));
  if (found.status != engine::Status::solved) status_ = found.status;
  return found;
}

double BlockGrip::sum_of(const LoadedLeaf& leaf) const {
  double sum = 0;
  for (std::size_t i = 0; i < leaf.reaction.size();
       i += static_cast<std::size_t>(block_.problem.dimension))
    sum += leaf.reaction[i];
  return sum / leaf.amounts.front();
}

bool BlockGrip::reaches(const LoadedPattern& pattern,
                        const std::optional<GripRestriction>& grip) const {
  HoldNodes nodes(block_, std::array{dead_load}, mu_, parameters_.precision, grip);
  return nodes.solve(pattern) == HoldResult::feasible;
}

// No end, if any multiple of a wedged configuration can be added to the states of a pattern: proved
// if t* > 0.
std::optional<GripEnd> BlockGrip::no_end(const LoadedPattern& pattern) const {
  HoldNodes nodes(block_, {}, mu_, parameters_.precision);
  const HoldResult result = nodes.solve(pattern);
  const bool flat = result == HoldResult::at_limit || result == HoldResult::face;
  if (!flat && result != HoldResult::feasible) return {};
  const support::Bound none{0, support::proved_if(!flat)};
  return GripEnd{.held = none, .out = none, .unbounded = true};
}

// Moves `held` to the end of its pattern, and `out` beside it.
void BlockGrip::follow(GripEnd& end, Kind kind) const {
  const bool up = kind == Kind::above;
  const double floor = up ? min_sum_share * scale_of(block_, dead_load) : 0;
  double& held = end.held.value;
  double out = up ? std::max(2 * held, floor) : 0;
  if (up) {
    for (int step = 0; step < max_steps && reaches(*end.pattern, GripRestriction{kind, out});
         ++step) {
      held = out;
      out *= 2;
    }
  }
  for (int step = 0; step < max_steps && !analysis_.ended(); ++step) {
    if (std::abs(out - held) <= std::max(floor, parameters_.width * std::max(out, held))) break;
    const double middle = held + (out - held) / 2;
    if (middle == held || middle == out) break;
    (reaches(*end.pattern, GripRestriction{kind, middle}) ? held : out) = middle;
  }
  end.out.value = out;
}

const GripEnd unknown_end{.known = false};
/// Sum of no reactions.
constexpr support::Bound zero{0, support::Standing::proved};
const GripEnd at_zero{.held = zero, .out = zero};

GripEnd BlockGrip::end(Kind kind, const LoadedLeaf& leaf) {
  const double away = kind == Kind::above ? 1 : -1;
  const LoadedPattern apart{{}, problems::all_candidates(block_.problem)};
  if (kind == Kind::below && reaches(apart, {}))
    return {.held = zero, .out = zero, .pattern = apart};
  const double begin = sum_of(leaf);
  GripEnd end{.held = {begin, support::Standing::proved}, .out = zero, .pattern = leaf.pattern};
  for (int round = 0; round < max_steps; ++round) {
    if (kind == Kind::above) {
      if (const auto unbounded = no_end(*end.pattern)) return *unbounded;
    }
    follow(end, kind);
    if (kind == Kind::below && end.held.value <= negligible_sum * begin) {
      end.out = zero;  // the sum is never negative
      return end;
    }
    bool again = false;
    bool may_be_beyond = false;  // states at a limit, or undecided leaves, at the last step
    for (const double step : steps_beyond) {
      const double out = end.out.value * (1 + away * step);
      const auto outcome = search(std::array{dead_load}, GripRestriction{kind, out});
      if (status_ != engine::Status::solved) {
        end.out.standing = support::Standing::computed;
        return end;
      }
      if (!outcome.leaves.empty()) {
        end.held.value = out;
        end.pattern = outcome.leaves.front().pattern;
        again = true;
        break;
      }
      end.out.standing = support::proved_if(outcome.is_infeasible());
      if (end.out.proved()) {
        end.out.value = out;
        return end;
      }
      may_be_beyond = outcome.is_unresolved() || !outcome.tally.limits.empty();
    }
    if (again) continue;
    if (may_be_beyond && kind == Kind::above) return unknown_end;
    if (may_be_beyond) end.out = zero;
    return end;
  }
  end.out.standing = support::Standing::computed;
  return end;
}

std::optional<GripOfBlock> BlockGrip::range() {
  GripOfBlock own{.minimum = at_zero, .maximum = at_zero};
  const auto wedged = search({}, {});
  // A wedged pattern whose contacts resist all modes has a state. Without a dead load its
  // configurations are states.
  own.maximum.unbounded = !wedged.leaves.empty() &&
                          (!is_under_dead(block_) ||
                           resists_all(block_.problem, wedged.leaves.front().pattern.contact, mu_));
  const bool known = own.maximum.unbounded || wedged.is_infeasible();
  own.maximum.out.standing = support::proved_if(known);
  if (!is_under_dead(block_)) {
    if (!known && !wedged.tally.limits.empty()) own.maximum = unknown_end;
    return own;
  }
  const auto first = search(std::array{dead_load}, {});
  if (first.is_infeasible()) return {};
  if (first.leaves.empty()) {  // degenerate states, if any: no bound but zero
    if (!own.maximum.unbounded) own.maximum = unknown_end;
    own.minimum = {.out = zero, .known = false};
    return own;
  }
  own.minimum = end(Kind::below, first.leaves.front());
  if (own.maximum.unbounded) return own;
  own.maximum = end(Kind::above, first.leaves.front());
  // With wedged configurations an end that is not proved may be that of a pattern only.
  if (!known && !own.maximum.unbounded && !own.maximum.out.proved()) own.maximum = unknown_end;
  return own;
}

void add(GripEnd& sum, const GripEnd& own) {
  for (const auto part : {&GripEnd::held, &GripEnd::out}) {
    (sum.*part).value += (own.*part).value;
    (sum.*part).standing = both((sum.*part).standing, (own.*part).standing);
  }
  sum.known = sum.known && own.known;
  sum.unbounded = sum.unbounded || own.unbounded;
}

// Certificate of a block: trees beyond its ends, and the states at them.
void record_grip(engine::Analysis& analysis, const RecordedBlock& block, const GripOfBlock& own,
                 const std::vector<TreeEvidence>& trees, HoldRecord& record) {
  for (const auto* end : {&own.minimum, &own.maximum}) {
    const Kind kind = end == &own.minimum ? Kind::below : Kind::above;
    if (end->pattern)
      record_state(analysis, block, *end->pattern, dead_load,
                   GripRestriction{kind, end->held.value}, record);
  }
  for (const auto& tree : trees) record_tree(analysis, block, tree, record);
}

}  // namespace

GripRange grip_range(engine::Analysis& analysis, const LoadedProblem& loaded, double mu,
                     const HoldParameters& parameters, HoldRecord* record) {
  GripRange found{.standing = support::Standing::proved, .minimum = at_zero, .maximum = at_zero};
  if (is_dead_unbalanced(loaded, parameters)) {
    found.held = false;
    return found;
  }
  const auto blocks = problems::blocks_of(loaded.problem);
  for (std::uint32_t number = 0; number < blocks.size(); ++number) {
    const LoadedProblem block = loaded_block(loaded, blocks[number]);
    BlockGrip grip(analysis, block, mu, parameters, found.costs, record != nullptr);
    const auto range = grip.range();
    found.status = grip.status();
    if (found.status != engine::Status::solved) break;
    found.held = range.has_value();
    if (!found.held) break;
    if (block.problem.modes.matrix.cols() > 0)  // supports hold every load
      found.standing = both(found.standing, range->minimum.held.standing);
    add(found.minimum, range->minimum);
    add(found.maximum, range->maximum);
    if (record != nullptr) {
      record_grip(analysis, recorded_block(block, blocks[number], number, mu, parameters), *range,
                  grip.trees(), *record);
    }
    found.blocks.push_back(*range);
    found.blocks.back().block = number;
  }
  return found;
}

}  // namespace kusabi::wedged
