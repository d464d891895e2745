// Ways to the bracket.
#include "nodes/wedged/critical_search.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <stdexcept>
#include <utility>

#include <boost/serialization/vector.hpp>

#include "engine/together.hpp"
#include "nodes/wedged/branching_trial.hpp"
#include "nodes/wedged/candidate_friction.hpp"
#include "nodes/wedged/critical_dive.hpp"
#include "nodes/wedged/maximal_cones.hpp"
#include "nodes/wedged/pattern_brackets.hpp"
#include "nodes/wedged/preparation.hpp"
#include "problems/wedged/problem_block.hpp"

namespace kusabi::wedged {
namespace {

/// Where a descent starts, and how much farther up it starts anew where everything is dead.
constexpr double first_start = 1;
constexpr double next_start = 4;

/// Of a start.
constexpr double few_digits = 1e-2;

/// Where a descent looks next, of where something lives, until it knows where nothing does.
constexpr double share_of_last = 0.6;

/// A trial from below opens so many nodes a candidate, and no more than so many: a descent takes
/// more programs than that, and larger trees are the descent's.
constexpr std::uint64_t trial_nodes_a_candidate = 15;
constexpr std::uint64_t most_trial_nodes = 600;

/// Dives end where what is left to be told is from so much of it on.
constexpr double near_enough = 0.9;

std::int64_t multiples(double most, double width) {
  return static_cast<std::int64_t>(std::llround(most / width));
}

double or_infinity(const std::optional<double>& number) {
  return number.value_or(std::numeric_limits<double>::infinity());
}

// What all ranks must know of a bracket.
struct Bracket {
  engine::Status status = engine::Status::solved;
  double lower = 0, upper = 0;

  template <class Archive>
  void serialize(Archive& archive, unsigned /*version*/) {
    archive& status& lower& upper;
  }
};

// What lives or may live at the largest coefficient: maximal cones and open leaves.
struct Living {
  engine::Status status = engine::Status::solved;
  std::vector<Configuration> leaves;

  template <class Archive>
  void serialize(Archive& archive, unsigned /*version*/) {
    archive& status& leaves;
  }
};

Living living_patterns(engine::Campaign& campaign, const problems::WedgedProblem& problem,
                       double most, std::vector<CriticalCost>& costs) {
  SignPatternTree tree(problem, candidate_friction(problem, most));
  auto outcome = campaign.search(tree, {});
  costs.push_back({CriticalPhase::patterns, most, outcome.opened(), outcome.opened()});
  return engine::from_first_rank(campaign.transport(), [&] {
    std::vector<Configuration> leaves;
    for (auto& found : outcome.solutions) leaves.push_back(std::move(found.solution));
    return Living{outcome.status, maximal_cones(std::move(leaves))};
  });
}

// What a search for the smallest says of the bracket.
CriticalFindings findings_of(const engine::OutcomeOf<CriticalTree>& outcome, double width,
                             double known, double most) {
  CriticalFindings findings;
  findings.status = outcome.status;
  const bool whole = outcome.status == engine::Status::solved;
  findings.lower = whole ? most : std::min(most, std::max(known, outcome.bound));
  const FrictionGrid grid(width);
  for (const auto& found : outcome.solutions) {
    const auto& cell = found.solution.cell;
    findings.lower = std::min(findings.lower, grid.at(cell.dead));
    findings.upper = grid.at(cell.alive);
  }
  // A leaf that is doubtful from further down on is opened on any schedule.
  findings.lower = std::min(findings.lower, outcome.tally().doubt.value);
  findings.global_ranks = outcome.ranks;
  return findings;
}

/// Which of the searches for the smallest it is.
struct SmallestSearch {
  CriticalDirection direction;
  CriticalPhase phase;
  double width;
  double known;  ///< nothing wedges below
  double most;
  BlockBounds bounds{};  ///< at `most`; of a search downwards
};

CriticalFindings smallest(engine::Campaign& campaign, const problems::WedgedProblem& problem,
                          const SmallestSearch& asked, std::vector<CriticalCost>& costs) {
  const auto& [direction, phase, width, known, most, bounds] = asked;
  CriticalTree tree(problem, width, multiples(most, width), direction, known);
  if (direction == CriticalDirection::down) inform(tree, problem, bounds);
  engine::Options options;
  options.goal = engine::Goal::best;
  options.order =
      direction == CriticalDirection::up ? engine::Order::best_first : engine::Order::depth_first;
  auto outcome = campaign.search(tree, options);
  costs.push_back({phase, direction == CriticalDirection::up ? known : most, outcome.opened(),
                   bounds.programs + outcome.tally().programs});
  const auto status = engine::from_first_rank(campaign.transport(), [&] { return outcome.status; });
  if (campaign.is_first()) return findings_of(outcome, width, known, most);
  CriticalFindings findings;
  findings.status = status;
  return findings;
}

// What is known of the bracket before a descent begins.
struct Known {
  bool whole = false;                                      ///< it is the bracket
  double lower = 0;                                        ///< nothing wedges here, nor below
  double upper = std::numeric_limits<double>::infinity();  ///< something does
  std::uint64_t opened = 0, programs = 0;

