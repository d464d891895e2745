// Sentences about states under load: smallest friction coefficient, and load factors.
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "answer/answer_words.hpp"
#include "answer/values.hpp"
#include "support/input_error.hpp"
#include "support/rounded_bounds.hpp"

namespace kusabi::answer {
namespace {

constexpr const char* held_by_supports =
    "It can hold any load: the supports constrain every body, which then has a state of "
    "equilibrium under every load at any friction coefficient.";

template <class Found>
std::string unbalanced_load(const Found& found) {
  return fmt::format(
      "It cannot hold the load{} at any friction coefficient: the load moves a body in a direction "
      "that no candidate resists.",
      found.load_case.empty() ? "" : " in load case " + support::in_quotes(found.load_case));
}

// Of the claim that nothing else is held, where it is made.
template <class Found>
const char* of_others(const Found& found) {
  return unless_proved(found.outside.value_or(Standing::computed));
}

std::string part(const HoldingFactors::Interval& each) {
  const auto standing = unless_proved(each.states());
  if (std::isinf(each.low()))
    return fmt::format("all up to {}{}", support::rounded_down(each.high()), standing);
  if (std::isinf(each.high()))
    return fmt::format("all from {} on{}", support::rounded_up(each.low()), standing);
  if (each.low() == each.high()) {
    const auto shown = fmt::format("{:.6g}", each.low());
    const bool all = shown == fmt::format("{}", each.low());
    return (all ? "" : "about ") + shown + standing;
  }
  const auto [low, high] = support::inside(each.low(), each.high());
  return fmt::format("from {} to {}{}", low, high, standing);
}

std::string parts(const HoldingFactors& found) {
  std::string text;
  for (std::size_t i = 0; i < found.intervals.size(); ++i) {
    if (i > 0) text += i + 1 == found.intervals.size() ? " and " : ", ";
    text += part(found.intervals[i]);
  }
  return text;
}

// ", and none below 1 or above 2", rounded away from the factors that are held.
std::string none_outside(const HoldingFactors& found) {
  const auto& all = found.intervals;
  // The doubles beside zero are bounds of all numbers of one sign.
  const auto out = [](const std::optional<Bound>& bound, double held) {
    const double value = bound ? bound->value : held;
    return std::fpclassify(value) == FP_SUBNORMAL ? 0 : value;
  };
  std::string text;
  const auto add = [&](const std::string& range) {
    text += (text.empty() ? ", and none " : " or ") + range;
  };
  if (std::isfinite(all.front().low()))
    add("below " + support::rounded_down(out(all.front().below.lower, all.front().low())));
  for (std::size_t i = 1; i < all.size(); ++i) {
    const auto [from, to] = support::inside(out(all[i - 1].above.upper, all[i - 1].high()),
                                            out(all[i].below.lower, all[i].low()));
    add(fmt::format("between {} and {}", from, to));
  }
  if (std::isfinite(all.back().high()))
    add("above " + support::rounded_up(out(all.back().above.upper, all.back().high())));
  return text;
}

// " in load case "wind"", " in every one of 2 load cases".
template <class Found>
std::string in_case(const Found& found) {
  if (!found.cases.empty()) return " in every one of " + counted(found.cases.size(), "load case");
  return found.load_case.empty() ? "" : " in load case " + support::in_quotes(found.load_case);
}

// "from 1 to 2", "all", "none"; of a dead load "it can be held" or "it cannot be held".
std::string factors_at(const HoldingFactors& found) {
  const bool reference = found.of_reference;
  if (found.intervals.empty()) {
    if (found.open) return reference ? "not known" : "this is not known";
    return fmt::format("{}{}", reference ? "none" : "it cannot be held", of_others(found));
  }
  const char* const standing = unless_proved(found.intervals.front().states());
  if (!reference) return fmt::format("it can be held{}", standing);
  if (found.holds_all()) return fmt::format("all{}", standing);
  return parts(found) + (found.open ? " (others are not known)" : "");
}

}  // namespace

std::string none_standing_words(const std::optional<Standing>& none) {
  return none ? fmt::format("none, {}", standing_word(*none)) : "not known";
}

std::string headline_of(const HoldingBracket& found, engine::Status ended) {
  if (found.reason == HoldReason::supports) return held_by_supports;
  if (found.reason == HoldReason::unbalanced) return unbalanced_load(found);
  const auto& [lower, upper] = found.bracket;
  const auto load = "the dead load" + in_case(found);
  if (!lower && !upper)
    return fmt::format("The smallest friction coefficient at which it can hold {} is not known.",
                       load);
  if (upper && upper->value == 0)
    return fmt::format("It can hold {} without friction{}.", load, unless_proved(upper->standing));
  return friction_sentence("hold " + load, found.bracket, found.factor, found.maximum,
                           ended != engine::Status::solved);
}

void reserve(const HoldingBracket& found, engine::Status /*ended*/, std::vector<Reservation>& all) {
  const auto& [lower, upper] = found.bracket;
  if (found.reason != HoldReason::searched) return;
  reserve_undecided("hold the dead load", found.bracket, found.maximum, all);
  if (upper && upper->value > 0 && !lower)
    all.push_back({"A coefficient at which it cannot hold the dead load is not known.", true});
  if (lower && lower->standing == Standing::computed) {
    all.push_back({fmt::format("Computed, not proved: it cannot hold the dead load at {}.",
                               support::rounded_down(lower->value, support::digits_of_table)),
                   true});
  }
  if (upper && upper->standing == Standing::computed) {
    all.push_back({fmt::format("Computed, not proved: it can hold the dead load at {}; some "
                               "inequality may hold only within the rounding of the file's "
                               "numbers.",
                               support::rounded_up(upper->value, support::digits_of_table)),
                   false});
  }
}

std::string headline_of(const HoldingFactors& found, engine::Status /*ended*/) {
  if (found.reason == HoldReason::supports) return held_by_supports;
  auto where = fmt::format("at {}{}", friction_words(found.friction, found.factor), in_case(found));
  if (found.total) where += fmt::format(" with normal reactions that add up to {}", *found.total);
  if (found.reason == HoldReason::wedging) {
    return fmt::format(
        "It can hold {} {}: it can be wedged there, with a residual stress of any size.",
        found.of_reference ? "the reference load at any factor" : "the dead load", where);
  }
  if (found.intervals.empty()) {
    // A case that holds nothing decides alone.
    const auto none = std::ranges::find_if(found.cases, [&](const auto& each) {
      return each.name == found.load_case && each.intervals.empty() && !each.open;
    });
    if (none != found.cases.end()) {
      auto alone = found;
      alone.cases.clear();
      alone.open = false;
      alone.outside = none->outside;
      alone.reason = none->reason;
      return headline_of(alone, engine::Status::solved);
    }
    if (found.open)
      return fmt::format("It is not known whether it can hold {} {}.",
                         found.of_reference ? "any factor of the reference load" : "the dead load",
                         where);
    if (found.reason == HoldReason::unbalanced) return unbalanced_load(found);
    return fmt::format("It {} {}{}.",
                       found.of_reference ? "can hold no factor of the reference load"
                                          : "cannot hold the dead load",
                       where, of_others(found));
  }
  if (!found.of_reference) {
    return fmt::format("It can hold the dead load {}{}.", where,
                       unless_proved(found.intervals.front().states()));
  }
  if (found.holds_all()) {
    return fmt::format("It can hold the reference load at any factor {}{}.", where,
                       unless_proved(found.intervals.front().states()));
  }
  const auto others =
      found.open ? std::string("; others are not known") : none_outside(found) + of_others(found);
  return fmt::format("It can hold these factors of the reference load {}: {}{}.", where,
                     parts(found), others);
}

std::string headline_of(const HoldingSweep& found, engine::Status /*ended*/) {
  if (found.points.empty()) return "The loads that it can hold are not known.";
  if (found.points.front().reason == HoldReason::supports) return held_by_supports;
  if (found.points.front().reason == HoldReason::unbalanced)
    return unbalanced_load(found.points.front());
  const auto at = [](const HoldingFactors& point) {
    return fmt::format("at {} {}",
                       short_friction_words(fmt::format("{}", point.friction), point.factor),
                       factors_at(point));
  };
  const auto& points = found.points;
  const auto* const names =
      points.front().factor ? "factors of the friction given in the file" : "friction coefficients";
  const auto where = points.size() == found.requested
                         ? fmt::format("at {} {}", points.size(), names)
                         : fmt::format("at {} of {} {} (the others are not known)", points.size(),
                                       found.requested, names);
  const auto of = in_case(points.front());
  const auto& total = points.front().total;
  const auto sum =
      total ? fmt::format(" with normal reactions that add up to {}", *total) : std::string();
  const auto what =
      points.front().of_reference
          ? fmt::format("It can hold these factors of the reference load {}{}{}", where, of, sum)
          : fmt::format("These are the answers for the dead load {}{}{}", where, of, sum);
  return fmt::format(
      "{}: {}{}{}.", what, at(points.front()), points.size() > 1 ? ", " + at(points.back()) : "",
      points.size() > 2 ? fmt::format("; the table has the {}other coefficients",
                                      points.front().of_reference ? "factors at the " : "")
                        : std::string());
}

std::string headline_of(const HoldingDiagram& found, engine::Status /*ended*/) {
  const auto where = "at " + friction_words(found.friction, found.factor);
  const auto pairs = fmt::format("pairs of factors of the reference loads \"{}\" and \"{}\"",
                                 found.cases.front(), found.cases.back());
  if (found.everything) return fmt::format("It can hold all {} {}.", pairs, where);
  if (found.pieces == 0) {
    if (found.open) return fmt::format("The {} that it can hold {} are not known.", pairs, where);
    return fmt::format("It can hold no {} {}{}.", pairs, where, of_others(found));
  }
  return fmt::format("It can hold the {} in {} {}{}.", pairs, counted(found.pieces, "convex piece"),
                     where,
                     found.open ? std::string("; others are not known")
                                : fmt::format(", and no other{}", of_others(found)));
}

void reserve(const HoldingDiagram& found, engine::Status ended, std::vector<Reservation>& all) {
  if (found.open && ended == engine::Status::solved)
    all.push_back({"Some sign patterns are undecided; pieces may be missing.", true});
  if (found.outside == Standing::computed)
    all.push_back(
        {"Computed, not proved: no other pair is held. The states of some sign patterns are, up to "
         "rounding, states of another pattern, as happens with a load at a candidate.",
         true});
  if (found.coarse > 0) {
    all.push_back({fmt::format("{} may be larger than drawn, by more than 1e-5 of the size.",
                               counted(found.coarse, "piece")),
                   false});
  }
}

std::string grip_sentence(const HoldingGrip& grip) {
  if (!grip.held) {
    return fmt::format(
        "There is no state under the dead load alone{}, so there is no sum of normal reactions.",
        unless_proved(grip.standing));
  }
  std::string text = grip.standing == Standing::proved
                         ? ""
                         : "That there is a state under the dead load alone is computed, not "
                           "proved. ";
  text += "In every state under the dead load alone the normal reactions add up to ";
  const auto least = grip.at_least();
  const auto lower = support::rounded_down(least.value) + unless_proved(least.standing);
  const auto& of_some = grip.minimum.upper;
  const auto& most = grip.maximum.upper;
  if (most && !grip.unbounded) {
    text += fmt::format("between {} and {}{}", lower, support::rounded_up(most->value),
                        unless_proved(most->standing));
  } else {
    text += lower + " or more";
  }
  if (of_some && !grip.has_least())
    text += fmt::format(", in some to {} or less{}", support::rounded_up(of_some->value),
                        unless_proved(of_some->standing));
  if (grip.unbounded) {
    text += fmt::format(
        "; there is no upper bound, since it can be wedged with a residual stress of any size{}",
        unless_proved(grip.unbounded_standing));
  } else if (!most) {
    text += of_some ? "; an upper bound is not known"
                    : "; a larger lower bound and an upper bound are not known";
  } else if (!of_some) {
    text += "; a larger lower bound is not known";
  }
  return text + '.';
}

std::array<std::string, 2> grip_standing_words(const HoldingGrip& grip) {
  if (!grip.held) {
    const auto none = fmt::format("no state, {}", standing_word(grip.standing));
    return {none, none};
  }
  const auto& most = grip.maximum.upper;
  return {standing_word(grip.at_least().standing),
          grip.unbounded ? none_standing_words(grip.unbounded_standing)
          : most         ? standing_word(most->standing)
                         : none_standing_words({})};
}

std::string grip_line(const HoldingGrip& grip) {
  const std::string name = "sum of the normal reactions under the dead load alone: ";
  if (!grip.held) return name + "no state " + in_brackets(grip.standing) + '\n';
  const auto least = grip.at_least();
  const auto& of_some = grip.minimum.upper;
  const auto shown = support::in_table(least.value, of_some ? of_some->value : least.value);
  auto text = fmt::format("{}at least {} {}", name, shown.lower, in_brackets(least.standing));
  if (of_some && !grip.has_least())
    text +=
        fmt::format(", of some state at most {} {}", shown.upper, in_brackets(of_some->standing));
  if (grip.unbounded)
    return text + ", no upper bound " + in_brackets(grip.unbounded_standing) + '\n';
  const auto& [held, most] = grip.maximum;
  if (!most) return text + ", upper bound not known\n";
  return text + fmt::format(", at most {} {}\n",
                            support::in_table(held ? held->value : most->value, most->value).upper,
                            in_brackets(most->standing));
}

namespace {

void reserve_range(const HoldingGrip& grip, std::vector<Reservation>& all) {
  if (!grip.held) {
    if (grip.standing == Standing::computed)
      all.push_back({"Computed, not proved: there is no state under the dead load.", true});
    return;
  }
  const auto is_computed = [](const std::optional<Bound>& bound) {
    return bound && bound->standing == Standing::computed;
  };
  const auto& most = grip.maximum.upper;
  if (!grip.has_least())
    all.push_back({"The least sum of the normal reactions is not known.", true});
  if (!grip.unbounded && !most)
    all.push_back({"The largest sum of the normal reactions is not known.", true});
  if (is_computed(grip.minimum.lower) ||
      (grip.unbounded ? grip.unbounded_standing == Standing::computed : is_computed(most)))
    all.push_back({"A bound of the sum of the normal reactions is not proved.", true});
}

}  // namespace

void reserve(const HoldingSweep& found, engine::Status ended, std::vector<Reservation>& all) {
  for (const auto& point : found.points) {
    std::vector<Reservation> own;
    reserve(point, ended, own);
    for (auto& each : own) {
      each.sentence =
          fmt::format("At {}: {}", friction_words(point.friction, point.factor), each.sentence);
      all.push_back(std::move(each));
    }
  }
}

void reserve(const HoldingFactors& found, engine::Status ended, std::vector<Reservation>& all) {
  if (found.grip) reserve_range(*found.grip, all);
  if (found.open && ended == engine::Status::solved) {
    all.push_back(
        {"Some sign patterns are undecided; load factors that only they hold may be missing.",
         true});
  }
  if (found.outside == Standing::computed)
    all.push_back({"Computed, not proved: no other factor is held.", true});
  if (std::ranges::any_of(found.intervals,
                          [](const auto& each) { return each.states() == Standing::computed; })) {
    all.push_back(
        {"States at the ends of intervals are computed, not proved: some inequality may hold only "
         "within the rounding of the file's numbers.",
         false});
  }
}

}  // namespace kusabi::answer
