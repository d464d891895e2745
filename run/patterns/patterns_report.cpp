// Text below the table, and JSON, of `kusabi patterns`.
#include "run/patterns/patterns_report.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

#include <fmt/format.h>

#include "answer/values.hpp"
#include "answer/words.hpp"
#include "run/output/name_ranges.hpp"
#include "run/output/rank_table.hpp"
#include "run/output/rounded_within.hpp"
#include "run/output/values.hpp"
#include "run/patterns/pattern_lines.hpp"
#include "run/wedged/configuration_files.hpp"
#include "run/wedged/nearest_failure.hpp"
#include "run/wedged/pattern_groups.hpp"
#include "run/wedged/problem_summary.hpp"
#include "support/rounded_bounds.hpp"

namespace kusabi::run {
namespace {

using nlohmann::ordered_json;

std::string patterns(const support::ExactCount& count) {
  return answer::counted(count, "sign pattern");
}

// Number of patterns if all open leaves are patterns and none is contained in another.
support::ExactCount max_patterns(const wedged::PatternFindings& findings) {
  std::vector<std::uint64_t> of_blocks;
  for (const auto& block : findings.blocks) of_blocks.push_back(block.cones + block.unresolved);
  return wedged::combinations(of_blocks);
}

void add_firmness(CsvWriter& csv, const std::optional<wedged::Firmness>& firmness) {
  for (const auto end : {&wedged::Firmness::low, &wedged::Firmness::low_out,
                         &wedged::Firmness::high, &wedged::Firmness::high_out}) {
    if (firmness)
      csv.number((*firmness).*end);
    else
      csv.nothing();
  }
}

}  // namespace

const char* state_name(wedged::LeafState state) {
  switch (state) {
    case wedged::LeafState::feasible:
      return "feasible";
    case wedged::LeafState::flat:
      return "flat";
    case wedged::LeafState::marginal:
      return "marginal";
    case wedged::LeafState::undecided:
      break;
  }
  return "undecided";
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

answer::Verdict PatternsReport::verdict() const {
  // A pattern answers --exists; a search that is complete has listed all of them.
  const bool example = options_.parameters.exists && findings_.count() != 0U &&
                       findings_.outcome.status == engine::Status::solution_limit;
  // Degenerate nodes and nodes of unconstrained bodies are classified by cut-offs unless the exact
  // test has decided them. An example does not depend on other nodes.
  const auto& exact = findings_.exact;
  const bool bounded = findings_.flat == 0 && (example || exact.unproved == 0);
  const bool proved = exact.done ? exact.proves() : bounded && problem_.modes.bodies.empty();
  const answer::Sticking sticking{
      .friction = options_.friction,
      .factor = !problems::uniform_friction(problem_),
      .count = findings_.count(),
      .undecided = findings_.unresolved(),
      .standing = support::proved_if(proved),
      .grounds = exact.done ? answer::Grounds::exact_arithmetic : answer::Grounds::solver_bounds,
      .degenerate = exact.unproved,
      .remainder = remainder_of(exact),
      .displacement_ratio = exact.displacement_ratio,
      .example = example};
  answer::Verdict verdict{.ended = example ? engine::Status::solved : findings_.outcome.status,
                          .nodes_left = example ? 0 : findings_.outcome.open,
                          .answer = sticking};
  if (auto text = largest_margin(); !text.empty()) verdict.details.push_back(std::move(text));
  if (!firmness_.empty()) verdict.details.push_back(largest_load());
  if (!brackets_.empty()) verdict.details.push_back(least_friction());
  if (answer::is_known_to_stick(sticking))
    verdict.details.push_back(answer::next_step(findings_.count() != 1U && brackets_.empty()));
  if (options_.sort == PatternSort::critical && brackets_.empty() && !findings_.leaves.empty()) {
    verdict.missing.emplace_back(
        "The coefficients from which the patterns stick (--sort critical) were not all computed; "
        "the table is in the order found.");
  }
  return verdict;
}

// The pattern with the largest margin, or the only one known, and its nearest inequality.
std::string PatternsReport::largest_margin() const {
  const auto& leaves = findings_.leaves;
  const bool listed = findings_.largest.empty();
  if (listed && leaves.empty()) return {};
  const auto& best = listed ? *this->best() : findings_.largest.front();
  const bool all = findings_.is_complete();
  const bool flat = best.state == wedged::LeafState::flat;
  if (!flat && best.state != wedged::LeafState::feasible) return {};
  const auto number =
      listed ? static_cast<std::size_t>(this->best() - leaves.begin()) + 1 : (*numbers_).front();
  const auto contact =
      contact_words(problem_, best.block, best.pattern.contact, best.pattern.inactive);
  const bool one = findings_.count() == 1U;
  const auto way = fmt::format("{} is {}", all ? "The only way" : "One way", contact);
  if (flat && one) return way + ", without a margin: some inequality is an equality.";
  if (flat) {
    return fmt::format("None{} has a margin: in each, some inequality is an equality.",
                       all ? "" : " of those known");
  }
  const auto name = number == 0 ? fmt::format("{} pattern", all ? "One" : "one")
                                : fmt::format("{} {}", all ? "Pattern" : "pattern", number);
  const auto margin = support::rounded_down(best.lower, 3);
  // Blocks have units of their own for gaps.
  const auto head =
      one ? fmt::format("{}, with a margin of {}.", way, margin)
          : fmt::format("{}{} has the largest margin{}, {}, with {}.",
                        all ? "" : "Of those known, ", name,
                        findings_.blocks.size() > 1 ? " of its block" : "", margin, contact);
  const auto nearest = nearest_failure(problem_, options_.friction, best.block, best.pattern,
                                       best.reaction, best.displacement);
  return head + needed_friction(best, nearest.need) + nearest_failure_text(problem_, nearest);
}

// The coefficient that the configuration with the margin of its pattern needs, and the least one
// of the pattern if that is known.
std::string PatternsReport::needed_friction(const wedged::Configuration& configuration,
                                            const FrictionNeed& need) const {
  if (need.slips.empty()) return " Its configuration with this margin needs no friction.";
  const bool factor = !problems::uniform_friction(problem_);
  const auto need_text =
      needed_friction_text(need.coefficient, options_.friction, support::digits_of_sentence);
  std::string others = "others of the pattern may need less";
  if (!brackets_.empty()) {
    const auto number = static_cast<std::size_t>(best() - findings_.leaves.begin());
    const auto& upper = brackets_[number].upper;
    if (upper && number != first_to_stick()) {  // that one has a sentence of its own
      others = fmt::format("the pattern sticks from {} on{}",
                           answer::short_friction_words(support::rounded_up(*upper), factor),
                           answer::unless_proved(support::Standing::computed));
    }
  }
  return fmt::format(
      " Its configuration with this margin needs {}; with less, {}; {}.",
      factor ? answer::friction_words(need_text, factor) : "a friction coefficient of " + need_text,
      slip_words(problem_, configuration.block, configuration.pattern.contact, need), others);
}

std::size_t PatternsReport::first_to_stick() const {
  const auto upper = [](const wedged::PatternBracket& each) {
    return each.upper.value_or(std::numeric_limits<double>::infinity());
  };
  return static_cast<std::size_t>(std::ranges::min_element(brackets_, {}, upper) -
                                  brackets_.begin());
}

// The pattern that begins to stick with the least friction of all that are listed.
std::string PatternsReport::least_friction() const {
  const auto first = first_to_stick();
  const auto& upper = brackets_[first].upper;
  if (!upper) return "From which coefficient on the patterns stick is not known.";
  return fmt::format(
      "Pattern {} sticks with the least friction of those listed, from {} on{}.", first + 1,
      answer::friction_words(support::rounded_up(*upper), !problems::uniform_friction(problem_)),
      answer::unless_proved(support::Standing::computed));
}

// The pattern that holds the largest factor, for each unit of its normal reactions. Patterns
// without a known margin have no factors, and each block holds its own part of the load.
std::string PatternsReport::largest_load() const {
  const auto solid = std::ranges::count(findings_.leaves, wedged::LeafState::feasible,
                                        &wedged::Configuration::state);
  if (solid == 0)
    return "None is known to have a margin, so the loads that they hold are not computed.";
  const bool all = solid == std::ssize(findings_.leaves);
  std::size_t best = firmness_.size();
  for (std::size_t i = 0; i < firmness_.size(); ++i) {
    if (firmness_[i] && (best == firmness_.size() || firmness_[i]->high > firmness_[best]->high))
      best = i;
  }
  if (best == firmness_.size()) {
    return fmt::format("The reference load acts on none of the patterns{}.",
                       all ? "" : " known to have a margin");
  }
  const auto& [low_out, low, high, high_out] = *firmness_[best];
  const auto held = fmt::format(
      "{} holds the {}", best + 1,
      findings_.blocks.size() > 1 ? "part of the reference load on its block" : "reference load");
  if (std::isinf(high)) {
    return fmt::format("Number {} at any factor{}.", held,
                       std::isinf(low) ? "" : fmt::format(" from {} on", support::rounded_up(low)));
  }
  return fmt::format(
      "While its normal reactions add up to 1, number {} up to a factor of {}, the largest of {}.",
      held, support::rounded_down(high), all ? "all patterns" : "those known to have a margin");
}

std::string PatternsReport::details() const {
  std::string text;
  auto out = std::back_inserter(text);
  const auto count = findings_.count();
  const auto known = [&](bool one) {
    return findings_.whole() ? "" : one ? " is known" : " are known";
  };
  fmt::format_to(out,
                 "\n{} of wedged configurations{} at {}; {} marginal "
                 "(|t*| <= {})\n",
                 patterns(count), known(count == 1U), friction_text(problem_, options_.friction),
                 findings_.marginal, options_.parameters.tree.tolerances.sign);
  if (findings_.flat != 0) {
    fmt::format_to(out, "{} of the list flat (t* = 0): in all their configurations {}\n",
                   findings_.flat, answer::of_flat_pattern);
  }
  if (findings_.blocks.size() > 1) {
    fmt::format_to(out,
                   "the structure consists of {} decoupled blocks, each of which wedges or is "
                   "inactive independently:\n",
                   findings_.blocks.size());
    for (const auto& block : findings_.blocks) {
      fmt::format_to(out, "  {}: {}\n", with_ranges(candidate_names(problem_, block.candidates)),
                     block.is_inactive() && findings_.whole()
                         ? "always inactive"
                         : patterns(block.cones) + known(block.cones == 1));
    }
    const auto wedging = std::count_if(findings_.blocks.begin(), findings_.blocks.end(),
                                       [](const auto& b) { return b.cones != 0; });
    if (wedging > 1) {
      text +=
          "patterns of different blocks combine freely: the structure has the product of their "
          "numbers of patterns; the list has the patterns of each block\n";
    }
    if (findings_.whole() && findings_.unresolved() > 0) {
      fmt::format_to(out, "with undecided ones, the structure has at most {}\n",
                     patterns(max_patterns(findings_)));
    }
  }
  if (options_.polyhedral) {
    fmt::format_to(out,
                   "{} found with polyhedral friction cones of {} facets; each was then tested "
                   "with second-order cones\n",
                   answer::counted(findings_.outcome.tally().polyhedral_leaves, "sign pattern"),
                   options_.facets);
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
    return std::vector<std::uint64_t>{its.branched, its.infeasible, its.found + its.flat,
                                      its.marginal + its.undecided + its.branched_undecided,
                                      its.iterations};
  };
  ranks.add_all(findings_.outcome, own);
  const auto listed = numbers_ != nullptr  ? largest()
                      : options_.group > 0 ? groups()
                      : is_overview()      ? overview()
                                           : list();
  return listed + candidates() + details() + '\n' + ranks.text(page_.width);
}

void PatternsReport::write_csv(std::ostream& out) const {
  CsvWriter csv(out);
  csv.word("pattern");
  add_pattern_columns(csv);
  csv.word("state").word("margin").word("margin_upper");
  if (!firmness_.empty()) {
    for (const char* const end : {"low", "low_out", "high", "high_out"})
      csv.word(fmt::format("firmness_{}", end));
  }
  add_configuration_columns(csv, problem_);
  csv.end_row();
  std::size_t number = 0;
  for (const auto& leaf : findings_.leaves) {
    csv.count(++number);
    add_pattern(csv, problem_, leaf.block, leaf.pattern, findings_.inactive());
    csv.word(state_name(leaf.state)).number(leaf.lower).number(leaf.upper);
    if (!firmness_.empty()) add_firmness(csv, firmness_[number - 1]);
    add_configuration(csv, problem_, of_all_candidates(problem_, leaf.block, leaf.reaction),
                      of_all_candidates(problem_, leaf.block, leaf.displacement));
    csv.end_row();
  }
}

void PatternsReport::write_patterns(JsonWriter& json, const WholeStateJson& whole) const {
  const auto& leaves = findings_.leaves;
  const auto largest = static_cast<std::size_t>(best() - leaves.begin());
  json.begin_list();
  for (std::size_t i = 0; i < leaves.size(); ++i) {
    const auto& leaf = leaves[i];
    auto pattern = lean_pattern(problem_, leaf, findings_.inactive());
    if (!brackets_.empty()) {
      pattern["critical_friction"] = {{"lower", brackets_[i].lower},
                                      {"upper", answer::number_or_null(brackets_[i].upper)}};
    }
    if (!firmness_.empty()) pattern["firmness"] = firmness_json(firmness_[i]);
    if (options_.whole || i < whole_unless_requested || i == largest)
      whole.add_to(pattern, leaf.block, leaf.reaction, leaf.displacement);
    json.value(pattern);
  }
  json.end_list();
}

ordered_json PatternsReport::groups_json() const {
  auto list = ordered_json::array();
  for (const auto& group : pattern_groups(findings_.leaves, options_.group)) {
    auto members = ordered_json::array();
    for (const auto member : group.members) members.push_back(member + 1);
    list.push_back({{"patterns", std::move(members)},
                    {"largest_margin", group.largest_margin + 1},
                    {"contact", candidate_names(problem_, group.contact)},
                    {"varying", candidate_names(problem_, group.varying)}});
  }
  return list;
}

// All but the list of patterns.
ordered_json PatternsReport::result_json() const {
  ordered_json blocks = ordered_json::array();
  for (const auto& block : findings_.blocks) {
    blocks.push_back({{"candidates", candidate_names(problem_, block.candidates)},
                      {"count", block.cones},
                      {"branching", word_of(branching_words(), block.branching)},
                      {"bound_programs", block.bound_programs}});
  }
  ordered_json tree = counts_json(findings_.outcome.tally());
  tree["opened"] = findings_.outcome.opened();
  tree["open"] = findings_.outcome.open;
  tree["fingerprint"] = hexadecimal(findings_.outcome.fingerprint());
  ordered_json result = {{"tolerance", options_.parameters.tree.tolerances.sign}};
  result["flat"] = findings_.flat;
  result["marginal"] = findings_.marginal;
  result["undecided"] = findings_.undecided;
  result["blocks"] = std::move(blocks);
  result["tree"] = std::move(tree);
  result["exact"] = exact_json(findings_.exact);
  if (options_.polyhedral) result["candidates"] = candidates_json();
  return result;
}

ordered_json PatternsReport::statistics_json() const {
  const auto& outcome = findings_.outcome;
  return {{"ranks", rank_reports(outcome.ranks, counts_json<wedged::SignPatternTally>)},
          {"earlier_runs", rank_reports(outcome.earlier, counts_json<wedged::SignPatternTally>)}};
}

void PatternsReport::write(JsonWriter& json, ordered_json head, const WholeStateJson& whole) const {
  json.begin_result(std::move(head), result_json());
  json.key("patterns");
  write_patterns(json, whole);
  if (options_.group > 0) json.member("groups", groups_json());
  json.end_object();
  json.member("statistics", statistics_json());
  json.end_object();
}

std::string PatternsReport::head_line(ordered_json head) const {
  head["result"].update(result_json());
  head["lines"] = "patterns";
  head["statistics"] = statistics_json();
  return json_line(head);
}

}  // namespace kusabi::run