  template <class Archive>
  void serialize(Archive& archive, unsigned /*version*/) {
    archive& whole& lower& upper& opened& programs;
  }
};

// What a trial from below says, and who has worked on it.
struct BelowTrial {
  Known known;
  std::vector<engine::RankReport<CriticalTree>> ranks;

  template <class Archive>
  void serialize(Archive& archive, unsigned /*version*/) {
    archive& known& ranks;
  }
};

// On the first rank alone, so that what it comes to depends on no timing; a part of the question,
// since what comes next depends on it.
BelowTrial trial_from_below(engine::Campaign& campaign, const problems::WedgedProblem& problem,
                            const CriticalQuestion& question, double most) {
  const double width = question.width;
  return campaign.by_first_rank([&] {
    CriticalTree tree(problem, width, multiples(most, width), CriticalDirection::up);
    engine::Options options;
    options.goal = engine::Goal::best;
    options.order = engine::Order::best_first;
    options.limits = campaign.budget().left();
    options.limits.nodes = question.trial_nodes.value_or(std::min(
        most_trial_nodes, trial_nodes_a_candidate * std::uint64_t{problem.contact_names.size()}));
    options.interrupt = campaign.budget().interrupt();
    const auto outcome = engine::search(tree, options);
    auto findings = findings_of(outcome, width, 0, most);
    return BelowTrial{.known = {.whole = outcome.status == engine::Status::solved,
                                .lower = findings.lower,
                                .upper = or_infinity(findings.upper),
                                .opened = outcome.opened(),
                                .programs = outcome.tally().programs},
                      .ranks = std::move(findings.global_ranks)};
  });
}

// Down from the first of growing coefficients at which anything lives: near to the smallest by
// dives, to few digits by a search of all, and to the rest by another. Near the smallest
// coefficient bounds leave little of their trees.
class Descent {
 public:
  Descent(engine::Campaign& campaign, const problems::WedgedProblem& problem,
          const CriticalQuestion& question, double most, std::vector<CriticalCost>& costs,
          const Known& known = {})
      : campaign_(campaign),
        problem_(problem),
        tightening_(question.tightening),
        width_(question.width),
        most_(most),
        costs_(costs),
        known_dead_(known.lower) {
    if (std::isfinite(known.upper)) alive_ = known.upper;
  }

  CriticalFindings findings() {
    for (double start = std::min(alive_.value_or(first_start), most_);;
         start = std::min(most_, next_start * start)) {
      if (start <= known_dead_ && start < most_) continue;
      coarse_ = width_;
      while (coarse_ < few_digits * start) coarse_ *= 2;
      dead_ = std::max(dead_, coarse_ * std::floor(known_dead_ / coarse_));
      // A search says nothing of what is beyond the last point of its grid.
      const double reach = coarse_ == width_ ? start : coarse_ * std::floor(start / coarse_);
      dive(reach);
      auto found = narrow();
      if (engine::from_first_rank(campaign_.transport(), [&] { return found.status; }) !=
          engine::Status::solved)
        return found;
      if (alive_ || dead_ < reach) {  // something lives, or may live
        if (coarse_ == width_) return found;
        return search(CriticalPhase::fine, width_, std::min(alive_.value_or(most_), most_));
      }
      if (start >= most_) {
        if (reach == most_) return found;
        return search(CriticalPhase::fine, width_, most_);
      }
    }
  }

