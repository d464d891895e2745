// The table and the JSON of `kusabi patterns`.
#include "run/patterns_report.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <iterator>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "run/problem_summary.hpp"
#include "run/rank_table.hpp"

namespace kusabi::run {
namespace {

using nlohmann::ordered_json;

// True if the set `a`, read as an increasing list, comes before `b` in the order of a dictionary.
bool before(std::uint64_t a, std::uint64_t b) {
  while (a != 0 && b != 0) {
    const int first_a = std::countr_zero(a);
    const int first_b = std::countr_zero(b);
    if (first_a != first_b) return first_a < first_b;
    a &= a - 1;
    b &= b - 1;
  }
  return a == 0 && b != 0;
}

// The place of an entry's kind in the list.
int kind(const PatternsReport::Entry& entry) {
  switch (entry.leaf->state) {
    case nodes::LeafState::alive:
      return 0;
    case nodes::LeafState::marginal:
      return entry.face ? 1 : 2;
    case nodes::LeafState::undecided:
      break;
  }
  return 3;
}

std::string state_name(const PatternsReport::Entry& entry) {
  static constexpr const char* names[] = {"alive", "degenerate", "marginal", "undecided"};
  return names[kind(entry)];
}

}  // namespace

ordered_json tally_json(const nodes::SignPatternTally& tally) {
  return {{"branched", tally.branched},
          {"dead", tally.dead},
          {"found", tally.found},
          {"marginal_leaves", tally.marginal},
          {"undecided_leaves", tally.undecided},
          {"doubtful_branched", tally.doubtful},
          {"iterations", tally.iterations},
          {"candidates", tally.candidates}};
}

PatternsReport::PatternsReport(const PatternsOptions& options_,
                               const problems::WedgedProblem& problem_,
                               std::span<const double> friction,
                               const engine::Outcome<nodes::SignPatternTree>& outcome_)
    : options(options_), problem(problem_), outcome(outcome_) {
  std::vector<std::uint64_t> living;
  for (const auto& found : outcome.solutions) {
    sorted.push_back({&found.solution, std::nullopt});
    if (found.solution.state == nodes::LeafState::alive)
      living.push_back(found.solution.pattern.contact);
  }
  std::sort(living.begin(), living.end(), before);
  nodes::FaceFinder faces(problem, friction);
  for (auto& [leaf, face] : sorted) {
    if (leaf->state != nodes::LeafState::marginal) continue;
    face = faces.find(leaf->pattern, living);
    degenerate += face ? 1 : 0;
  }
  std::sort(sorted.begin(), sorted.end(), [](const Entry& a, const Entry& b) {
    if (kind(a) != kind(b)) return kind(a) < kind(b);
    return before(a.leaf->pattern.contact, b.leaf->pattern.contact);
  });
}

nodes::SignPatternTally PatternsReport::total() const {
  nodes::SignPatternTally sum;
  for (const auto& rank : outcome.ranks) sum += rank.tally;
  for (const auto& rank : outcome.earlier) sum += rank.tally;
  return sum;
}

// The number in the table of the living pattern with this contact set.
std::size_t PatternsReport::place_of(std::uint64_t contact) const {
  const auto found = std::find_if(sorted.begin(), sorted.end(), [&](const Entry& entry) {
    return entry.leaf->pattern.contact == contact;
  });
  return static_cast<std::size_t>(found - sorted.begin()) + 1;
}

std::string PatternsReport::table() const {
  std::string text;
  auto out = std::back_inserter(text);
  const auto tally = total();

  std::size_t contact_width = std::string_view("in contact (U)").size();
  for (const auto& [leaf, face] : sorted) {
    contact_width =
        std::max(contact_width, listed(candidate_names(problem, leaf->pattern.contact)).size());
  }
  if (!sorted.empty()) {
    fmt::format_to(out, "\n{:>5}  {:>10}  {:<{}}  {}\n", "", "margin t*", "in contact (U)",
                   contact_width, "separated (R)");
  }
  std::size_t number = 0;
  for (const auto& entry : sorted) {
    const auto& [leaf, face] = entry;
    fmt::format_to(out, "{:>5}  {:>10}  {:<{}}  {}{}\n", ++number,
                   leaf->state == nodes::LeafState::alive ? fmt::format("{:.3e}", leaf->lower)
                                                          : state_name(entry),
                   listed(candidate_names(problem, leaf->pattern.contact)), contact_width,
                   listed(candidate_names(problem, leaf->pattern.separated)),
                   face ? fmt::format("  (within {})", place_of(face->within)) : "");
  }
  fmt::format_to(out,
                 "\n{} sign pattern{} of wedged configurations at friction coefficient {}{}; "
                 "{} marginal (|t*| <= {})\n",
                 tally.found, tally.found == 1 ? "" : "s", options.friction,
                 problems::uniform_friction(problem) ? "" : " times that of each candidate",
                 tally.marginal - degenerate, options.tolerance);
  if (options.facets != 0) {
    fmt::format_to(out, "{} candidates under polyhedral friction cones of {} facets\n",
                   tally.candidates, options.facets);
  }
  if (degenerate != 0) {
    fmt::format_to(out, "{} degenerate: t* = 0, all their configurations are of a pattern listed\n",
                   degenerate);
  }
  if (tally.undecided != 0) {
    fmt::format_to(out, "{} undecided: double precision did not suffice to bracket t*\n",
                   tally.undecided);
  }

  RankTable ranks({"branched", "pruned", "found", "marginal", "iterations"});
  const auto own = [](const nodes::SignPatternTally& its) {
    return std::vector<std::uint64_t>{its.branched, its.dead, its.found,
                                      its.marginal + its.undecided + its.doubtful, its.iterations};
  };
  for (const auto& rank : outcome.ranks) ranks.add(rank.statistics, own(rank.tally));
  for (const auto& rank : outcome.earlier) ranks.add_earlier(rank.statistics, own(rank.tally));
  text += '\n' + ranks.text();
  return text;
}

ordered_json PatternsReport::json() const {
  const auto tally = total();
  ordered_json patterns = ordered_json::array();
  for (const auto& entry : sorted) {
    const auto& [leaf, face] = entry;
    ordered_json pattern = {
        {"contact", candidate_names(problem, leaf->pattern.contact)},
        {"separated", candidate_names(problem, leaf->pattern.separated)},
        {"state", state_name(entry)},
        {"margin", leaf->lower},
        {"margin_upper", leaf->upper},
        {"reaction", candidate_rows(leaf->reaction, problem.dimension)},
        {"displacement", candidate_rows(leaf->displacement, problem.dimension)}};
    if (face) {
      pattern["within"] = candidate_names(problem, face->within);
      pattern["unloaded"] = candidate_names(problem, face->unloaded);
      pattern["unmoved"] = candidate_names(problem, face->unmoved);
    }
    patterns.push_back(std::move(pattern));
  }
  ordered_json tree = tally_json(tally);
  tree["opened"] = outcome.opened();
  tree["open"] = outcome.open;
  tree["fingerprint"] = fmt::format("{:016x}", outcome.fingerprint());

  return {{"command", "patterns"},
          {"version", KUSABI_VERSION},
          {"problem", problem_json(problem, options.file)},
          {"options",
           {{"mu", options.friction},
            {"tolerance", options.tolerance},
            {"method", options.facets == 0 ? "cones" : "polyhedral"},
            {"facets", options.facets},
            {"branching", options.branching == nodes::Branching::product ? "paper" : "relative"}}},
          {"status", status_name(outcome.status)},
          {"result",
           {{"friction", options.friction},
            {"tolerance", options.tolerance},
            {"count", tally.found},
            {"degenerate", degenerate},
            {"marginal", tally.marginal - degenerate},
            {"undecided", tally.undecided},
            {"tree", std::move(tree)},
            {"patterns", std::move(patterns)}}},
          {"statistics",
           {{"ranks", rank_reports(outcome.ranks, tally_json)},
            {"earlier_runs", rank_reports(outcome.earlier, tally_json)}}}};
}

}  // namespace kusabi::run
