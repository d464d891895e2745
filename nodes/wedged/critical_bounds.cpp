// Verification of one leaf or of one tree of sign patterns, repeated if a bound has to be relaxed.
#include "nodes/wedged/critical_bounds.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <numeric>
#include <utility>

#include <boost/serialization/vector.hpp>

#include "engine/collectives.hpp"
#include "nodes/wedged/critical/smallest_search.hpp"
#include "nodes/wedged/friction/critical_friction.hpp"
#include "nodes/wedged/pattern_search.hpp"
#include "nodes/wedged/tree/candidate_friction.hpp"
#include "nodes/wedged/tree/maximal_cones.hpp"
#include "nodes/wedged/tree/preparation.hpp"
#include "nodes/wedged/tree/stiffness_enclosure.hpp"
#include "problems/wedged/problem_block.hpp"
#include "problems/wedged/scale_ratio.hpp"

namespace kusabi::wedged {

struct DecidedBound {
  engine::Status status = engine::Status::solved;
  std::vector<Configuration> leaves;  ///< maximal cones and undecided leaves
  std::uint64_t feasible = 0;         ///< leaves that the exact test proves feasible
  std::uint64_t unproved = 0;         ///< nodes whose evidence it refuses, or which are undecided

  template <class Archive>
  void serialize(Archive& archive, unsigned /*version*/) {
    archive& status& leaves& feasible& unproved;
  }

  [[nodiscard]] bool solved() const { return status == engine::Status::solved; }
  [[nodiscard]] bool all_infeasible() const { return leaves.empty(); }
  /// Null: there is none.
  [[nodiscard]] const Configuration* first(LeafState state) const {
    const auto found = std::ranges::find(leaves, state, &Configuration::state);
    return found == leaves.end() ? nullptr : &*found;
  }
  [[nodiscard]] bool is_proved_infeasible() const { return all_infeasible() && unproved == 0; }
};

/// A leaf at one coefficient.
struct CriticalBounds::DecidedLeaf {
  std::vector<Configuration> found;  ///< the leaf, if it is not infeasible
  bool holds = false;                ///< feasible by the exact test
  bool degenerate = false;           ///< t* = 0 within the tolerance: undecided

  template <class Archive>
  void serialize(Archive& archive, unsigned /*version*/) {
    archive& found& holds& degenerate;
  }

