// Verification of one leaf or of one tree of sign patterns, repeated if a bound has to be relaxed.
#include "nodes/wedged/critical_bounds.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <numeric>
#include <utility>

#include "nodes/wedged/critical/smallest_search.hpp"
#include "nodes/wedged/friction/friction_grid.hpp"
#include "nodes/wedged/tree/candidate_friction.hpp"
#include "problems/wedged/problem_block.hpp"

namespace kusabi::wedged {

namespace {

/// A bound is relaxed by the width first, then by eight times as much in each step.
constexpr int max_moves = 7;
constexpr double growth = 8;

/// A bracket of at least this many widths counts as wider than requested. A critical coefficient at
/// a grid point is undecided there, so its bracket has two widths.
constexpr double wide = 2.5;

CriticalEntry entry_of(const Configuration& leaf, const NarrowingBracket& bracket) {
  return {.block = leaf.block,
          .pattern = leaf.pattern,
          .lower = bracket.lower(),
          .upper = bracket.upper(),
          .reaction = leaf.reaction,
          .displacement = leaf.displacement};
}

}  // namespace

CriticalBounds::CriticalBounds(engine::Analysis& analysis,
                               const problems::CheckedStructure& structure,
                               const problems::WedgedProblem& problem,
                               const BoundsParameters& parameters, const BoundRecorder& recorder,
                               NarrowingBracket& bracket, std::vector<CriticalCost>& costs)
    : analysis_(analysis),
      problem_(problem),
      parameters_(parameters),
      recorder_(recorder),
      bracket_(bracket),
      decisions_(analysis, structure, problem, parameters.grid.precision, parameters.tightening,
                 recorder, costs) {}

void CriticalBounds::set_known(std::vector<Configuration> found) {
  known_ = std::move(found);
  known_leaf_ = bracket_.leaf();
}

void CriticalBounds::prove_at_once() {
  if (!decisions_.enclose()) return;
  if (bracket_.leaf() && !bracket_.upper_proved()) {
    const double factor = *bracket_.upper();
    auto decided = decisions_.leaf(*bracket_.leaf(), factor, LeafRecord::none);
    if (decided.holds) {
      bracket_.prove_upper(factor, *bracket_.leaf());
      set_known(std::move(decided.found));
    }
  }
  const double factor = bracket_.lower();
  if (!bracket_.lower_proved() && factor >= bracket_.minimum() &&
      decisions_.roots_are_infeasible(factor)) {
    bracket_.prove_lower(factor);
    proved_lower_ = factor;
  }
  bracket_.show();
}

Evidence CriticalBounds::form_of(std::uint32_t block) const {
  return {
      .kind = Evidence::Kind::form, .block = block, .node = {}, .numbers = forms_.numbers[block]};
}

// The form was proved in doubles (form_proves_infeasible): a bound by computation where K cannot be
// enclosed, or the exact test does not succeed.
void CriticalBounds::prove_by_forms(QuadraticForms forms) {
  if (!decisions_.enclose()) {
    bracket_.raise_lower(forms.factor);
    return;
  }
  forms_ = std::move(forms);
  std::vector<Evidence> claims;
  for (std::uint32_t block = 0; block < forms_.numbers.size(); ++block)
    claims.push_back(form_of(block));
  const bool holds = decisions_.are_proved(claims, forms_.factor);
  if (holds) {
    bracket_.prove_lower(forms_.factor);
    proved_lower_ = forms_.factor;
  } else {
    bracket_.raise_lower(forms_.factor);
    forms_ = {};
  }
  bracket_.show();
}

// Written by one rank.
void CriticalBounds::record_forms() {
  const auto record =
      recorder_(BracketSide::lower, forms_.factor, candidate_friction(problem_, forms_.factor));
  if (!record) return;
  for (std::uint32_t block = 0; block < forms_.numbers.size() && analysis_.is_first(); ++block)
    record->add(form_of(block));
  record->end({}, BoundClaim::all_patterns, true);
  forms_recorded_ = true;
}

// Certificates of a stopped run: the form, and one cone program for the leaf.
void CriticalBounds::record_proved_bounds() {
  if (forms_are_the_bound() && !forms_recorded_) record_forms();
  if (bracket_.upper_proved())
    decisions_.leaf(*bracket_.leaf(), *bracket_.upper(), LeafRecord::after_stop);
}

// Bisection by the exact test alone: a leaf feasible at a coefficient is feasible at all larger
// ones. The bracket of the search is tested first.
engine::Status CriticalBounds::bisect() {
  const double width = parameters_.grid.width;
  const FrictionGrid grid(width);
  const auto maximum = multiples(parameters_.grid.maximum, width);
  const double minimum = bracket_.minimum();
  const std::array ends{multiples(bracket_.lower(), width),
                        bracket_.upper() ? multiples(*bracket_.upper(), width) : maximum, maximum};
  std::int64_t infeasible = 0;
  auto not_infeasible = std::numeric_limits<std::int64_t>::max();
  bracket_.prove_lower(0);
  bracket_.move_upper(std::nullopt);
  const auto decide = [&](std::int64_t cell) {
    const auto decided =
        decisions_.tree(BracketSide::lower, grid.at(cell), CriticalPhase::lower_bound, {},
                        [](const DecidedTree& all) { return all.is_proved_infeasible(); });
    if (!decided.solved()) return decided.status;
    (decided.is_proved_infeasible() ? infeasible : not_infeasible) = cell;
    if (decided.is_proved_infeasible()) bracket_.prove_lower(grid.at(cell));
    if (const auto* const leaf = decided.first(LeafState::feasible);
        leaf && decided.feasible != 0) {
      const auto block = problems::blocks_of(problem_)[leaf->block];
      bracket_.prove_upper(grid.at(cell), {leaf->block, own_leaf(*leaf, block)});
      set_known({*leaf});
    }
    bracket_.show();
    return decided.status;
  };
  auto status = engine::Status::solved;
  const auto goes_on = [&] { return status == engine::Status::solved; };
  for (const auto end : ends)
    if (goes_on() && end > infeasible && end < not_infeasible && grid.at(end) >= minimum)
      status = decide(end);
  while (goes_on() && not_infeasible <= maximum && not_infeasible - infeasible > 1 &&
         grid.at(std::midpoint(infeasible, not_infeasible)) >= minimum)
    status = decide(std::midpoint(infeasible, not_infeasible));
  return status;
}

// Decreases the lower bound until the exact test proves infeasibility. Without friction nothing is
// wedged, since K is definite; smaller coefficients than the least supported one are not computed.
engine::Status CriticalBounds::prove_lower() {
  if (bracket_.lower_proved() && !recorder_) return engine::Status::solved;
  if (forms_are_the_bound()) {
    record_forms();
    return engine::Status::solved;
  }
  const double minimum = bracket_.minimum();
  const auto all_infeasible = [](const DecidedTree& decided) { return decided.all_infeasible(); };
  std::optional<double> infeasible;  // by the bounds of the solver
  double factor = bracket_.lower();
  double step = parameters_.grid.width;
  for (int move = 0; move < max_moves && factor >= minimum; ++move, step *= growth) {
    const auto decided = decisions_.tree(BracketSide::lower, factor, CriticalPhase::lower_bound,
                                         recorder_, all_infeasible);
    if (!decided.solved()) return decided.status;
    if (decided.all_infeasible() && !infeasible) infeasible = factor;
    if (decided.is_proved_infeasible()) {
      bracket_.prove_lower(factor);
      return engine::Status::solved;
    }
    factor -= step;
  }
  bracket_.move_lower(infeasible.value_or(0));
  if (bracket_.lower() <= proved_lower_) bracket_.prove_lower(proved_lower_);
  return engine::Status::solved;
}

// Increases the upper bound until the exact test proves the leaf feasible. A flat leaf remains
// degenerate at larger coefficients; then another pattern may be solid there.
engine::Status CriticalBounds::prove_upper() {
  const auto recorded =
      recorder_ && !parameters_.list ? LeafRecord::within_limits : LeafRecord::none;
  if (bracket_.upper_proved() && recorded == LeafRecord::none) return engine::Status::solved;
  const auto leaf = *bracket_.leaf();
  std::optional<double> feasible;
  bool others_decided = false;  // by the other patterns, after the first degenerate point
  double factor = *bracket_.upper();
  double step = parameters_.grid.width;
  for (int move = 0; move < max_moves && factor <= parameters_.grid.maximum;
       ++move, step *= growth) {
    auto decided = decisions_.leaf(leaf, factor, recorded);
    if (analysis_.ended() && !decided.holds) return analysis_.stop_reason();
    if (decided.holds) {
      bracket_.prove_upper(factor, leaf);
      set_known(std::move(decided.found));
      return engine::Status::solved;
    }
    if (decided.is_feasible() && !feasible) {
      feasible = factor;
      set_known(decided.found);
    }
    if (decided.is(LeafState::flat)) break;
    if (decided.degenerate && !others_decided) {
      others_decided = true;
      const auto status = prove_by_any(factor);
      if (status != engine::Status::solved || known_at(factor)) return status;
    }
    factor += step;
  }
  // The list decides the known upper bound.
  if (feasible || !parameters_.list) bracket_.move_upper(feasible);
  return prove_by_any(feasible.value_or(std::min(factor, parameters_.grid.maximum)));
}

// Proves the upper bound by any feasible pattern, if the known leaf is degenerate.
engine::Status CriticalBounds::prove_by_any(double factor) {
  if (parameters_.list || parameters_.grid.precision == Precision::doubles)
    return engine::Status::solved;
  const auto decided = decisions_.tree(BracketSide::upper, factor, CriticalPhase::upper_bound,
                                       recorder_, &DecidedTree::has_cone);
  if (!decided.solved()) return decided.status;
  for (const LeafState state : {LeafState::feasible, LeafState::flat}) {
    const auto* const found = decided.first(state);
    if (found == nullptr) continue;
    const auto block = problems::blocks_of(problem_)[found->block];
    bracket_.move_upper(factor, {found->block, own_leaf(*found, block)});
    if (decided.feasible != 0) bracket_.prove_upper(factor, *bracket_.leaf());
    set_known({*found});
    break;
  }
  return engine::Status::solved;
}

engine::Status CriticalBounds::list(CriticalFindings& findings) {
  const double factor = bracket_.upper().value_or(parameters_.grid.maximum);
  const auto decided = decisions_.tree(BracketSide::upper, factor, CriticalPhase::list, recorder_,
                                       &DecidedTree::has_cone, parameters_.list_nodes);
  std::vector<Configuration> cones;
  std::ranges::copy_if(decided.leaves, std::back_inserter(cones), &Configuration::is_cone);
  const bool own_limit = decided.status == engine::Status::node_limit && !analysis_.ended();
  if (!decided.solved()) {
    findings.open_points.push_back(OpenPoint::list_not_complete);
    if (recorder_ && own_limit && bracket_.upper_proved())
      decisions_.leaf(*bracket_.leaf(), *bracket_.upper(), LeafRecord::after_stop);
    for (const auto& leaf : cones)
      if (known_.empty() || !(leaf.pattern == known_.front().pattern)) known_.push_back(leaf);
    return own_limit ? engine::Status::solved : decided.status;
  }
  if (cones.size() < decided.leaves.size())
    findings.open_points.push_back(OpenPoint::list_not_complete);
  if (cones.empty()) return engine::Status::solved;
  if (!bracket_.upper_proved() && decided.feasible != 0)
    bracket_.prove_upper(factor, *bracket_.leaf());
  set_known(std::move(cones));
  return engine::Status::solved;
}

void CriticalBounds::note_patterns(CriticalFindings& findings) const {
  if (!bracket_.leaf() || !bracket_.upper()) return;
  if (known_leaf_ == bracket_.leaf())
    for (const auto& leaf : known_) findings.patterns.push_back(entry_of(leaf, bracket_));
  if (!findings.patterns.empty()) return;
  const auto& [block, own] = *bracket_.leaf();
  const auto candidates = problems::blocks_of(problem_)[block];
  findings.patterns.push_back(
      {.block = block,
       .pattern = {.contact = problems::in_whole(own.contact, candidates),
                   .separated = problems::in_whole(own.separated, candidates),
                   .inactive = {}},
       .lower = bracket_.lower(),
       .upper = bracket_.upper(),
       .reaction = {},
       .displacement = {}});
}

void CriticalBounds::note_undecided(CriticalFindings& findings) const {
  if (findings.status != engine::Status::solved) return;
  const double width = parameters_.grid.width;
  const auto& found = findings.bracket;
  if (!found.upper && found.at_least() < parameters_.grid.maximum)
    findings.open_points.push_back(OpenPoint::no_upper_bound);
  if (found.upper && found.width() > wide * width)
    findings.open_points.push_back(OpenPoint::wide_bracket);
  if (!is_proved(found.lower)) findings.open_points.push_back(OpenPoint::lower_not_proved);
}

void CriticalBounds::prove(CriticalFindings& findings) {
  const auto stopped = [&](CriticalPhase phase, engine::Status status) {
    findings.status = status;
    if (status != engine::Status::solved) findings.stopped_in = phase;
    return status != engine::Status::solved;
  };
  bracket_.show();
  if (findings.status == engine::Status::solved && !decisions_.enclose())
    stopped(CriticalPhase::lower_bound, analysis_.stop_reason());
  if (findings.status == engine::Status::solved && decisions_.needs_bisection())
    stopped(CriticalPhase::lower_bound, bisect());
  if (findings.status == engine::Status::solved &&
      !stopped(CriticalPhase::lower_bound, prove_lower())) {
    bracket_.show();
    if (bracket_.leaf() && bracket_.upper() &&
        !stopped(CriticalPhase::upper_bound, prove_upper()) && parameters_.list)
      stopped(CriticalPhase::list, list(findings));
  }
  if (findings.status != engine::Status::solved && recorder_) record_proved_bounds();
  findings.bracket = bracket_.bracket();
  findings.exact = decisions_.is_exact();
  if (decisions_.leaves_out_large_displacements())
    findings.displacement_ratio = verify::largest_displacement_ratio;
  if (findings.patterns.empty()) note_patterns(findings);
  note_undecided(findings);
}

}  // namespace kusabi::wedged