 private:
  // From where something lives down to a share of that, then to the middle of what is left between
  // that and where nothing lives, or a dive could not tell.
  void dive(double reach) {
    from_ = reach;
    bounds_ = {};
    double untold = 0;
    if (alive_ && !goes_on(untold)) return;
    for (;;) {
      const auto found =
          dive_at(campaign_, problem_, std::llround(from_ / coarse_), coarse_, bounds_);
      costs_.push_back({CriticalPhase::dive, from_, found.opened, found.opened + bounds_.programs});
      bounds_.programs = 0;  // they are told of
      if (std::isfinite(found.alive)) {
        alive_ = found.alive;
      } else {
        (found.all_dead ? dead_ : untold) = from_;
      }
      if (!alive_ || !goes_on(untold)) return;
    }
  }

  // Where to look next, below what is alive. @return whether by a dive
  bool goes_on(double untold) {
    const double last = coarse_ * static_cast<double>(std::llround(*alive_ / coarse_) - 1);
    if (last <= dead_) return false;
    const double least = std::max(dead_, untold);
    const bool near = least > near_enough * *alive_;
    const double next = least > 0 ? std::sqrt(least * *alive_) : share_of_last * *alive_;
    const double below = std::max(coarse_ * std::floor(next / coarse_), dead_ + coarse_);
    from_ = near ? last : std::min(below, last);
    bounds_ = bounds_at(campaign_, problem_, from_, tightening_);
    return !near;
  }

  // What the dives have left.
  CriticalFindings narrow() {
    CriticalFindings findings;
    const double end = alive_ ? *alive_ - 1.5 * coarse_ : from_;  // below its last point
    if (dead_ < end) {
      findings = search(CriticalPhase::coarse, coarse_, from_);
      const auto found = engine::from_first_rank(campaign_.transport(), [&] {
        return Bracket{findings.status, findings.lower, or_infinity(findings.upper)};
      });
      dead_ = found.lower;
      if (std::isfinite(found.upper)) alive_ = found.upper;
    }
    findings.lower = dead_;
    findings.upper = alive_;
    return findings;
  }

  CriticalFindings search(CriticalPhase phase, double width, double from) {
    if (phase == CriticalPhase::fine || bounds_.blocks.empty())
      bounds_ = bounds_at(campaign_, problem_, from, tightening_);
    return smallest(
        campaign_, problem_,
        {CriticalDirection::down, phase, width, std::max(dead_, known_dead_), from, bounds_},
        costs_);
  }

