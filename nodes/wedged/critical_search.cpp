// Strategies for the bracket of the critical coefficient.
#include "nodes/wedged/critical_search.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <stdexcept>
#include <utility>

#include <boost/serialization/vector.hpp>

#include "engine/collectives.hpp"
#include "nodes/wedged/critical/critical_descent.hpp"
#include "nodes/wedged/critical/critical_dive.hpp"
#include "nodes/wedged/critical/critical_start.hpp"
#include "nodes/wedged/critical/smallest_search.hpp"
#include "nodes/wedged/primal/primal_bracket.hpp"
#include "nodes/wedged/quadratic/quadratic_bracket.hpp"
#include "nodes/wedged/sweep/pattern_brackets.hpp"
#include "nodes/wedged/tree/candidate_friction.hpp"
#include "nodes/wedged/tree/maximal_cones.hpp"
#include "nodes/wedged/tree/tree_leaves.hpp"
#include "problems/wedged/problem_block.hpp"

namespace kusabi::wedged {
namespace {

/// Maximum number of nodes of a global search for each candidate, and in all; larger trees use
/// descent.
constexpr std::uint64_t trial_nodes_per_candidate = 15;
constexpr std::uint64_t max_trial_nodes = 600;

/// In doubles a leaf is numerically undecided within this many cells of its critical coefficient,
/// for every tree.
constexpr double undecided_cells = 16;

double or_infinity(const std::optional<double>& number) {
  return number.value_or(std::numeric_limits<double>::infinity());
}

// Feasible or undecided leaves at the largest coefficient: maximal cones and undecided leaves.
TreeLeaves feasible_patterns(engine::Analysis& analysis, const problems::WedgedProblem& problem,
                             double maximum, std::vector<CriticalCost>& costs) {
  SignPatternTree tree(problem, candidate_friction(problem, maximum));
  auto outcome = analysis.search(tree, {});
  costs.push_back({CriticalPhase::patterns, maximum, outcome.opened(), outcome.opened()});
  auto found = tree_leaves(analysis, outcome);
  found.leaves = maximal_cones(std::move(found.leaves));
  return found;
}

// Result of a limited global search, and the ranks' costs.
struct BelowTrial {
  SmallestCoefficient smallest;
  std::uint64_t opened = 0, programs = 0;
  std::vector<engine::RankReport<CriticalTree>> ranks;

  template <class Archive>
  void serialize(Archive& archive, unsigned /*version*/) {
    archive& smallest& opened& programs& ranks;
  }
};

// The search runs on the first rank, so that the result does not depend on timing. It belongs to
// the analysis of its caller, whose next steps depend on it.
BelowTrial trial_from_below(engine::Analysis& analysis, const problems::WedgedProblem& problem,
                            const CriticalParameters& parameters, const CriticalGrid& grid,
                            double known) {
  auto trial = analysis.by_first_rank([&] {
    CriticalTree tree(problem, grid.width, multiples(grid.maximum, grid.width),
                      CriticalDirection::up, known, grid.precision);
    engine::Options options;
    options.goal = engine::Goal::best;
    options.order = engine::Order::best_first;
    options.limits.nodes = parameters.trial_nodes.value_or(std::min(
        max_trial_nodes, trial_nodes_per_candidate * std::uint64_t{problem.contact_names.size()}));
    auto outcome = analysis.search_alone(tree, options);
    return BelowTrial{.smallest = smallest_coefficient(outcome, grid, known),
                      .opened = outcome.opened(),
                      .programs = outcome.tally().programs,
                      .ranks = std::move(outcome.ranks)};
  });
  analysis.count_nodes(trial.opened);
  return trial;
}

// Strategies for the smallest coefficient, with the steps before and between them.
class SmallestStrategies {
 public:
  SmallestStrategies(engine::Analysis& analysis, const problems::WedgedProblem& problem,
                     const CriticalParameters& parameters, const CriticalGrid& grid,
                     CriticalBounds& bounds, NarrowingBracket& bracket, CriticalFindings& findings)
      : analysis_(analysis),
        problem_(problem),
        parameters_(parameters),
        grid_(grid),
        bounds_(bounds),
        bracket_(bracket),
        findings_(findings) {}

