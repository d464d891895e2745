// Sentences about load factors.
#include <algorithm>
#include <cmath>
#include <initializer_list>

#include <fmt/format.h>

#include "answer/answer_words.hpp"
#include "support/rounded_bounds.hpp"

namespace kusabi::answer {
namespace {

// @param cases "each of", "all of"
std::string within(const LoadInterval& found, const char* cases = "each of") {
  const auto& loads = *found.uncertain;
  if (!found.reference_action.empty()) {
    return found.cases > 1 ? fmt::format("in every combination of actions, in {} {} load cases",
                                         cases, found.cases)
                           : std::string("for all factors of the actions within their ranges");
  }
  std::string text = "for every dead load within its bounds";
  if (loads.half_width == 0) text = "under its dead load";
  if (loads.half_width.value_or(0) != 0)
    text = "for every dead load within " + half_width_text(*loads.half_width, loads.force);
  if (found.cases > 1) text += fmt::format(", in {} {} load cases", cases, found.cases);
  return text;
}

// The load that the factor multiplies: "1.5 snow".
std::string reference(const LoadInterval& found) {
  if (found.reference_action.empty()) return "the reference load";
  if (found.reference_factor)
    return fmt::format("{} {}", *found.reference_factor, found.reference_action);
  return fmt::format("the action {} with its factor in each combination", found.reference_action);
}

const char* if_large(const LoadInterval& found) {
  return found.if_big_m ? " if M is large enough" : "";
}

// A load that need not carry what others carry: "some admissible load"; empty: there is only one.
std::string some_load(const LoadInterval& found) {
  if (found.uncertain && found.uncertain->half_width != 0.0)
    return found.reference_action.empty() ? "some admissible load" : "some combination of actions";
  return found.cases > 1 ? "the load of some case" : "";
}

// @param range "above 3.2": of factors, none of which is carried under all loads
std::string not_carried(const LoadInterval& found, const std::string& range) {
  const auto load = some_load(found);
  return load.empty() ? fmt::format("no factor {} is carried", range)
                      : fmt::format("{} is carried at no factor {}", load, range);
}

// Factors that are not carried, which those at full strength bound if there are struts.
std::string none_above(const LoadInterval& found) {
  const auto& upper = found.maximum.upper;
  if (!upper) return {};
  return fmt::format("; {}{}{}{}", found.struts ? "even with all struts at full strength " : "",
                     not_carried(found, "above " + support::rounded_up(upper->value)),
                     if_large(found), unless_proved(upper->standing));
}

// Condition of the factors that are carried, and what bounds them.
std::string of_struts(const LoadInterval& found) {
  if (!found.struts) return {};
  return ", while no strut falls below its residual strength" + none_above(found);
}

// The upper bound of the largest factor, unless of_struts() gives it.
std::string upper_bound(const LoadInterval& found) {
  return found.struts ? std::string() : none_above(found);
}

// The same where factors up to the lower bound are carried, if the bracket is open.
std::string gap_above(const LoadInterval& found) {
  constexpr double visible = 1e-4;  // relative, in sentences of five digits
  const auto& [lower, upper] = found.maximum;
  const bool closed = upper && upper->value - lower->value <= visible * std::abs(upper->value);
  return closed ? std::string() : upper_bound(found);
}

// No carried factor is known: the strength for which one was sought, and the bound that is known.
std::string none_found(const LoadInterval& found, const std::string& what) {
  return fmt::format("{} load factor was found {}{}.",
                     found.struts ? "With all struts at their residual strength no" : "No", what,
                     none_above(found));
}

// Standing of a statement that follows from those of these bounds that are known.
Standing of_all(std::initializer_list<std::optional<Bound>> bounds) {
  const bool proved = std::ranges::none_of(
      bounds, [](const auto& each) { return each && each->standing == Standing::computed; });
  return proved ? Standing::proved : Standing::computed;
}

// The interval is empty: its lower end lies above its upper end.
std::optional<Standing> empty(const LoadInterval& found) {
  const auto& above = found.minimum.lower;
  const auto& below = found.maximum.upper;
  if (!above || !below || above->value <= below->value) return std::nullopt;
  return found.if_big_m ? Standing::computed : of_all({above, below});
}

// The ends meet: the interval is not empty, but no factor in it is known to be carried.
bool is_undecided(const LoadInterval& found) {
  const auto& from = found.minimum.upper;
  const auto& to = found.maximum.lower;
  return from && to && from->value > to->value && !empty(found);
}

std::string in_cases(const LoadInterval& found, const char* cases = "each of") {
  return found.cases > 1 ? fmt::format(" in {} {} load cases", cases, found.cases) : std::string();
}

std::string dead_load_is_not_carried(const LoadInterval& found) {
  return fmt::format("It does not carry its dead load{} at any load factor{}.",
                     found.cases > 1 ? " of some load case" : "",
                     unless_proved(*found.carried_at_none));
}

std::optional<std::string> nominal_without_factor(const LoadInterval& found) {
  if (found.carried_at_none) return dead_load_is_not_carried(found);
  if (const auto standing = empty(found)) {
    return fmt::format("There is no load factor that it carries{}{}.", in_cases(found, "all of"),
                       unless_proved(*standing));
  }
  if (is_undecided(found)) {
    return fmt::format("It is numerically undecided whether any load factor is carried{}.",
                       in_cases(found, "all of"));
  }
  // The largest factor of a case need not be carried in the other cases.
  if (!found.maximum.lower || (found.cases > 1 && !found.minimum.upper)) {
    return none_found(found, "at which it carries its dead load" + in_cases(found));
  }
  return std::nullopt;
}

// Factors that are not carried, outside the outer bounds of the interval.
std::string none_outside(const LoadInterval& found) {
  const auto& below = found.minimum.lower;
  const auto& above = found.maximum.upper;
  if (found.struts || (!below && !above)) return {};
  return fmt::format(", and at none {}{}{}",
                     below ? "below " + support::rounded_down(below->value) : std::string(),
                     below && above ? " or " : "",
                     above ? "above " + support::rounded_up(above->value) : std::string());
}

std::string nominal(const LoadInterval& found) {
  if (auto text = nominal_without_factor(found)) return *text;
  const auto& to = found.maximum.lower;
  const auto& from = found.minimum.upper;
  const auto cases = in_cases(found);
  if (!from) {  // smaller factors need not be carried
    return fmt::format("The largest factor of {} that it carries is at least {}{}{}.",
                       reference(found), support::rounded_down(to->value),
                       unless_proved(to->standing), of_struts(found) + upper_bound(found));
  }
  auto standing = of_all({from, to});
  if (from->value > 0 || to->value < 0) {
    const auto [low, high] = support::inside(from->value, to->value);
    if (!found.struts) standing = of_all({from, to, found.minimum.lower, found.maximum.upper});
    return fmt::format("It carries its dead load{} at load factors from {} to {}{}{}{}.", cases,
                       low, high, none_outside(found), unless_proved(standing), of_struts(found));
  }
  auto shown = support::ShownBracket{support::rounded_down(to->value), {}};
  std::string no_more;
  if (const auto& upper = found.maximum.upper; upper && !found.struts) {
    shown = support::in_sentence(to->value, upper->value);
    standing = of_all({from, to, upper});
    no_more = shown.lower == shown.upper ? ", and no more"
                                         : fmt::format(", but no more than {} times", shown.upper);
  }
  return fmt::format("It carries {} times {}{}{}{}{}.", shown.lower, reference(found), cases,
                     no_more, unless_proved(standing), of_struts(found));
}

std::string proved_or(const Bracket& bracket) {
  const auto standing = of_all({bracket.lower, bracket.upper});
  return standing == Standing::proved ? ", proved" : unless_proved(standing);
}

std::string factors_headline(const LoadInterval& found) {
  if (!found.uncertain) return nominal(found);
  if (found.carried_at_none && found.uncertain->half_width == 0)
    return dead_load_is_not_carried(found);
  if (found.carried_at_none) {
    return fmt::format("There is {} that it does not carry at any load factor{}.",
                       found.reference_action.empty() ? "a dead load within its bounds"
                                                      : "a combination of actions",
                       unless_proved(*found.carried_at_none));
  }
  const auto loads = within(found);
  if (const auto standing = empty(found)) {
    return fmt::format("There is no load factor that it carries {}{}.", within(found, "all of"),
                       unless_proved(*standing));
  }
  const auto& to = found.maximum.lower;
  if (!to) return none_found(found, "that it carries " + loads);
  const auto& from = found.minimum.upper;
  if (!from) {
    return fmt::format("The largest factor of {} that it carries is at least {}{}{}, {}{}.",
                       reference(found), support::rounded_down(to->value), if_large(found),
                       unless_proved(to->standing), loads, of_struts(found) + upper_bound(found));
  }
  if (is_undecided(found)) {
    return fmt::format("It is {}undecided whether any load factor is carried {}.",
                       found.struts ? "" : "numerically ", within(found, "all of"));
  }
  const auto [low, high] = support::inside(from->value, to->value);
  return fmt::format("It carries every factor from {}{} to {}{}{} of {}, {}{}{}.", low,
                     unless_proved(from->standing), high, if_large(found),
                     unless_proved(to->standing), reference(found), loads, of_struts(found),
                     gap_above(found));
}

// True if every load factor from 0 to 1 is carried; nothing if that is not proved either way.
std::optional<bool> passed(const LoadInterval& found) {
  const auto proved = [&](const std::optional<Bound>& bound) {
    return is_proved(bound) && !found.if_big_m;
  };
  if (found.carried_at_none == Standing::proved || empty(found) == Standing::proved) return false;
  if (proved(found.minimum.lower) && found.minimum.lower->value > 0) return false;
  if (proved(found.maximum.upper) && found.maximum.upper->value < 1) return false;
  const bool whole = proved(found.minimum.upper) && proved(found.maximum.lower) &&
                     found.minimum.upper->value <= 0 && found.maximum.lower->value >= 1;
  return whole ? std::optional(true) : std::nullopt;
}

// Factors outside the known bounds of an interval that may be empty.
void add_outside(const LoadInterval& found, std::vector<Reservation>& all) {
  const auto& below = found.minimum.lower;
  const auto& above = found.maximum.upper;
  const auto add = [&](const Bound& bound, const std::string& range) {
    const auto text = not_carried(found, range) + unless_proved(bound.standing) + '.';
    all.push_back({capital(text), true});
  };
  if (below) add(*below, "below " + support::rounded_down(below->value));
  if (above) add(*above, "above " + support::rounded_up(above->value));
}

// The factors that are carried under every load of the last point, after its worst case.
std::string guaranteed(const LoadSteps& found) {
  const auto& from = found.minimum.upper;
  const auto& to = found.worst.lower;
  const auto& above = found.minimum.lower;
  if (above && above->value > found.worst.upper->value) {
    return fmt::format("; there is no load factor that is carried under all admissible loads{}",
                       unless_proved(of_all({above, found.worst.upper})));
  }
  if (!from) return "; the least factor that is carried under all admissible loads is open";
  if (from->value > to->value)
    return "; it is numerically undecided whether any factor is carried under all admissible loads";
  const auto [low, high] = support::inside(from->value, to->value);
  return fmt::format("; factors from {}{} to {} are carried under all admissible loads", low,
                     unless_proved(from->standing), high);
}

}  // namespace

std::string half_width_text(double half_width, const std::optional<std::string>& force) {
  return fmt::format("± {} {}", half_width, force.value_or("times its uncertain part"));
}

std::string headline_of(const LoadInterval& found, engine::Status ended) {
  const auto text = factors_headline(found);
  if (!found.uncertain || ended != engine::Status::solved) return text;
  const auto known = passed(found);
  if (found.carried_at_none || empty(found)) return text;
  if (!known)
    return text + (found.struts ? " Open: whether every factor from 0 to 1 is carried." : "");
  return text +
         (*known ? " Passed: these include 0 to 1."
                 : fmt::format(" Not passed: {} at some factor from 0 to 1.",
                               some_load(found).empty() ? "it does not carry its dead load"
                                                        : some_load(found) + " is not carried"));
}

void reserve(const LoadInterval& found, engine::Status ended, std::vector<Reservation>& all) {
  if (!found.uncertain && !found.carried_at_none) {
    if (!found.maximum.lower) {
      all.push_back({found.struts ? "No load factor at residual strength is known."
                                  : "It is open whether some load factor is carried.",
                     true});
    }
  }
  if (found.carried_at_none == Standing::computed)
    all.push_back({fmt::format("No proof was found that {} is carried at no factor.",
                               found.uncertain ? some_load(found) : "the dead load"),
                   true});
  if (found.uncertain && !found.carried_at_none && ended == engine::Status::solved) {
    if (!is_proved(found.maximum.lower))
      all.push_back({"A lower bound of the largest factor is not proved.", true});
    if (!is_proved(found.maximum.upper))
      all.push_back({"An upper bound of the largest factor is not proved.", true});
    if (!found.if_big_m && !is_proved(found.minimum.upper) && empty(found) != Standing::proved)
      all.push_back({"The least factor from which every load is carried is not proved.", true});
    if (is_undecided(found)) add_outside(found, all);
  }
  if (found.if_big_m)
    all.push_back({"The bounds of (29) hold only if its M is large enough.", false});
  if (found.incomplete) all.push_back({"Not every requested result is proved.", true});
}

std::string headline_of(const LoadSteps& found, engine::Status /*ended*/) {
  if (found.nominal_at_none) {
    return fmt::format("The nominal dead load is carried at no load factor, of either sign{}.",
                       unless_proved(*found.nominal_at_none));
  }
  if (!found.nominal) return "The nominal load factor was not found.";
  constexpr int digits = 8;
  const auto text = fmt::format("The nominal load factor is at least {}{}",
                                support::rounded_down(found.nominal->value, digits),
                                unless_proved(found.nominal->standing));
  if (!found.half_width) return text + '.';
  const auto at = fmt::format("; for alpha = {}{}", *found.half_width,
                              found.force ? ' ' + *found.force : std::string());
  if (found.worst_at_none) {
    return text + at +
           fmt::format(" some load is not carried at any factor{}.",
                       unless_proved(*found.worst_at_none));
  }
  const auto& [lower, upper] = found.worst;
  if (!lower && !upper) return text + at + " the worst case is not known.";
  if (!lower || !upper) {
    const auto& [value, standing] = lower ? *lower : *upper;
    return text + at +
           fmt::format(
               " the worst case is at {} {}{}.", lower ? "least" : "most",
               lower ? support::rounded_down(value, digits) : support::rounded_up(value, digits),
               unless_proved(standing));
  }
  const auto shown = support::in_sentence(lower->value, upper->value, digits);
  const auto worst = shown.lower == shown.upper
                         ? shown.lower
                         : fmt::format("between {} and {}", shown.lower, shown.upper);
  return text + at + fmt::format(" the worst case is {}{}", worst, proved_or(found.worst)) +
         guaranteed(found) + '.';
}

void reserve(const LoadSteps& found, engine::Status /*ended*/, std::vector<Reservation>& all) {
  if (found.points < found.points_asked) {
    all.push_back(
        {fmt::format("{} of {} points were computed.", found.points, found.points_asked), true});
  }
  if (!found.nominal && !found.nominal_at_none)
    all.push_back({"It is open whether the nominal load is carried at some factor.", true});
  if (found.open) all.push_back({"Some point, or part of the curve, is not proved.", true});
}

}  // namespace kusabi::answer
