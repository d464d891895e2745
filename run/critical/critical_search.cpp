// Two ways to the bracket.
#include "run/critical/critical_search.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include <boost/serialization/string.hpp>
#include <boost/serialization/vector.hpp>

#include "engine/together.hpp"
#include "nodes/wedged/bisection.hpp"
#include "nodes/wedged/critical_tree.hpp"
#include "nodes/wedged/maximal_cones.hpp"
#include "run/output/rank_table.hpp"
#include "run/session/shown_search.hpp"
#include "run/wedged/problem_summary.hpp"

namespace kusabi::run {
namespace {

using nlohmann::ordered_json;

std::int64_t multiples(double most, double width) {
  return static_cast<std::int64_t>(std::llround(most / width));
}

// What lives or may live at the largest coefficient: maximal cones and open leaves.
struct Living {
  std::string status;
  std::vector<wedged::Configuration> leaves;

  template <class Archive>
  void serialize(Archive& archive, unsigned /*version*/) {
    archive& status& leaves;
  }
};

Living living_patterns(Session& session, const CriticalOptions& options,
                       const problems::WedgedProblem& problem, const engine::Budget& budget) {
  const auto friction = friction_at(problem, *options.most, options.file);
  wedged::SignPatternTree tree(problem, friction);
  auto outcome = shown_search(session, tree, {}, budget.left(), options.quiet);
  return engine::from_first_rank(session.transport(), [&] {
    std::vector<wedged::Configuration> leaves;
    for (auto& found : outcome.solutions) leaves.push_back(std::move(found.solution));
    return Living{status_name(outcome.status), wedged::maximal_cones(std::move(leaves))};
  });
}

// A leaf of the block's tree whose cone it is: candidates at rest may be called separated.
wedged::PatternBisection::Pattern pattern_of(const wedged::Configuration& leaf,
                                             const std::vector<std::uint64_t>& blocks) {
  const auto block = blocks[leaf.block];
  const auto contact = leaf.pattern.contact;
  return {.leaf = {.block = leaf.block,
                   .pattern = {.contact = problems::in_block(contact, block),
                               .separated = problems::in_block(block & ~contact, block)}},
          .lives = leaf.state == wedged::LeafState::alive || leaf.state == wedged::LeafState::flat};
}

}  // namespace

CriticalFindings global_search(Session& session, const CriticalOptions& options,
                               const problems::WedgedProblem& problem,
                               const engine::Budget& budget) {
  const double most = options.most.value_or(usual_most);
  wedged::CriticalTree tree(problem, options.width, multiples(most, options.width));
  engine::Options search_options;
  search_options.goal = engine::Goal::best;
  search_options.order = engine::Order::best_first;
  const auto outcome = shown_search(session, tree, search_options, budget.left(), options.quiet);
  CriticalFindings findings;
  findings.status =
      session.from_first_rank([&] { return std::string(status_name(outcome.status)); });
  if (!session.speaks()) return findings;

  RankTable table({"branched", "pruned", "leaves", "programs"});
  const auto total = outcome.tally();
  for (const auto& [statistics, tally] : outcome.ranks) {
    table.add(statistics, {tally.branched, tally.dead, tally.leaves, tally.programs});
  }
  findings.statistics = {{"ranks", rank_reports(outcome.ranks, [](const auto& tally) {
                            return ordered_json{{"branched", tally.branched},
                                                {"dead", tally.dead},
                                                {"leaves", tally.leaves},
                                                {"programs", tally.programs}};
                          })}};
  findings.ranks = table.text();
  const bool whole = outcome.status == engine::Status::solved;
  findings.lower = whole ? most : std::min(most, std::max(0.0, outcome.bound));
  for (const auto& found : outcome.solutions) {
    const auto& cell = found.solution.cell;
    findings.lower = std::min(findings.lower, options.width * static_cast<double>(cell.dead));
    findings.upper = options.width * static_cast<double>(cell.alive);
  }
  // A leaf that is doubtful from further down on is opened on any schedule.
  findings.lower = std::min(findings.lower, total.doubt);
  return findings;
}

CriticalFindings pattern_by_pattern(Session& session, const CriticalOptions& options,
                                    const problems::WedgedProblem& problem,
                                    const engine::Budget& budget) {
  CriticalFindings findings;
  const auto living = living_patterns(session, options, problem, budget);
  findings.status = living.status;
  if (findings.status != "solved") return findings;  // a part of them would say nothing
  const auto blocks = problems::blocks_of(problem);
  std::vector<wedged::PatternBisection::Pattern> patterns;
  for (const auto& leaf : living.leaves) patterns.push_back(pattern_of(leaf, blocks));
  const auto count = static_cast<std::int64_t>(patterns.size());
  const auto sections = count == 0 ? 1 : session.ranks() / count;
  wedged::PatternBisection tree(
      problem, options.width, patterns, multiples(*options.most, options.width),
      options.way == CriticalWay::newton ? wedged::CriticalMethod::newton
                                         : wedged::CriticalMethod::bisection,
      sections);
  const auto outcome = shown_search(session, tree, {}, budget.left(), options.quiet);
  findings.status =
      session.from_first_rank([&] { return std::string(status_name(outcome.status)); });
  if (!session.speaks()) return findings;

  RankTable table({"programs"});
  for (const auto& [statistics, tally] : outcome.ranks) table.add(statistics, {tally.programs});
  findings.statistics = {{"ranks", rank_reports(outcome.ranks, [](const auto& tally) {
                            return ordered_json{{"programs", tally.programs}};
                          })}};
  findings.ranks = table.text();
  for (const auto& found : outcome.solutions) {
    const auto& [number, cell] = found.solution;
    const auto& leaf = living.leaves[number];
    CriticalEntry entry{.block = leaf.block,
                        .pattern = leaf.pattern,
                        .lower = options.width * static_cast<double>(cell.dead),
                        .upper = {},
                        .reaction = {},
                        .displacement = {}};
    if (cell.alive != wedged::CriticalCell::nowhere)
      entry.upper = options.width * static_cast<double>(cell.alive);
    findings.patterns.push_back(std::move(entry));
  }
  findings.conclude(findings.status == "solved" ? *options.most : 0);
  return findings;
}

}  // namespace kusabi::run