  // Global search within a limit of nodes: small trees are solved, others get a lower bound for the
  // descent.
  void automatic() {
    if (start() || bound_by_first_forms() || search_patterns(PrimalPart::first) ||
        bound_by_forms(max_form_rounds) || search_patterns(PrimalPart::later) || known_at_most())
      return;
    if (stopped(CriticalPhase::dive)) return;
    if (try_from_below()) return;
    if (stopped(CriticalPhase::trial)) return;
    descend(analysis_, problem_, grid_, parameters_.tightening, bracket_, findings_);
  }

  void descent() {
    descend(analysis_, problem_, grid_, parameters_.tightening, bracket_, findings_);
  }

  void global() {
    const auto found =
        find_smallest(analysis_, problem_, {CriticalDirection::up, CriticalPhase::fine, grid_, 0},
                      findings_.costs, findings_.global_ranks);
    found.narrow(bracket_, grid_.width);
    findings_.status = found.status;
    if (found.status != engine::Status::solved) findings_.stopped_in = CriticalPhase::fine;
  }

 private:
  // Initial bracket without a tree. @return true: it is the answer, or the time is over
  bool start() {
    if (problem_.contact_names.size() < min_candidates_for_start) return false;
    const auto programs = start_bracket(analysis_, problem_, grid_, bracket_);
    findings_.costs.push_back({CriticalPhase::start, 0, 0, programs});
    bracket_.show();
    if (stopped(CriticalPhase::start)) return true;
    bounds_.prove_at_once();
    if (stopped(CriticalPhase::start)) return true;
    return is_answered();
  }

  [[nodiscard]] bool is_answered() const {
    const double cells = grid_.precision == Precision::doubles ? undecided_cells : 1;
    return bracket_.is_one_cell(cells * grid_.width) || bracket_.lower() >= grid_.maximum;
  }

  // Search without a tree for patterns that stick at less friction than is known.
  // @return true: the bracket is the answer, or there is no time for more
  bool search_patterns(PrimalPart part) {
    if (problem_.contact_names.size() < min_candidates_for_start) return false;
    const auto before = bracket_.upper();
    const auto programs = reduce_by_patterns(analysis_, problem_, grid_, part, bracket_);
    if (programs == 0) return false;
    findings_.costs.push_back({CriticalPhase::primal, 0, 0, programs});
    if (stopped(CriticalPhase::primal)) return true;
    if (bracket_.upper() != before) bounds_.prove_at_once();
    return stopped(CriticalPhase::primal) || is_answered();
  }

  // Lower bound without a tree. @return true: the bracket is the answer, or the time is over
  bool bound_by_forms(int rounds) {
    if (problem_.contact_names.size() < min_candidates_for_forms) return false;
    auto forms = quadratic_forms(analysis_, problem_, grid_, bracket_, rounds);
    findings_.costs.push_back({CriticalPhase::form, forms.factor, 0, forms.evaluations});
    if (forms.factor > 0) bounds_.prove_by_forms(std::move(forms));
    return stopped(CriticalPhase::form) || is_answered();
  }

  // First lower bound of large blocks: the search for patterns after it may be interrupted.
  bool bound_by_first_forms() { return grid_.precision == Precision::doubles && bound_by_forms(0); }

  // Searches a feasible leaf at the largest coefficient, if the user specified one, as a descent
  // would do first. @return true: there is none
  bool known_at_most() {
    if (!parameters_.maximum || bracket_.leaf()) return false;
    const auto dive =
        dive_at(analysis_, problem_, multiples(*parameters_.maximum, grid_.width), grid_, {});
    findings_.costs.push_back(
        {CriticalPhase::dive, *parameters_.maximum, dive.opened, dive.opened});
    if (dive.all_infeasible) bracket_.raise_lower(*parameters_.maximum);
    if (std::isfinite(dive.feasible)) bracket_.reduce_upper(dive.feasible, dive.leaf);
    return dive.all_infeasible;
  }

