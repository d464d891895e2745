// Table of `kusabi patterns`: one line per pattern, or per group of patterns.
#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <limits>
#include <numeric>
#include <utility>

#include <fmt/format.h>

#include "answer/values.hpp"
#include "run/output/name_ranges.hpp"
#include "run/patterns/patterns_report.hpp"
#include "run/wedged/pattern_groups.hpp"
#include "run/wedged/problem_summary.hpp"
#include "support/rounded_bounds.hpp"

namespace kusabi::run {
namespace {

/// Maximum number of lines before the table becomes an overview, and maximum number of groups in
/// it.
constexpr std::size_t many_lines = 40;
constexpr std::size_t many_groups = 20;

constexpr const char* head_of_contact = "in contact (U); others separated (R)";

std::string margin_text(const wedged::Configuration& leaf) {
  return leaf.state == wedged::LeafState::feasible ? fmt::format("{:.3e}", leaf.lower)
                                                   : state_name(leaf.state);
}

std::string start_text(const wedged::PatternBracket& bracket) {
  return bracket.upper ? fmt::format("{:.6g}", *bracket.upper) : "?";
}

std::string held_text(const std::optional<wedged::Firmness>& firmness) {
  const auto end = [](double factor, const std::string& shown) {
    return std::isinf(factor) ? std::string("any") : shown;
  };
  const auto [low, high] =
      firmness ? std::pair(end(firmness->low,
                               support::rounded_up(firmness->low, support::digits_of_table)),
                           end(firmness->high,
                               support::rounded_down(firmness->high, support::digits_of_table)))
               : std::pair(std::string("-"), std::string("-"));
  return fmt::format("{:>14}  {:>12}", low, high);
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
    case PatternSort::critical:
      if (brackets_.empty()) break;
      std::ranges::stable_sort(order, std::less(), [&](auto i) {
        return brackets_[i].upper.value_or(std::numeric_limits<double>::infinity());
      });
      break;
  }
  return order;
}

std::string PatternsReport::names(const support::IndexSet& candidates) const {
  return with_ranges(candidate_names(problem_, candidates));
}

std::string PatternsReport::row(std::size_t number) const {
  const auto& leaf = findings_.leaves[number];
  const auto from =
      brackets_.empty() ? std::string{} : fmt::format("  {:>11}", start_text(brackets_[number]));
  const auto held = firmness_.empty() ? std::string{} : "  " + held_text(firmness_[number]);
  return fmt::format("{:>5}  {:>10}{}{}  {}\n", number + 1, margin_text(leaf), from, held,
                     contact_text(problem_, leaf.pattern));
}

std::string PatternsReport::list() const {
  auto shown = order();
  const std::size_t all = shown.size();
  if (all == 0) return {};
  shown.resize(std::min<std::size_t>(all, options_.top));
  auto text = fmt::format(
      "\n{:>5}  {:>10}{}{}  {}\n", "", "margin t*", brackets_.empty() ? "" : "  sticks from",
      firmness_.empty() ? "" : "  load held from  load held to", head_of_contact);
  for (const std::size_t i : shown) text += row(i);
  if (shown.size() < all) text += fmt::format("{:>5}  {} more\n", "…", all - shown.size());
  if (!brackets_.empty()) text += begins_explained;
  if (!firmness_.empty()) {
    text +=
        "       (load held: factors of the reference load, while the normal reactions of the "
        "pattern add up to 1)\n";
  }
  if (shown.size() > many_lines) {
    text +=
        "       (--sort margin --top 10 lists those with the largest margins; --group 1 groups "
        "those that differ in one candidate)\n";
  }
  return text;
}

std::string PatternsReport::largest() const {
  const auto& leaves = findings_.largest;
  const auto shown = std::min<std::size_t>(leaves.size(), options_.top);
  if (shown == 0) return {};
  auto text = fmt::format("\n{:>9}  {:>10}  {}\n", "number", "margin t*", head_of_contact);
  for (std::size_t i = 0; i < shown; ++i) {
    const auto number = (*numbers_)[i];
    text += fmt::format("{:>9}  {:>10}  {}\n", number == 0 ? "" : std::to_string(number),
                        margin_text(leaves[i]), contact_text(problem_, leaves[i].pattern));
  }
  return text + fmt::format("{:>9}  those with the largest margins; the file lists all\n", "…");
}

std::string PatternsReport::groups() const {
  auto groups = pattern_groups(findings_.leaves, options_.group);
  const std::size_t all = groups.size();
  if (all == 0) return {};
  groups.resize(std::min<std::size_t>(all, options_.top));
  auto text = fmt::format("\n{:>5}  {:>8}  {:>10}  {:>7}  in contact in all | in some of them\n",
                          "group", "patterns", "margin t*", "number");
  std::size_t number = 0;
  for (const auto& group : groups) {
    text += fmt::format("{:>5}  {:>8}  {:>10}  {:>7}  {} | {}\n", ++number, group.members.size(),
                        margin_text(findings_.leaves[group.largest_margin]),
                        group.largest_margin + 1, names(group.contact), names(group.varying));
  }
  if (all > groups.size()) text += fmt::format("{:>5}  {} more\n", "…", all - groups.size());
  text += fmt::format(
      "       {} of patterns with steps of at most {}; margin and number are those of the member "
      "with the largest margin\n",
      answer::counted(all, "group"), answer::counted(options_.group, "candidate"));
  return text;
}

// An explicit --sort, --top or --group is obeyed, and files and pipes have one line per pattern.
bool PatternsReport::is_overview() const {
  return page_.width != Page::endless && options_.group < 0 &&
         options_.sort == PatternSort::number && options_.top > findings_.leaves.size() &&
         findings_.leaves.size() > many_lines;
}

std::string PatternsReport::overview() const {
  const auto& leaves = findings_.leaves;
  const auto max_groups = std::max(many_groups, findings_.blocks.size());
  int apart = 1;
  auto groups = groups_around_largest_margin(leaves, apart, max_groups);
  while (!groups) groups = groups_around_largest_margin(leaves, ++apart, max_groups);
  auto text = fmt::format("\n{:>8}  {:>10}  {:>7}  {}\n", "patterns", "margin t*", "number",
                          "that with the largest margin is in contact at");
  for (const auto& group : *groups) {
    const auto& largest_margin = leaves[group.largest_margin];
    text +=
        fmt::format("{:>8}  {:>10}  {:>7}  {}\n", group.members.size(), margin_text(largest_margin),
                    group.largest_margin + 1, contact_text(problem_, largest_margin.pattern));
  }
  return text +
         fmt::format(
             "{} in {}: members differ from that with the largest margin in at most {}. --group 0 "
             "lists all, --sort margin --top 10 the largest margins; files contain all\n",
             answer::counted(leaves.size(), "pattern"), answer::counted(groups->size(), "group"),
             answer::counted(apart, "candidate"));
}

// Candidates of Algorithm 5.8: Y_1, ..., Y_k, with the result of (23) for each.
std::string PatternsReport::candidates() const {
  std::string text;
  if (!options_.list_candidates) return text;
  auto out = std::back_inserter(text);
  fmt::format_to(out, "\n{:>5}  {:>13}  {:>10}  {}\n", "", "polyhedral t*", "t* of (23)",
                 "in contact (U) | separated (R)");
  std::size_t number = 0;
  for (const auto& candidate : findings_.tested) {
    const auto& [contact, separated, inactive] = candidate.pattern;
    fmt::format_to(out, "{:>5}  {:>13.3e}  {:>10}  {} | {}\n", ++number, candidate.polyhedral,
                   candidate.discarded() ? "discarded" : fmt::format("{:.3e}", candidate.lower),
                   names(contact), names(separated));
  }
  return text;
}

}  // namespace kusabi::run
