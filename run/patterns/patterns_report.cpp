// The table and the JSON of `kusabi patterns`.
#include "run/patterns/patterns_report.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <numeric>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "run/output/name_ranges.hpp"
#include "run/output/rank_table.hpp"
#include "run/output/values.hpp"
#include "run/wedged/configuration_csv.hpp"
#include "run/wedged/problem_summary.hpp"

namespace kusabi::run {
namespace {

using nlohmann::ordered_json;

const char* state_name(wedged::LeafState state) {
  switch (state) {
    case wedged::LeafState::alive:
      return "alive";
    case wedged::LeafState::flat:
      return "flat";
    case wedged::LeafState::marginal:
      return "marginal";
    case wedged::LeafState::undecided:
      break;
  }
  return "undecided";
}

std::string patterns(std::uint64_t count) {
  return counted(count, "sign pattern");
}

const char* name_of(wedged::Tightening tightening) {
  switch (tightening) {
    case wedged::Tightening::never:
      return "none";
    case wedged::Tightening::always:
      return "always";
    default:
      return "auto";
  }
}

const char* name_of(wedged::Branching branching) {
  switch (branching) {
    case wedged::Branching::automatic:
      return "auto";
    case wedged::Branching::product:
      return "paper";
    case wedged::Branching::relative:
      return "relative";
    case wedged::Branching::deepest:
      return "deepest";
    case wedged::Branching::weighed:
      return "weighed";
  }
  return "";
}

}  // namespace

std::vector<std::size_t> PatternsReport::order() const {
  std::vector<std::size_t> order(findings_.leaves.size());
  std::iota(order.begin(), order.end(), 0U);
  const auto& leaves = findings_.leaves;
  switch (options_.sort) {
    case PatternSort::number:
      break;
    case PatternSort::margin:
      std::ranges::stable_sort(order, std::greater(), [&](auto i) { return leaves[i].lower; });
      break;
    case PatternSort::contact:
      std::ranges::stable_sort(order, std::less(),
                               [&](auto i) { return leaves[i].pattern.contact.size(); });
      break;
  }
  return order;
}

std::string PatternsReport::list() const {
  std::string text;
  auto out = std::back_inserter(text);
  const auto names = [&](const support::IndexSet& set) {
    return with_ranges(candidate_names(problem_, set));
  };
  auto shown = order();
  const std::size_t all = shown.size();
  shown.resize(std::min<std::size_t>(all, options_.top));
  std::size_t contact_width = std::string_view("in contact (U)").size();
  for (const std::size_t i : shown)
    contact_width =
        std::max(contact_width, shown_width(names(findings_.leaves[i].pattern.contact)));
  if (!shown.empty()) {
    fmt::format_to(out, "\n{:>5}  {:>10}  {:<{}}  {}\n", "", "margin t*", "in contact (U)",
                   contact_width, "separated (R)");
  }
  for (const std::size_t i : shown) {
    const auto& leaf = findings_.leaves[i];
    const auto& [contact, separated, at_rest] = leaf.pattern;
    fmt::format_to(out, "{:>5}  {:>10}  {:<{}}  {}{}\n", i + 1,
                   leaf.state == wedged::LeafState::alive ? fmt::format("{:.3e}", leaf.lower)
                                                          : state_name(leaf.state),
                   names(contact), contact_width, names(separated),
                   at_rest.empty() ? "" : "  at rest: " + names(at_rest));
  }
  if (shown.size() < all) fmt::format_to(out, "{:>5}  {} more\n", "…", all - shown.size());
  return text;
}

// Of Algorithm 5.8: Y_1, ..., Y_k, and what (23) says of each.
std::string PatternsReport::candidates() const {
  std::string text;
  if (!options_.list_candidates) return text;
  auto out = std::back_inserter(text);
  const auto names = [&](const support::IndexSet& set) {
    return with_ranges(candidate_names(problem_, set));
  };
  fmt::format_to(out, "\n{:>5}  {:>13}  {:>10}  {}\n", "", "polyhedral t*", "t* of (23)",
                 "in contact (U) | separated (R)");
  std::size_t number = 0;
  for (const auto& candidate : findings_.tested) {
    const auto& [contact, separated, at_rest] = candidate.pattern;
    fmt::format_to(out, "{:>5}  {:>13.3e}  {:>10}  {} | {}\n", ++number, candidate.polyhedral,
                   candidate.discarded() ? "discarded" : fmt::format("{:.3e}", candidate.lower),
                   names(contact), names(separated));
  }
  return text;
}

ordered_json PatternsReport::candidates_json() const {
  ordered_json list = ordered_json::array();
  for (const auto& candidate : findings_.tested) {
    auto json = pattern_json(problem_, candidate.block, candidate.pattern);
    json["polyhedral_margin"] = candidate.polyhedral;
    if (!candidate.discarded()) json["margin"] = candidate.lower;
    json["margin_upper"] = candidate.upper;
    json["discarded"] = candidate.discarded();
    list.push_back(std::move(json));
  }
  return list;
}

// What was asked, in a sentence; none if the search stopped early.
std::string PatternsReport::sentence() const {
  if (!findings_.whole()) return {};
  if (findings_.leaves.empty())
    return fmt::format("\nIt cannot stick at friction coefficient {}.\n", options_.friction);
  const auto& leaves = findings_.leaves;
  const auto best = std::ranges::max_element(leaves, {}, &wedged::Configuration::lower);
  if (best->state != wedged::LeafState::alive) return {};
  return fmt::format(
      "\nIt can stick: {} at friction coefficient {}. The largest margin, {:.3g}, has number {} "
      "({} in "
      "contact); its configuration holds from {:.4g} on.\n",
      counted(findings_.count(), "way"), options_.friction, best->lower, best - leaves.begin() + 1,
      with_ranges(candidate_names(problem_, best->pattern.contact)), least_friction_of(*best));
}

// Of the friction coefficients (or factors of them) at which a configuration is within its cones,
// the least.
double PatternsReport::least_friction_of(const wedged::Configuration& leaf) const {
  const auto d = static_cast<std::size_t>(problem_.dimension);
  const auto whole = of_all_candidates(problem_, leaf.block, leaf.reaction);
  double least = 0;
  for (const int i : leaf.pattern.contact) {
    const auto* const own = whole.data() + d * static_cast<std::size_t>(i);
    const double factor =
        problem_.friction.empty() ? 1 : problem_.friction[static_cast<std::size_t>(i)];
    const double tangential = d == 2 ? std::abs(own[1]) : std::hypot(own[1], own[2]);
    if (tangential > 0) least = std::max(least, tangential / (factor * own[0]));
  }
  return least;
}

// The answer, and what it leaves open.
std::string PatternsReport::verdict() const {
  std::string text;
  auto out = std::back_inserter(text);
  fmt::format_to(out,
                 "\n{} of wedged configurations at friction coefficient {}{}; {} marginal "
                 "(|t*| <= {})\n",
                 patterns(findings_.count()), options_.friction,
                 problems::uniform_friction(problem_) ? "" : " times that of each candidate",
                 findings_.marginal, options_.tolerance);
  if (findings_.flat != 0) {
    fmt::format_to(out,
                   "{} of the list flat (t* = 0): in all configurations of one the candidates at "
                   "rest have neither a reaction nor a gap, or those in contact slip\n",
                   findings_.flat);
  }
  if (findings_.blocks.size() > 1) {
    fmt::format_to(out,
                   "the structure comes apart into {} blocks, which wedge or rest each by "
                   "itself:\n",
                   findings_.blocks.size());
    for (const auto& block : findings_.blocks) {
      fmt::format_to(out, "  {}: {}\n", with_ranges(candidate_names(problem_, block.candidates)),
                     block.rests() ? "at rest always" : patterns(block.cones));
    }
    const auto wedging = std::count_if(findings_.blocks.begin(), findings_.blocks.end(),
                                       [](const auto& b) { return b.cones != 0; });
    if (wedging > 1) {
      text +=
          "any pattern of one goes with any of another: their product is the number of patterns "
          "of the whole, and the list has those of each block\n";
    }
  }
  if (options_.polyhedral) {
    fmt::format_to(out, "{} candidates under polyhedral friction cones of {} facets\n",
                   findings_.outcome.tally().candidates, options_.facets);
  }
  if (findings_.undecided != 0) {
    fmt::format_to(out, "{} undecided: the bracket of t* could not be made narrow enough\n",
                   findings_.undecided);
  }
  return text;
}

std::string PatternsReport::table() const {
  RankTable ranks({"branched", "pruned", "found", "marginal", "iterations"});
  const auto own = [](const wedged::SignPatternTally& its) {
    return std::vector<std::uint64_t>{its.branched, its.dead, its.found + its.flat,
                                      its.marginal + its.undecided + its.doubtful, its.iterations};
  };
  for (const auto& rank : findings_.outcome.ranks) ranks.add(rank.statistics, own(rank.tally));
  for (const auto& rank : findings_.outcome.earlier)
    ranks.add_earlier(rank.statistics, own(rank.tally));
  return list() + candidates() + sentence() + verdict() + '\n' + ranks.text();
}

void PatternsReport::write_csv(std::ostream& out) const {
  CsvWriter csv(out);
  csv.word("pattern");
  add_pattern_columns(csv);
  csv.word("state").word("margin").word("margin_upper");
  add_configuration_columns(csv, problem_);
  csv.end_row();
  std::size_t number = 0;
  for (const auto& leaf : findings_.leaves) {
    csv.count(++number);
    add_pattern(csv, problem_, leaf.block, leaf.pattern, findings_.idle());
    csv.word(state_name(leaf.state)).number(leaf.lower).number(leaf.upper);
    add_configuration(csv, problem_, of_all_candidates(problem_, leaf.block, leaf.reaction),
                      of_all_candidates(problem_, leaf.block, leaf.displacement));
    csv.end_row();
  }
}

ordered_json PatternsReport::json(const WholeStateJson& whole) const {
  ordered_json patterns = ordered_json::array();
  for (const auto& leaf : findings_.leaves) {
    auto pattern = pattern_json(problem_, leaf.block, leaf.pattern, findings_.idle());
    pattern["state"] = state_name(leaf.state);
    pattern["margin"] = leaf.lower;
    pattern["margin_upper"] = leaf.upper;
    pattern["reaction"] = block_rows(problem_, leaf.block, leaf.reaction);
    pattern["displacement"] = block_rows(problem_, leaf.block, leaf.displacement);
    whole.add_to(pattern, of_all_candidates(problem_, leaf.block, leaf.reaction),
                 of_all_candidates(problem_, leaf.block, leaf.displacement));
    patterns.push_back(std::move(pattern));
  }
  ordered_json blocks = ordered_json::array();
  for (const auto& block : findings_.blocks) {
    blocks.push_back({{"candidates", candidate_names(problem_, block.candidates)},
                      {"count", block.cones},
                      {"branching", name_of(block.branching)},
                      {"bound_programs", block.bound_programs}});
  }
  ordered_json tree = counts_json(findings_.outcome.tally());
  tree["opened"] = findings_.outcome.opened();
  tree["open"] = findings_.outcome.open;
  tree["fingerprint"] = hexadecimal(findings_.outcome.fingerprint());
  ordered_json result = {{"friction", options_.friction},  {"tolerance", options_.tolerance},
                         {"count", findings_.count()},     {"flat", findings_.flat},
                         {"marginal", findings_.marginal}, {"undecided", findings_.undecided},
                         {"blocks", std::move(blocks)},    {"tree", std::move(tree)}};
  if (options_.polyhedral) result["candidates"] = candidates_json();
  result["patterns"] = std::move(patterns);
  return {
      {"command", "patterns"},
      {"version", KUSABI_VERSION},
      {"problem", problem_json(whole.structure(), problem_, options_.file)},
      {"options",
       {{"mu", options_.friction},
        {"tolerance", options_.tolerance},
        {"method", options_.polyhedral ? "polyhedral" : "cones"},
        {"facets", options_.facets_in_use()},
        {"branching", name_of(options_.branching)},
        {"cuts", name_of(options_.tightening)},
        {"order", options_.order == engine::Order::depth_first ? "depth-first" : "breadth-first"}}},
      {"status", status_name(findings_.outcome.status)},
      {"result", std::move(result)},
      {"statistics",
       {{"ranks", rank_reports(findings_.outcome.ranks, counts_json<wedged::SignPatternTally>)},
        {"earlier_runs",
         rank_reports(findings_.outcome.earlier, counts_json<wedged::SignPatternTally>)}}}};
}

}  // namespace kusabi::run
