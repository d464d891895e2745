// Critical friction coefficients: compared with published and independent values, method with
// method, and the global search with the least of all patterns.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "engine/analysis/analysis.hpp"
#include "engine/journal.hpp"
#include "engine/simulation.hpp"
#include "engine/transport/single_process.hpp"
#include "nodes/wedged/critical/critical_tree.hpp"
#include "nodes/wedged/critical_search.hpp"
#include "nodes/wedged/friction/critical_pattern_tree.hpp"
#include "nodes/wedged/friction/friction_grid.hpp"
#include "nodes/wedged/tree/sign_pattern_tree.hpp"
#include "problems/families/plane_truss.hpp"
#include "problems/families/space_truss.hpp"
#include "problems/files/structure_file.hpp"
#include "random_problem.hpp"
#include "random_structure.hpp"
#include "support/input_error.hpp"
#include "support/thorough.hpp"

namespace kusabi::wedged {
namespace {

constexpr double width = 1e-8;

problems::WedgedProblem example(const std::string& name) {
  return problems::wedged_problem(
      problems::load_structure(std::string(KUSABI_SOURCE_DIR) + "/examples/" + name));
}

nlohmann::json reference(const std::string& name) {
  std::ifstream file(std::string(KUSABI_SOURCE_DIR) + "/tests/reference/" + name);
  return nlohmann::json::parse(file);
}

std::int64_t multiple(double factor) {
  return std::llround(factor / width);
}

std::vector<CriticalPatternTree::Pattern> feasible(const problems::WedgedProblem& problem,
                                                   double factor) {
  SignPatternTree tree(problem, std::vector<double>(problem.contact_names.size(), factor));
  std::vector<CriticalPatternTree::Pattern> patterns;
  for (const auto& found : engine::search(tree).solutions) {
    if (found.solution.state == LeafState::feasible)
      patterns.push_back({.leaf = {.block = 0, .pattern = found.solution.pattern}});
  }
  return patterns;
}

// By contact set.
using Cells = std::map<support::IndexSet, CriticalCell>;

struct Found {
  Cells cells;
  std::uint64_t programs = 0;
};

Found all_cells(const problems::WedgedProblem& problem, double maximum, CriticalMethod method,
                std::int64_t sections = 1) {
  const auto patterns = feasible(problem, maximum);
  CriticalPatternTree tree(problem, width, patterns, multiple(maximum), method, sections);
  Found found;
  for (const auto& solution : engine::search(tree).solutions) {
    const auto& [number, cell] = solution.solution;
    EXPECT_TRUE(found.cells.emplace(patterns[number].leaf.pattern.contact, cell).second);
  }
  EXPECT_EQ(found.cells.size(), patterns.size());
  found.programs = tree.tally().programs;
  return found;
}

bool narrow(const CriticalCell& cell) {
  return cell.feasible - cell.infeasible == 1;
}

// Where a bracket is wider than the grid, the sign in between is undecided, and two methods may
// find different brackets.
void expect_same(const Found& a, const Found& b) {
  ASSERT_EQ(a.cells.size(), b.cells.size());
  for (const auto& [contact, cell] : a.cells) {
    const auto& other = b.cells.at(contact);
    if (narrow(cell) && narrow(other)) {
      EXPECT_EQ(cell.infeasible, other.infeasible) << hexadecimal(contact);
    } else {
      EXPECT_LT(cell.infeasible, other.feasible) << hexadecimal(contact);
      EXPECT_LT(other.infeasible, cell.feasible) << hexadecimal(contact);
    }
  }
}

constexpr double none = std::numeric_limits<double>::infinity();

// @param undecided_from coefficient from which on a leaf is undecided
CriticalCell minimum(const problems::WedgedProblem& problem, double maximum,
                     double undecided_from = none) {
  CriticalTree tree(problem, width, multiple(maximum));
  engine::Options options;
  options.goal = engine::Goal::best;
  options.order = engine::Order::best_first;
  const auto outcome = engine::search(tree, options);
  EXPECT_EQ(tree.tally().undecided_from.value, undecided_from);
  const auto cell = outcome.solutions.empty() ? CriticalCell{} : outcome.solutions[0].solution.cell;

  // The downward search has the same result, with other programs in another order.
  CriticalTree down(problem, width, multiple(maximum), CriticalDirection::down);
  options.order = engine::Order::depth_first;
  const auto again = engine::search(down, options);
  const auto other = again.solutions.empty() ? CriticalCell{} : again.solutions[0].solution.cell;
  EXPECT_EQ(other.infeasible, cell.infeasible);
  if (undecided_from == none) {
    EXPECT_EQ(other.feasible, cell.feasible);
  }
  return cell;
}

support::IndexSet set_of(const std::vector<int>& candidates) {
  support::IndexSet set;
  for (const int i : candidates) set.insert(i);
  return set;
}

// `list` holds pairs of a coefficient, known to `rounding`, and a contact set.
void expect_reference(const nlohmann::json& list, const Found& found, double rounding) {
  ASSERT_EQ(list.size(), found.cells.size());
  for (const auto& entry : list) {
    const auto contact = set_of(entry[1].get<std::vector<int>>());
    ASSERT_TRUE(found.cells.contains(contact)) << entry;
    const auto& cell = found.cells.at(contact);
    EXPECT_GT(entry[0].get<double>(), width * static_cast<double>(cell.infeasible) - rounding)
        << entry;
    EXPECT_LT(entry[0].get<double>(), width * static_cast<double>(cell.feasible) + rounding)
        << entry;
  }
}

// At and between the starts of a descent, also where --mu-max limits it: scaling the friction of
// all candidates divides the critical factor.
TEST(CriticalFriction, IsTheSameByDescentAndGlobalSearch) {
  const auto structure =
      problems::load_structure(std::string(KUSABI_SOURCE_DIR) + "/examples/space-truss.toml");
  const auto found = [&](CriticalStrategy strategy, double factor, std::optional<double> maximum) {
    auto problem = problems::wedged_problem(structure);
    problem.friction.assign(problem.contact_names.size(), 0.470279645 / factor);
    engine::SingleProcess alone;
    engine::Analysis analysis(alone);
    return find_critical_friction(analysis, structure, problem,
                                  {.strategy = strategy, .maximum = maximum, .width = 1e-6});
  };
  for (const double factor : {0.9, 0.9985, 0.99999, 1.00001, 3.99, 4.01}) {
    for (const auto maximum : {std::optional<double>(), std::optional(factor * 1.002)}) {
      const auto down = found(CriticalStrategy::descent, factor, maximum);
      const auto up = found(CriticalStrategy::global, factor, maximum);
      EXPECT_EQ(down.bracket.at_least(), up.bracket.at_least()) << factor;
      EXPECT_EQ(down.bracket.upper, up.bracket.upper) << factor;
      EXPECT_NEAR(down.bracket.at_least(), factor, 2e-6 * factor);
      EXPECT_TRUE(is_proved(down.bracket.lower) && is_proved(down.bracket.upper)) << factor;
    }
    const auto below = found(CriticalStrategy::descent, factor, factor * 0.999);
    EXPECT_EQ(below.bracket.at_least(), factor * 0.999);
    EXPECT_FALSE(below.bracket.upper) << factor;
  }
}

CriticalFindings found_of(const problems::Structure& structure,
                          const CriticalParameters& parameters) {
  engine::SingleProcess alone;
  engine::Analysis analysis(alone);
  const auto own = checked(structure);
  return find_critical_friction(analysis, own, problems::wedged_problem(own), parameters);
}

void expect_same_answer(const CriticalFindings& one, const CriticalFindings& other) {
  EXPECT_EQ(one.bracket.at_least(), other.bracket.at_least());
  EXPECT_EQ(one.bracket.at_most(), other.bracket.at_most());
  EXPECT_EQ(is_proved(one.bracket.lower), is_proved(other.bracket.lower));
  ASSERT_EQ(one.patterns.size(), other.patterns.size());
  for (std::size_t i = 0; i < one.patterns.size(); ++i)
    EXPECT_EQ(one.patterns[i].pattern, other.patterns[i].pattern);
}

/// Number of searches decided by the limited global search, and of those followed by a descent.
struct Trials {
  int whole = 0, descended = 0;
};

/// Compares the answers, unless a leaf is degenerate, where brackets may differ.
void compare_trials(const problems::Structure& structure, std::optional<double> maximum,
                    Trials& trials) {
  CriticalParameters parameters{
      .strategy = CriticalStrategy::global, .maximum = maximum, .width = 1e-6, .list = true};
  const auto up = found_of(structure, parameters);
  parameters.strategy = CriticalStrategy::descent;
  const auto down = found_of(structure, parameters);
  if (!up.open_points.empty() || !down.open_points.empty()) return;
  expect_same_answer(down, up);
  parameters.strategy = CriticalStrategy::automatic;
  for (const int nodes : {0, 1, 3, 9}) {  // 0: the default number
    SCOPED_TRACE(nodes);
    if (nodes > 0) parameters.trial_nodes = static_cast<std::uint64_t>(nodes);
    const auto either = found_of(structure, parameters);
    expect_same_answer(either, up);
    // With a given upper limit, feasibility there is tested first.
    EXPECT_EQ(either.costs.front().phase, maximum ? CriticalPhase::dive : CriticalPhase::trial);
    const bool descended = std::ranges::any_of(either.costs, [](const auto& cost) {
      return cost.phase == CriticalPhase::coarse || cost.phase == CriticalPhase::fine;
    });
    ++(descended ? trials.descended : trials.whole);
  }
}

// For every end of the global search: at once, with a lower bound, with a feasible leaf, with the
// answer.
TEST(CriticalFriction, IsTheSameAfterATrialOfAnyLength) {
  constexpr int seeds = test::thorough ? 60 : 20;
  Trials trials;
  for (int seed = 1; seed <= seeds; ++seed) {
    SCOPED_TRACE(seed);
    const auto structure = random_structure(2 + seed % 2, static_cast<std::uint64_t>(seed));
    try {
      for (const auto maximum : {std::optional<double>(), std::optional(0.7), std::optional(20.0)})
        compare_trials(structure, maximum, trials);
    } catch (const support::InputError&) {  // a mechanism
      continue;
    }
  }
  EXPECT_GT(trials.whole, seeds / 2);
  EXPECT_GT(trials.descended, seeds / 2);
}

// A resumed run continues as the original run decided, even if it would decide otherwise itself.
TEST(CriticalFriction, ResumesWithTheStrategyOfItsTrial) {
  std::string folder = (std::filesystem::temp_directory_path() / "kusabi trial-XXXXXX").string();
  ASSERT_NE(mkdtemp(folder.data()), nullptr);
  const auto structure = checked(problems::space_truss({.rows = 4, .depth = 2}));
  const auto problem = problems::wedged_problem(structure);
  const auto file = folder + "/state";
  const auto run = [&](std::uint64_t trial_nodes) {
    engine::Journal journal(file, {{"the problem", "7"}});
    engine::SingleProcess alone;
    engine::AnalysisOptions analysis_options;
    analysis_options.journal_options =
        engine::JournalOptions{.journal = &journal, .file = file, .facts_fingerprint = 5};
    engine::Analysis analysis(alone, std::move(analysis_options));
    auto found = find_critical_friction(analysis, structure, problem,
                                        {.trial_nodes = trial_nodes, .list = true});
    return std::pair(std::move(found), journal.size());
  };
  const auto [first, parts] = run(1);
  EXPECT_EQ(first.costs.at(1).phase, CriticalPhase::dive);
  const auto [again, same_parts] = run(1'000'000);
  EXPECT_EQ(same_parts, parts);
  ASSERT_EQ(again.costs.size(), first.costs.size());
  for (std::size_t i = 0; i < first.costs.size(); ++i) {
    EXPECT_EQ(again.costs[i].phase, first.costs[i].phase);
    EXPECT_EQ(again.costs[i].opened, first.costs[i].opened);
  }
  EXPECT_EQ(again.global_ranks.size(), first.global_ranks.size());
  expect_same_answer(again, first);
  std::filesystem::remove_all(folder);
}

// Compared with decimals: k and the power of ten, converted by the library.
TEST(FrictionGrid, HasTheDecimalsOfItsWidth) {
  const std::vector<std::tuple<double, std::int64_t, int>> widths = {
      {1e-8, 1, 8}, {1e-6, 1, 6}, {2.5e-7, 25, 8}, {0.01048576, 1048576, 8}, {1e-22, 1, 22}};
  for (const auto& [step, digits, places] : widths) {
    const FrictionGrid grid(step);
    int other = 0;
    for (std::int64_t multiple = 1; multiple < 1'000'000'000; multiple = multiple * 7 / 4 + 1) {
      const auto decimal = std::to_string(digits * multiple) + "e-" + std::to_string(places);
      EXPECT_EQ(grid.at(multiple), std::strtod(decimal.c_str(), nullptr)) << decimal;
      if (grid.at(multiple) != step * static_cast<double>(multiple)) ++other;
    }
    EXPECT_GT(other, 0) << step << ": the products are the decimals";
  }
  EXPECT_EQ(FrictionGrid(1e-8).at(60962948), 0.60962948);
  // Widths that are not short decimals.
  for (const double step : {1.0 / 3, 0x1p-30, 3e-30, 40.0}) {
    const FrictionGrid grid(step);
    for (const std::int64_t multiple : {0, 1, 2, 3, 1000, 123456789})
      EXPECT_EQ(grid.at(multiple), step * static_cast<double>(multiple)) << step;
  }
}

TEST(CriticalFriction, UsesADescentAfterTheTrialOfALargerTruss) {
  const auto structure = problems::space_truss({.rows = 8, .depth = 2, .bays = 3});
  const auto up = found_of(structure, {.strategy = CriticalStrategy::global, .list = true});
  const auto either = found_of(structure, {.list = true});
  expect_same_answer(either, up);
  const auto trial = std::ranges::find(either.costs, CriticalPhase::trial, &CriticalCost::phase);
  ASSERT_LT(trial, either.costs.end() - 1);
  EXPECT_LE(trial->opened, 15 * structure.contact.size());
  EXPECT_EQ((trial + 1)->phase, CriticalPhase::dive);
}

// The claim of one pattern: the bracket is that of the whole list, which contains the pattern.
TEST(CriticalFriction, HasTheBracketOfTheListWithoutListingPatterns) {
  for (const char* name : {"space-truss.toml", "plane-truss.toml", "doorstop.toml"}) {
    SCOPED_TRACE(name);
    const auto structure =
        problems::load_structure(std::string(KUSABI_SOURCE_DIR) + "/examples/" + name);
    const auto one = found_of(structure, {});
    const auto all = found_of(structure, {.list = true});
    EXPECT_EQ(one.bracket.at_least(), all.bracket.at_least());
    EXPECT_EQ(one.bracket.upper, all.bracket.upper);
    EXPECT_TRUE(is_proved(one.bracket.upper));
    ASSERT_EQ(one.patterns.size(), 1U);
    EXPECT_FALSE(one.patterns.front().reaction.empty());
    EXPECT_TRUE(std::ranges::any_of(all.patterns, [&](const auto& entry) {
      return entry.pattern == one.patterns.front().pattern;
    }));
  }
}

TEST(CriticalFriction, BracketDoesNotDependOnTheNodeLimitOfTheList) {
  const auto structure = problems::space_truss({.rows = 8, .depth = 2, .bays = 3});
  const auto all = found_of(structure, {.list = true});
  const auto part = found_of(structure, {.list = true, .list_nodes = 1});
  EXPECT_EQ(part.status, engine::Status::solved);
  EXPECT_EQ(part.bracket.at_least(), all.bracket.at_least());
  EXPECT_EQ(part.bracket.upper, all.bracket.upper);
  EXPECT_THAT(part.open_points, ::testing::Contains(OpenPoint::list_not_complete));
  EXPECT_EQ(part.patterns.size(), 1U);
}

// For every limit: nodes are counted over all searches, and each further node leaves the bracket
// unchanged or narrower.
TEST(CriticalFriction, BracketNarrowsAsTheNodeLimitGrows) {
  const auto structure = checked(problems::space_truss({.rows = 8, .depth = 2, .bays = 3}));
  const auto problem = problems::wedged_problem(structure);
  const auto whole = found_of(structure, {});
  double lower = 0;
  double upper = std::numeric_limits<double>::infinity();
  for (std::uint64_t nodes = 1; nodes < 3000; nodes = nodes * 3 / 2 + 1) {
    SCOPED_TRACE(nodes);
    engine::SingleProcess alone;
    engine::AnalysisOptions analysis_options;
    analysis_options.limits.nodes = nodes;
    engine::Analysis analysis(alone, std::move(analysis_options));
    const auto found = find_critical_friction(analysis, structure, problem, {});
    std::uint64_t opened = 0;
    for (const auto& cost : found.costs)
      if (cost.phase != CriticalPhase::upper_bound) opened += cost.opened;
    EXPECT_LE(opened, nodes + 10);
    EXPECT_GE(found.bracket.at_least(), lower);
    EXPECT_LE(found.bracket.at_most(), upper);
    lower = found.bracket.at_least();
    upper = std::min(found.bracket.at_most(), upper);
    EXPECT_LE(lower, whole.bracket.at_least());
    EXPECT_GE(upper, whole.bracket.at_most());
    if (found.status == engine::Status::solved) break;
    EXPECT_EQ(found.status, engine::Status::node_limit);
    EXPECT_TRUE(found.stopped_in);
  }
  EXPECT_EQ(lower, whole.bracket.at_least());
}

TEST(CriticalFriction, OfTheTwoBarsIsTwo) {
  // r_t = 2 r_n, see docs/problem-files.md. The grid has a point there, which is undecided.
  const auto cell =
      minimum(example("two-bars.toml"), 10, width * static_cast<double>(multiple(2) - 1));
  EXPECT_LT(cell.infeasible, multiple(2));
  EXPECT_GT(cell.feasible, multiple(2));
  EXPECT_LE(cell.feasible - cell.infeasible, 2);
}

TEST(CriticalFriction, OfTheSpaceTrussIsThatOfTheReferenceByBothMethods) {
  const auto problem = example("space-truss.toml");
  const auto known = reference("space-truss.json")["critical"];
  const auto newton = all_cells(problem, 1.0, CriticalMethod::newton);
  const auto bisection = all_cells(problem, 1.0, CriticalMethod::bisection);
  expect_reference(known, newton, 1e-6);
  expect_reference(known, bisection, 1e-6);
  expect_same(newton, bisection);
  // 27 halvings lead from 1 to 1e-8. Newton's method takes a quarter of that.
  EXPECT_GT(bisection.programs, 26 * 251U);
  EXPECT_LT(newton.programs, 7 * 251U);
}

TEST(CriticalFriction, OfThePlaneTrussIsThatOfTheReference) {
  const auto problem = example("plane-truss.toml");
  expect_reference(reference("plane-truss.json")["five"]["critical_at_1"],
                   all_cells(problem, 1.0, CriticalMethod::newton), 1e-9);
}

// Table 1 of the wedged paper has four decimals.
TEST(CriticalFriction, OfThePapersElasticBodyIsAsPrinted) {
  const auto cell = minimum(example("paper/elastic-body.toml"), 10);
  const double printed = reference("paper-elastic-body.json")["critical"];
  EXPECT_NEAR(width * static_cast<double>(cell.feasible), printed, 0.5e-4);
}

// From an independent program.
TEST(CriticalFriction, OfTheElasticBodyIsThatOfTheReference) {
  const auto found = all_cells(example("elastic-body.toml"), 1.5, CriticalMethod::newton);
  expect_reference(nlohmann::json::parse(R"([[1.4482182919, [0]], [1.3373872264, [10, 11]],
                                             [1.4913032281, [9, 10, 11]]])"),
                   found, 1e-10);
}

TEST(CriticalFriction, TheGlobalSearchFindsTheLeastOfAllPatterns) {
  for (const auto* name : {"space-truss.toml", "plane-truss.toml"}) {
    const auto problem = example(name);
    const auto all = all_cells(problem, 1.0, CriticalMethod::bisection);
    std::int64_t smallest = CriticalCell::nowhere;
    for (const auto& [contact, cell] : all.cells) smallest = std::min(smallest, cell.feasible);
    const auto cell = minimum(problem, 1000);
    EXPECT_EQ(cell.feasible, smallest) << name;
    EXPECT_TRUE(narrow(cell));
  }
}

TEST(CriticalFriction, AllMethodsAgreeOnRandomProblems) {
  std::size_t patterns = 0;
  for (std::uint64_t seed = 1; seed <= 24; ++seed) {
    const auto problem =
        random_problem(seed % 2 == 0 ? 2 : 3, 2 + static_cast<int>(seed % 5), seed);
    const auto newton = all_cells(problem, 4.0, CriticalMethod::newton);
    const auto bisection = all_cells(problem, 4.0, CriticalMethod::bisection);
    expect_same(newton, bisection);
    patterns += newton.cells.size();
    std::int64_t smallest = CriticalCell::nowhere;
    for (const auto& [contact, cell] : bisection.cells)
      smallest = std::min(smallest, cell.feasible);
    EXPECT_EQ(minimum(problem, 4.0).feasible, smallest) << seed;
  }
  EXPECT_GT(patterns, 40U);
}

// Configurations of this unconstrained body satisfy their equations to 1e-10 only: used at other
// coefficients as if they were exact, one gave a bracket 8e-6 below that of the bisection.
TEST(CriticalFriction, OfAPegIsTheSameByBothMethods) {
  const auto problem = example("peg-in-hole.toml");
  const auto bisected = all_cells(problem, 0.4, CriticalMethod::bisection);
  EXPECT_EQ(bisected.cells.size(), 9U);
  for (const double maximum : {0.4, 0.5}) {
    for (const auto& [pattern, cell] : all_cells(problem, maximum, CriticalMethod::newton).cells) {
      if (bisected.cells.contains(pattern)) {
        EXPECT_EQ(cell, bisected.cells.at(pattern));
      }
    }
  }
}

// A pattern is infeasible at the lower bound of its bracket and below, feasible at the upper one
// and above.
TEST(CriticalFriction, FeasibilityIsMonotoneInFriction) {
  const auto problem = example("space-truss.toml");
  const auto found = all_cells(problem, 0.7, CriticalMethod::newton);
  EXPECT_FALSE(found.cells.empty());
  CriticalFriction critical(problem, width);
  for (const auto& [contact, cell] : found.cells) {
    const SignPattern pattern{contact, 1023 - contact, {}};
    for (const double factor : {0.5, 0.9, 1.0}) {
      EXPECT_EQ(critical.probe(pattern, factor * critical.at(cell.infeasible)).sign,
                conic::Sign::infeasible);
    }
    for (const double factor : {1.0, 1.1, 2.0, 10.0}) {
      EXPECT_EQ(critical.probe(pattern, factor * critical.at(cell.feasible)).sign,
                conic::Sign::feasible);
    }
  }
}

TEST(CriticalFriction, IsAFactorOfTheFrictionOfEachCandidate) {
  auto problem = example("space-truss.toml");
  const auto cell = minimum(problem, 1);
  for (double& own : problem.friction) own = 2;
  const auto half = minimum(problem, 1);
  EXPECT_NEAR(static_cast<double>(half.feasible), 0.5 * static_cast<double>(cell.feasible), 1);
}

// When ranks outnumber patterns, cells are divided into several at once.
TEST(CriticalFriction, IsTheSameByAnyNumberOfSections) {
  const auto problem = example("plane-truss.toml");
  const auto once = all_cells(problem, 0.7, CriticalMethod::bisection);
  for (const std::int64_t sections : {2, 3, 16}) {
    expect_same(once, all_cells(problem, 0.7, CriticalMethod::bisection, sections));
  }
}

TEST(CriticalFriction, IsTheSameOnAnyNumberOfSimulatedRanks) {
  const auto problem = example("space-truss.toml");
  const auto alone = minimum(problem, 10);
  engine::Options options;
  options.goal = engine::Goal::best;
  options.order = engine::Order::best_first;
  for (const int ranks : {2, 5, 32}) {
    const engine::MachineModel machine{.latency = 2e-6, .node = 20e-6};
    const auto many =
        engine::simulate(CriticalTree(problem, width, multiple(10)), ranks, 3, machine, options);
    ASSERT_EQ(many.outcome.solutions.size(), 1U);
    EXPECT_EQ(many.outcome.solutions[0].solution.cell, alone);
  }
}

// A flat cone above its critical coefficient: the displacements of the multipliers at its loaded
// candidates are zero, so quotients of their rounding errors are arbitrary. Such quotients once
// proved coefficients infeasible at which these cones exist.
TEST(CriticalFriction, RoundingProvesNoFlatConeInfeasible) {
  const auto problem = problems::wedged_problem(checked(problems::paper_plane_truss(19)));
  const SignPattern leaf{.contact = set_of({4, 5, 6, 7, 8, 9, 10, 11, 12, 14, 15, 16, 17, 18}),
                         .separated = set_of({0, 1, 2, 3, 13}),
                         .inactive = {}};
  CriticalFriction critical(problem, width);
  const double maximum = 0.65;
  const auto cell =
      critical.locate(leaf, {0, multiple(maximum)}, CriticalMethod::newton, multiple(maximum));
  EXPECT_EQ(cell.feasible - cell.infeasible, 1);
  const double feasible_from = critical.at(cell.feasible);
  int degenerate = 0;
  for (int k = 0; k < 1000; ++k) {
    const auto probed = critical.probe(leaf, feasible_from + (maximum - feasible_from) * k / 1000);
    EXPECT_LE(probed.infeasible_below, feasible_from) << k;
    if (probed.degenerate) ++degenerate;
  }
  EXPECT_GT(degenerate, 100);
}

// At most a third of the programs of bisection, which takes 27, also where a flat cone comes first,
// and where no feasible coefficient is known.
TEST(CriticalFriction, SolvesFewProgramsPerPattern) {
  for (const int rows : {13, 15}) {
    const auto problem = problems::wedged_problem(checked(problems::paper_plane_truss(rows)));
    const auto patterns = feasible(problem, 0.65);
    for (const auto start : {multiple(0.65), CriticalCell::nowhere}) {
      CriticalFriction critical(problem, width);
      for (const auto& pattern : patterns) {
        const auto cell = critical.locate(pattern.leaf.pattern, {0, start}, CriticalMethod::newton,
                                          multiple(0.65));
        EXPECT_TRUE(narrow(cell));
      }
      EXPECT_LE(critical.programs(), 27 / 3 * patterns.size()) << rows;
    }
  }
}

// The grid has points below the least supported friction.
TEST(CriticalFriction, IsSearchedDownToTheLeastFriction) {
  for (const double own : {1.0, 1e3, 2e5}) {
    auto problem = example("two-bars.toml");
    problem.friction.assign(problem.contact_names.size(), 2 * own);
    const SignPattern leaf{.contact = set_of({0}), .separated = {}, .inactive = {}};
    for (const auto start : {multiple(1.5 / own), CriticalCell::nowhere}) {
      CriticalFriction critical(problem, width);
      const auto cell = critical.locate(leaf, {0, start}, CriticalMethod::newton, multiple(1.5));
      EXPECT_LE(critical.at(cell.infeasible), 1 / own) << own;
      EXPECT_GE(critical.at(cell.feasible), 1 / own) << own;
      EXPECT_LE(cell.feasible - cell.infeasible, 200) << own;
    }
  }
}

TEST(CriticalFriction, IsAbsentIfNoPatternIsFeasibleUpToTheMaximum) {
  EXPECT_EQ(minimum(example("space-truss.toml"), 0.47), CriticalCell{});
}

}  // namespace
}  // namespace kusabi::wedged