  [[nodiscard]] bool is(LeafState state) const {
    return !found.empty() && found.front().state == state;
  }
  [[nodiscard]] bool is_feasible() const { return is(LeafState::feasible) || is(LeafState::flat); }
};

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
      structure_(structure),
      problem_(problem),
      parameters_(parameters),
      recorder_(recorder),
      bracket_(bracket),
      costs_(costs),
      badly_scaled_(problem.modes.matrix.cols() > 0 &&
                    problems::scale_ratio(structure, problem) > wide_scales) {}

bool CriticalBounds::enclose() {
  if (!stiffness_) stiffness_ = enclosed_within(analysis_, structure_, enclosed_stiffness);
  return stiffness_.has_value();
}

std::shared_ptr<const EvidenceCheck> CriticalBounds::check(
    std::span<const double> friction, std::span<const ProvedBound> bounds) const {
  const auto* const stiffness = std::get_if<verify::EnclosedProblem>(&*stiffness_);
  if (stiffness == nullptr) return nullptr;
  return std::make_shared<const EvidenceCheck>(
      problem_, *stiffness, friction, bounds,
      badly_scaled_ ? LargeDisplacements::counted : LargeDisplacements::left_out);
}

CriticalBounds::Test CriticalBounds::test(std::shared_ptr<const EvidenceCheck> check) const {
  return [badly_scaled = badly_scaled_, check = std::move(check)](const Evidence& evidence) {
    return check ? check->holds(evidence)
                 : !badly_scaled && evidence.kind != Evidence::Kind::marginal;
  };
}

conic::Tolerances CriticalBounds::tolerances() const {
  auto tolerances = CriticalFriction::tolerances;
  if (badly_scaled_) tolerances.resolution = exact_test_resolution;
  return tolerances;
}

void CriticalBounds::set_known(std::vector<Configuration> found) {
  known_ = std::move(found);
  known_leaf_ = bracket_.leaf();
}

void CriticalBounds::prove_at_once() {
  if (!enclose()) return;
  if (bracket_.leaf() && !bracket_.upper_proved()) {
    const double factor = *bracket_.upper();
    auto decided = decide_leaf(*bracket_.leaf(), factor, LeafRecord::none);
    if (decided.holds) {
      bracket_.prove_upper(factor, *bracket_.leaf());
      set_known(std::move(decided.found));
    }
  }
  const double factor = bracket_.lower();
  if (!bracket_.lower_proved() && roots_are_infeasible(factor)) {
    bracket_.prove_lower(factor);
    proved_lower_ = factor;
  }
  bracket_.show();
}

Evidence CriticalBounds::form_of(std::uint32_t block) const {
  return {
      .kind = Evidence::Kind::form, .block = block, .node = {}, .numbers = forms_.numbers[block]};
}

// If K cannot be enclosed, the proof in doubles (form_proves_infeasible) is sufficient.
void CriticalBounds::prove_by_forms(QuadraticForms forms) {
  if (!enclose()) {
    bracket_.raise_lower(forms.factor);
    return;
  }
  forms_ = std::move(forms);
  const bool holds = analysis_.by_first_rank([&] {
    const auto accepts = test(check(candidate_friction(problem_, forms_.factor)));
    for (std::uint32_t block = 0; block < forms_.numbers.size(); ++block)
      if (!accepts(form_of(block))) return false;
    return true;
  });
  if (holds) {
    bracket_.prove_lower(forms_.factor);
    proved_lower_ = forms_.factor;
  } else {
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

// Of a run that was stopped: the form, and one cone program for the leaf.
void CriticalBounds::record_proved_bounds() {
  if (forms_are_the_bound() && !forms_recorded_) record_forms();
  if (bracket_.upper_proved() && !parameters_.list)
    decide_leaf(*bracket_.leaf(), *bracket_.upper(), LeafRecord::after_stop);
}

bool CriticalBounds::roots_are_infeasible(double factor) {
  return analysis_.by_first_rank([&] {
    const auto friction = candidate_friction(problem_, factor);
    SignPatternTree tree(
        problem_, friction,
        {.tolerances = CriticalFriction::tolerances, .precision = Precision::doubles});
    tree.end_when(analysis_.budget().stop());
    const auto accepts = test(check(friction));
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

CriticalBounds::DecidedLeaf CriticalBounds::decide_leaf(const PatternNode& leaf, double factor,
                                                        LeafRecord kind) {
  const auto friction = candidate_friction(problem_, factor);
  const auto record =
      kind == LeafRecord::none ? nullptr : recorder_(BracketSide::upper, factor, friction);
  const auto decide = [&] {
    DecidedLeaf decided;
    SignPatternTree tree(
        problem_, friction,
        {.tolerances = tolerances(), .thorough = true, .precision = parameters_.grid.precision});
    if (kind != LeafRecord::after_stop) tree.end_when(analysis_.budget().stop());
    const auto accepts = test(check(friction));
    tree.report_to([&](const auto& evidence) {
      if (record) record->add(evidence);
      decided.holds = evidence.kind == Evidence::Kind::feasible && accepts(evidence);
      decided.degenerate = evidence.kind == Evidence::Kind::marginal;
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

/// Decides all sign patterns at one coefficient and adds the costs.
/// @param wanted true for results to be recorded
template <class Wanted>
DecidedBound CriticalBounds::decide(BracketSide side, double factor, CriticalPhase phase,
                                    const BoundRecorder& recorder, Wanted wanted,
                                    std::uint64_t nodes) {
  const auto friction = candidate_friction(problem_, factor);
  const SignPatternOptions options{.tolerances = tolerances(),
                                   .tightening = parameters_.tightening,
                                   .thorough = true,
                                   .precision = parameters_.grid.precision};
  SignPatternTree tree(problem_, friction, options);
  auto prepared = prepare(analysis_, problem_, friction, options);
  const auto exact = check(friction, proved_bounds(prepared));
  if (exact && exact->is_able() && !exact->proves_bounds()) remove_bounds(prepared);
  configure(tree, prepared);
  const auto bounds = proved_bounds(prepared);
  const auto record = recorder ? recorder(side, factor, friction) : nullptr;
  tree.test_with(test(exact), badly_scaled_);
  if (record) tree.report_to([&record](const auto& evidence) { record->add(evidence); });
  engine::Options search;
  search.limits.nodes = nodes;
  // A record is written by one rank.
  auto outcome = record ? analysis_.search_anew(tree, search) : analysis_.search(tree, search);
  costs_.push_back({phase, factor, outcome.opened(), outcome.opened()});
  auto decided = engine::from_first_rank(analysis_.transport(), [&] {
    std::vector<Configuration> leaves;
    for (auto& found : outcome.solutions) leaves.push_back(std::move(found.solution));
    const auto judged = outcome.tally();
    return DecidedBound{.status = outcome.status,
                        .leaves = maximal_cones(std::move(leaves)),
                        .feasible = judged.proved,
                        .unproved = judged.doubted + judged.unproved};
  });
  if (record) record->end(bounds, BoundClaim::all_patterns, decided.solved() && wanted(decided));
  return decided;
}

// Bisection by the exact test alone: a leaf feasible at a coefficient is feasible at all larger
// ones. The bracket of the search is tested first.
engine::Status CriticalBounds::bisect() {
  const double width = parameters_.grid.width;
  const FrictionGrid grid(width);
  const auto maximum = multiples(parameters_.grid.maximum, width);
  const double minimum = CriticalFriction::range(problem_).minimum;
  const std::array ends{multiples(bracket_.lower(), width),
                        bracket_.upper() ? multiples(*bracket_.upper(), width) : maximum, maximum};
  std::int64_t infeasible = 0;
  auto not_infeasible = std::numeric_limits<std::int64_t>::max();
  bracket_.prove_lower(0);
  bracket_.move_upper(std::nullopt);
  const auto ask = [&](std::int64_t cell) {
    const auto decided = decide(
        BracketSide::lower, grid.at(cell), CriticalPhase::lower_bound, {},
        [](const DecidedBound& all) { return all.is_proved_infeasible(); }, engine::Limits{}.nodes);
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
    if (goes_on() && end > infeasible && end < not_infeasible && grid.at(end) > minimum)
      status = ask(end);
  while (goes_on() && not_infeasible <= maximum && not_infeasible - infeasible > 1 &&
         grid.at(std::midpoint(infeasible, not_infeasible)) > minimum)
    status = ask(std::midpoint(infeasible, not_infeasible));
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
  const double minimum = CriticalFriction::range(problem_).minimum;
  const auto all_infeasible = [](const DecidedBound& decided) { return decided.all_infeasible(); };
  std::optional<double> infeasible;  // by the bounds of the solver
  double factor = bracket_.lower();
  double step = parameters_.grid.width;
  for (int move = 0; move < max_moves && factor >= minimum; ++move, step *= growth) {
    const auto decided = decide(BracketSide::lower, factor, CriticalPhase::lower_bound, recorder_,
                                all_infeasible, engine::Limits{}.nodes);
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
    auto decided = decide_leaf(leaf, factor, recorded);
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
  bracket_.move_upper(feasible);
  return prove_by_any(feasible.value_or(std::min(factor, parameters_.grid.maximum)));
}

// Proves the upper bound by any feasible pattern, if the known leaf is degenerate.
engine::Status CriticalBounds::prove_by_any(double factor) {
  if (parameters_.list || parameters_.grid.precision == Precision::doubles)
    return engine::Status::solved;
  const auto decided = decide(
      BracketSide::upper, factor, CriticalPhase::upper_bound, recorder_,
      [](const DecidedBound& all) {
        return std::ranges::any_of(all.leaves, &Configuration::is_cone);
      },
      engine::Limits{}.nodes);
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
  const auto decided = decide(
      BracketSide::upper, factor, CriticalPhase::list, recorder_,
      [](const DecidedBound& all) {
        return std::ranges::any_of(all.leaves, &Configuration::is_cone);
      },
      parameters_.list_nodes);
  std::vector<Configuration> cones;
  std::ranges::copy_if(decided.leaves, std::back_inserter(cones), &Configuration::is_cone);
  const bool own_limit = decided.status == engine::Status::node_limit && !analysis_.ended();
  if (!decided.solved()) {
    findings.doubts.push_back(CriticalDoubt::list_not_complete);
    for (const auto& leaf : cones)
      if (known_.empty() || !(leaf.pattern == known_.front().pattern)) known_.push_back(leaf);
    return own_limit ? engine::Status::solved : decided.status;
  }
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
  if (!findings.upper && findings.lower < parameters_.grid.maximum)
    findings.doubts.push_back(CriticalDoubt::no_upper_bound);
  if (findings.upper && *findings.upper - findings.lower > wide * width)
    findings.doubts.push_back(CriticalDoubt::wide_bracket);
  if (!findings.lower_proved) findings.doubts.push_back(CriticalDoubt::lower_not_proved);
}

void CriticalBounds::prove(CriticalFindings& findings) {
  const auto stopped = [&](CriticalPhase phase, engine::Status status) {
    findings.status = status;
    if (status != engine::Status::solved) findings.stopped_in = phase;
    return status != engine::Status::solved;
  };
  bracket_.show();
  if (findings.status == engine::Status::solved && !enclose())
    stopped(CriticalPhase::lower_bound, analysis_.stop_reason());
  if (findings.status == engine::Status::solved && needs_bisection())
    stopped(CriticalPhase::lower_bound, bisect());
  if (findings.status == engine::Status::solved &&
      !stopped(CriticalPhase::lower_bound, prove_lower())) {
    bracket_.show();
    if (bracket_.leaf() && bracket_.upper() &&
        !stopped(CriticalPhase::upper_bound, prove_upper()) && parameters_.list)
      stopped(CriticalPhase::list, list(findings));
  }
  if (findings.status != engine::Status::solved && recorder_) record_proved_bounds();
  findings.lower = bracket_.lower();
  findings.upper = bracket_.upper();
  findings.lower_proved = bracket_.lower_proved();
  findings.upper_proved = bracket_.upper_proved();
  findings.exact = stiffness_ && std::holds_alternative<verify::EnclosedProblem>(*stiffness_);
  if (findings.patterns.empty()) note_patterns(findings);
  note_undecided(findings);
}

}  // namespace kusabi::wedged