  engine::Campaign& campaign_;
  const problems::WedgedProblem& problem_;
  Tightening tightening_;
  double width_, most_;
  std::vector<CriticalCost>& costs_;
  double known_dead_;            // as dead_, but not on that grid
  double coarse_ = 0;            // the width of the grid of a start
  double from_ = 0;              // where the next search begins
  double dead_ = 0;              // nothing lives here, nor below
  std::optional<double> alive_;  // something does
  BlockBounds bounds_;           // at `from_`
};

// Whether anything lives at the largest coefficient, if it was given: it may be there to ask that,
// and a descent from there would begin so, too.
Known known_at_most(engine::Campaign& campaign, const problems::WedgedProblem& problem,
                    const CriticalQuestion& question, std::vector<CriticalCost>& costs) {
  Known known;
  if (!question.most) return known;
  const auto dive =
      dive_at(campaign, problem, multiples(*question.most, question.width), question.width, {});
  costs.push_back({CriticalPhase::dive, *question.most, dive.opened, dive.opened});
  known.whole = dive.all_dead;
  if (dive.all_dead) known.lower = *question.most;
  known.upper = dive.alive;
  return known;
}

// From below for so many nodes: of small trees that is the answer, of others a lower end to go
// down to.
CriticalFindings either_way(engine::Campaign& campaign, const problems::WedgedProblem& problem,
                            const CriticalQuestion& question, double most,
                            std::vector<CriticalCost>& costs) {
  CriticalFindings findings;
  auto known = known_at_most(campaign, problem, question, costs);
  if (!known.whole) {
    const double upper = known.upper;
    auto trial = trial_from_below(campaign, problem, question, most);
    known = trial.known;
    if (campaign.is_first()) findings.global_ranks = std::move(trial.ranks);
    costs.push_back({CriticalPhase::trial, 0, known.opened, known.programs});
    if (!known.whole) known.upper = std::min(known.upper, upper);
  }
  if (!known.whole) return Descent(campaign, problem, question, most, costs, known).findings();
  findings.lower = known.lower;
  if (std::isfinite(known.upper)) findings.upper = known.upper;
  return findings;
}

CriticalFindings pattern_by_pattern(engine::Campaign& campaign,
                                    const problems::WedgedProblem& problem, CriticalMethod method,
                                    double width, double most, std::vector<CriticalCost>& costs) {
  CriticalFindings findings;
  const auto living = living_patterns(campaign, problem, most, costs);
  findings.status = living.status;
  // A part of them would say nothing.
  if (findings.status != engine::Status::solved) return findings;
  auto outcome =
      bracket_patterns(campaign, problem, living.leaves, method, width, multiples(most, width));
  costs.push_back({CriticalPhase::coefficients, most, outcome.opened(), outcome.tally().programs});
  findings.status = engine::from_first_rank(campaign.transport(), [&] { return outcome.status; });
  if (!campaign.is_first()) return findings;
  const FrictionGrid grid(width);
  for (const auto& found : outcome.solutions) {
    const auto& [number, cell] = found.solution;
    const auto& leaf = living.leaves[number];
    CriticalEntry entry{.block = leaf.block,
                        .pattern = leaf.pattern,
                        .lower = grid.at(cell.dead),
                        .upper = {},
                        .reaction = {},
                        .displacement = {}};
    if (cell.alive != CriticalCell::nowhere) entry.upper = grid.at(cell.alive);
    findings.patterns.push_back(std::move(entry));
  }
  findings.bisection_ranks = std::move(outcome.ranks);
  findings.conclude(findings.status == engine::Status::solved ? most : 0);
  return findings;
}

}  // namespace

void CriticalFindings::conclude(double dead) {
  std::sort(patterns.begin(), patterns.end(), [](const auto& a, const auto& b) {
    const double from_a = or_infinity(a.upper);
    const double from_b = or_infinity(b.upper);
    if (from_a != from_b) return from_a < from_b;
    if (a.block != b.block) return a.block < b.block;
    return a.pattern.contact < b.pattern.contact;
  });
  lower = dead;
  if (patterns.empty()) return;
  upper = patterns.front().upper;
  for (const auto& entry : patterns) lower = std::min(lower, entry.lower);
}

CriticalFindings find_critical_friction(engine::Campaign& campaign,
                                        const problems::Structure& structure,
                                        const problems::WedgedProblem& problem,
                                        const CriticalQuestion& question,
                                        const EndRecorder& recorder) {
  const bool only_smallest = looks_for_smallest(question.way);
  if (!only_smallest && !question.most) {
    throw std::invalid_argument(
        "the patterns are looked for at the largest friction coefficient of interest, which must "
        "be given");
  }
  // No further than the roughest candidate can be computed with.
  const double most =
      question.most.value_or(std::min(usual_most, CriticalFriction::range(problem).most));
  if (!(question.width < most) || most > most_multiples * question.width) {
    throw std::invalid_argument(
        "the width of a bracket is below the largest friction coefficient, and no less than 1e-15 "
        "of it");
  }
  std::vector<CriticalCost> costs;
  const auto search = [&] {
    switch (question.way) {
      case CriticalWay::automatic:
        return either_way(campaign, problem, question, most, costs);
      case CriticalWay::descent:
        return Descent(campaign, problem, question, most, costs).findings();
      case CriticalWay::global:
        return smallest(campaign, problem,
                        {CriticalDirection::up, CriticalPhase::fine, question.width, 0, most},
                        costs);
      case CriticalWay::newton:
        return pattern_by_pattern(campaign, problem, CriticalMethod::newton, question.width, most,
                                  costs);
      case CriticalWay::bisection:
        break;
    }
    return pattern_by_pattern(campaign, problem, CriticalMethod::bisection, question.width, most,
                              costs);
  };
  auto findings = search();
  findings.costs = std::move(costs);
  if (findings.status == engine::Status::solved) {
    prove_ends(campaign, structure, problem,
               {question.width, most, question.tightening, only_smallest}, recorder, findings);
  }
  return findings;
}

}  // namespace kusabi::wedged
