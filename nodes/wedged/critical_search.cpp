// Two ways to the bracket.
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

/// Which of the searches for the smallest it is.
struct SmallestSearch {
  CriticalDirection direction;
  CriticalPhase phase;
  double width;
  double known;  ///< nothing wedges below
  double most;
};

// Bounds at one coefficient hold at all smaller ones, since cones grow with friction.
// @return programs solved
std::uint64_t bound_blocks(engine::Campaign& campaign, const problems::WedgedProblem& problem,
                           double most, CriticalTree& tree) {
  if (problem.motions.cols() > 0) return 0;
  std::uint64_t programs = 0;
  const auto blocks = problems::blocks_of(problem);
  const auto friction = candidate_friction(problem, most);
  for (std::uint32_t block = 0; block < blocks.size(); ++block) {
    if (blocks[block].size() < fewest_to_bound) continue;
    auto root = bound_candidates(campaign, problem, friction, block, CriticalFriction::tolerances);
    programs += root.programs;
    tree.split_by(block, Branching::weighed);
    tree.tighten(block, std::move(root.bounds));
  }
  return programs;
}

CriticalFindings smallest(engine::Campaign& campaign, const problems::WedgedProblem& problem,
                          const SmallestSearch& asked, std::vector<CriticalCost>& costs) {
  const auto& [direction, phase, width, known, most] = asked;
  CriticalTree tree(problem, width, multiples(most, width), direction, known);
  std::uint64_t programs = 0;
  if (direction == CriticalDirection::down) {
    const auto blocks = problems::blocks_of(problem);
    for (std::size_t block = 0; block < blocks.size(); ++block)
      tree.split_by(block, untried_branching(blocks[block].size()));
    // Near the least coefficient at which anything lives bounds leave little; far above it they
    // cost more than they save.
    if (phase == CriticalPhase::fine) programs = bound_blocks(campaign, problem, most, tree);
  }
  engine::Options options;
  options.goal = engine::Goal::best;
  options.order =
      direction == CriticalDirection::up ? engine::Order::best_first : engine::Order::depth_first;
  auto outcome = campaign.search(tree, options);
  costs.push_back({phase, direction == CriticalDirection::up ? known : most, outcome.opened(),
                   programs + outcome.tally().programs});
  CriticalFindings findings;
  findings.status = engine::from_first_rank(campaign.transport(), [&] { return outcome.status; });
  if (!campaign.is_first()) return findings;
  const bool whole = outcome.status == engine::Status::solved;
  findings.lower = whole ? most : std::min(most, std::max(known, outcome.bound));
  for (const auto& found : outcome.solutions) {
    const auto& cell = found.solution.cell;
    findings.lower = std::min(findings.lower, width * static_cast<double>(cell.dead));
    findings.upper = width * static_cast<double>(cell.alive);
  }
  // A leaf that is doubtful from further down on is opened on any schedule.
  findings.lower = std::min(findings.lower, outcome.tally().doubt.value);
  findings.global_ranks = std::move(outcome.ranks);
  return findings;
}

// Down from the first of growing coefficients at which anything lives: where nearly everything
// does, far above the smallest, a search comes upon many leaves that are of no use. What it comes
// upon on its way is found to a few digits, and the rest between the ends of that bracket.
CriticalFindings descend(engine::Campaign& campaign, const problems::WedgedProblem& problem,
                         double width, double most, std::vector<CriticalCost>& costs) {
  const auto search = [&](CriticalPhase phase, double step, double known, double from) {
    return smallest(campaign, problem, {CriticalDirection::down, phase, step, known, from}, costs);
  };
  double known = 0;
  double start = std::min(first_start, most);
  for (;;) {
    double coarse = width;
    while (coarse < few_digits * start) coarse *= 2;
    // A search says nothing of what is beyond the last point of its grid.
    const double reach = coarse == width ? start : coarse * std::floor(start / coarse);
    auto findings = search(CriticalPhase::coarse, coarse, known, reach);
    const auto found = engine::from_first_rank(campaign.transport(), [&] {
      return Bracket{findings.status, findings.lower, or_infinity(findings.upper)};
    });
    if (found.status != engine::Status::solved) return findings;
    if (std::isfinite(found.upper) || found.lower < reach) {  // something lives, or may live
      if (coarse == width) return findings;
      return search(CriticalPhase::fine, width, found.lower, std::min(found.upper, most));
    }
    if (start >= most) {
      if (reach == most) return findings;
      return search(CriticalPhase::fine, width, reach, most);
    }
    known = reach;
    start = std::min(most, next_start * start);
  }
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
  for (const auto& found : outcome.solutions) {
    const auto& [number, cell] = found.solution;
    const auto& leaf = living.leaves[number];
    CriticalEntry entry{.block = leaf.block,
                        .pattern = leaf.pattern,
                        .lower = width * static_cast<double>(cell.dead),
                        .upper = {},
                        .reaction = {},
                        .displacement = {}};
    if (cell.alive != CriticalCell::nowhere) entry.upper = width * static_cast<double>(cell.alive);
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
      case CriticalWay::descent:
        return descend(campaign, problem, question.width, most, costs);
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
    prove_ends(campaign, structure, problem, {question.width, most, only_smallest}, recorder,
               findings);
  }
  return findings;
}

}  // namespace kusabi::wedged