  // The search is limited to coefficients up to the known leaf; just below them, that leaf would be
  // undecided.
  // @return true: it found the answer
  bool try_from_below() {
    CriticalGrid below = grid_;
    if (bracket_.leaf()) below.maximum = *bracket_.upper();
    auto trial = trial_from_below(analysis_, problem_, parameters_, below, bracket_.lower());
    if (analysis_.is_first()) findings_.global_ranks = std::move(trial.ranks);
    findings_.costs.push_back({CriticalPhase::trial, 0, trial.opened, trial.programs});
    trial.smallest.narrow(bracket_, grid_.width);
    bracket_.show();
    return trial.smallest.status == engine::Status::solved;
  }

  bool stopped(CriticalPhase phase) {
    if (!analysis_.ended()) return false;
    findings_.status = analysis_.stop_reason();
    findings_.stopped_in = phase;
    return true;
  }

  engine::Analysis& analysis_;
  const problems::WedgedProblem& problem_;
  const CriticalParameters& parameters_;
  CriticalGrid grid_;
  CriticalBounds& bounds_;
  NarrowingBracket& bracket_;
  CriticalFindings& findings_;
};

// The status is the same on every rank.
void pattern_by_pattern(engine::Analysis& analysis, const problems::WedgedProblem& problem,
                        CriticalMethod method, double width, double maximum,
                        CriticalFindings& findings) {
  const auto feasible = feasible_patterns(analysis, problem, maximum, findings.costs);
  findings.status = feasible.status;
  // A partial list does not determine the answer.
  if (findings.status != engine::Status::solved) return;
  auto outcome = bracket_patterns(analysis, problem, feasible.leaves, method, width,
                                  multiples(maximum, width));
  findings.costs.push_back(
      {CriticalPhase::coefficients, maximum, outcome.opened(), outcome.tally().programs});
  findings.status = engine::from_first_rank(analysis.transport(), [&] { return outcome.status; });
  if (!analysis.is_first()) return;
  const FrictionGrid grid(width);
  for (const auto& found : outcome.solutions) {
    const auto& [number, cell] = found.solution;
    const auto& leaf = feasible.leaves[number];
    CriticalEntry entry{.block = leaf.block,
                        .pattern = leaf.pattern,
                        .lower = grid.at(cell.infeasible),
                        .upper = {},
                        .reaction = {},
                        .displacement = {}};
    if (cell.feasible != CriticalCell::nowhere) entry.upper = grid.at(cell.feasible);
    findings.patterns.push_back(std::move(entry));
  }
  findings.bisection_ranks = std::move(outcome.ranks);
  findings.conclude(findings.status == engine::Status::solved ? maximum : 0);
}

// The first point of the grid at which the friction of every candidate has cone programs.
double min_point(const problems::WedgedProblem& problem, double width) {
  const double minimum = CriticalFriction::range(problem).minimum;
  const FrictionGrid grid(width);
  auto point = static_cast<std::int64_t>(std::floor(minimum / width));
  while (grid.at(point) < minimum) ++point;
  return grid.at(point);
}

// Narrows the bracket by the patterns with the smallest coefficients, on all ranks.
void narrow_by_patterns(engine::Analysis& analysis, const problems::WedgedProblem& problem,
                        const CriticalFindings& findings, NarrowingBracket& bracket) {
  const auto found = engine::from_first_rank(analysis.transport(), [&] {
    SmallestCoefficient smallest;
    smallest.lower = findings.bracket.at_least();
    if (!findings.bracket.upper) return smallest;
    const auto& first = findings.patterns.front();
    smallest.upper = findings.bracket.at_most();
    Configuration leaf;
    leaf.block = first.block;
    leaf.pattern = first.pattern;
    smallest.leaf = own_node(leaf, problems::blocks_of(problem));
    return smallest;
  });
  bracket.raise_lower(found.lower);
  if (std::isfinite(found.upper)) bracket.reduce_upper(found.upper, found.leaf);
}

}  // namespace

void CriticalFindings::conclude(double infeasible) {
  std::sort(patterns.begin(), patterns.end(), [](const auto& a, const auto& b) {
    const double from_a = or_infinity(a.upper);
    const double from_b = or_infinity(b.upper);
    if (from_a != from_b) return from_a < from_b;
    if (a.block != b.block) return a.block < b.block;
    return a.pattern.contact < b.pattern.contact;
  });
  double lower = infeasible;
  for (const auto& entry : patterns) lower = std::min(lower, entry.lower);
  bracket = {.lower = support::Bound{lower, support::proved_if(lower == 0)}};
  if (!patterns.empty() && patterns.front().upper)
    bracket.upper = support::Bound{*patterns.front().upper};
}

CriticalGrid grid_of(const problems::WedgedProblem& problem, const CriticalParameters& parameters) {
  CriticalGrid grid;
  // The limit is also that of the candidate with the largest relative friction.
  grid.maximum = parameters.maximum.value_or(
      std::min(default_max_friction, CriticalFriction::range(problem).maximum));
  int largest = 0;
  for (const auto& block : problems::blocks_of(problem)) largest = std::max(largest, block.size());
  const bool in_doubles = largest >= min_candidates_for_doubles && !parameters.width;
  if (in_doubles) grid.precision = Precision::doubles;
  grid.width = parameters.width.value_or(in_doubles ? default_width_in_doubles : default_width);
  if (!(grid.width < grid.maximum) || grid.maximum > max_multiples * grid.width) {
    throw std::invalid_argument(
        "the width of a bracket is out of range; expected less than the largest friction "
        "coefficient, and no less than 1e-15 of it");
  }
  return grid;
}

CriticalFindings find_critical_friction(engine::Analysis& analysis,
                                        const problems::CheckedStructure& structure,
                                        const problems::WedgedProblem& problem,
                                        const CriticalParameters& parameters,
                                        const BoundRecorder& recorder) {
  if (!finds_smallest_only(parameters.strategy) && !parameters.maximum) {
    throw std::invalid_argument(
        "the upper limit of the friction coefficient is missing; expected one for a search of all "
        "patterns");
  }
  const auto grid = grid_of(problem, parameters);
  CriticalFindings findings;
  NarrowingBracket bracket(analysis, min_point(problem, grid.width), grid.maximum);
  CriticalBounds bounds(analysis, structure, problem,
                        {.grid = grid,
                         .tightening = parameters.tightening,
                         .list = parameters.list && finds_smallest_only(parameters.strategy),
                         .list_nodes = parameters.list_nodes},
                        recorder, bracket, findings.costs);
  SmallestStrategies strategies(analysis, problem, parameters, grid, bounds, bracket, findings);
  const auto by_patterns = [&](CriticalMethod method) {
    pattern_by_pattern(analysis, problem, method, grid.width, grid.maximum, findings);
    if (findings.status != engine::Status::solved) findings.stopped_in = CriticalPhase::patterns;
    narrow_by_patterns(analysis, problem, findings, bracket);
  };
  switch (parameters.strategy) {
    case CriticalStrategy::automatic:
      strategies.automatic();
      break;
    case CriticalStrategy::descent:
      strategies.descent();
      break;
    case CriticalStrategy::global:
      strategies.global();
      break;
    case CriticalStrategy::newton:
      by_patterns(CriticalMethod::newton);
      break;
    case CriticalStrategy::bisection:
      by_patterns(CriticalMethod::bisection);
      break;
  }
  bounds.prove(findings);
  return findings;
}

}  // namespace kusabi::wedged
