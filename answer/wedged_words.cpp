// Sentences about friction: lists at one coefficient, the critical coefficient, steps over it.
#include <algorithm>

#include <fmt/format.h>

#include "answer/answer_words.hpp"
#include "answer/values.hpp"
#include "support/rounded_bounds.hpp"

namespace kusabi::answer {
namespace {

constexpr int digits_of_sweep = 10;
constexpr const char* coefficient = "friction coefficient";
constexpr const char* proved_by_bounds =
    "Proved by the bounds of the solver, which allow for rounding";

bool is_refuted(const std::optional<ExactRemainder>& remainder) {
  return remainder && !remainder->why.empty();
}

void reserve_large_displacements(std::optional<double> ratio, std::vector<Reservation>& all) {
  if (!ratio) return;
  all.push_back(
      {fmt::format("The proofs are for displacements up to {:.2g} times the strains only.", *ratio),
       false});
}

void reserve(const ExactRemainder& remainder, std::vector<Reservation>& all) {
  if (!remainder.why.empty()) {
    all.push_back(
        {fmt::format(
             "The stiffnesses or lengths of the structure differ by a factor of {:.1e}: floating "
             "point may miss a pattern or add one. The exact test does not decide this: {}.",
             remainder.scale_ratio, remainder.why),
         true});
  } else {
    all.push_back({fmt::format("The exact test leaves {} with a margin of zero undecided.",
                               counted(remainder.nodes, "node")),
                   true});
  }
}

bool is_complete(const Sticking& found, engine::Status ended) {
  return ended == engine::Status::solved && found.undecided == 0 && !found.ambiguous &&
         !found.remainder;
}

}  // namespace

bool is_known_to_stick(const Sticking& found) {
  return found.count != 0U && !is_refuted(found.remainder);
}

std::string next_step(bool of_patterns) {
  return fmt::format(
      "To prevent sticking, lower the friction below the critical coefficient, which kusabi "
      "critical "
      "finds{}.",
      of_patterns ? "; --sort critical adds to the list that of each pattern" : "");
}

namespace {

// What exact arithmetic proves of a list of rays.
std::string cones_text(const Sticking& found) {
  if (!found.proved_cones) return {};
  return found.proved_cones == 1U
             ? std::string(" in one maximal cone; exact arithmetic proves that there is no other")
             : fmt::format(
                   " in {} maximal cones; exact arithmetic proves these cones, and that there is "
                   "no other",
                   *found.proved_cones);
}

}  // namespace

std::string cones_line(std::uint64_t cones) {
  if (cones == 0) return "proved: there is no maximal cone, so that there is no ray\n";
  return fmt::format(
      "proved: the candidates in contact and separated of {}, and that there is no "
      "other cone; the numbers of the rays are computed, not proved\n",
      cones == 1 ? "this cone" : "these cones");
}

std::string headline_of(const Sticking& found, engine::Status ended) {
  const auto where = friction_words(found.friction, found.factor);
  const bool complete = is_complete(found, ended);
  if (is_known_to_stick(found)) {
    if (found.example) return fmt::format("Yes, it can stick at {}.", where);
    const auto count = counted(found.count, found.thing);
    const bool one = found.count == 1U;
    if (!complete)
      return fmt::format("It can stick at {}: {} {} known.", where, count, one ? "is" : "are");
    if (found.thing != "way")
      return fmt::format("It can stick at {}, with {}{}.", where, count, cones_text(found));
    return one ? fmt::format("Yes, it can stick at {}, in one way.", where)
               : fmt::format("It can stick in {} at {}.", count, where);
  }
  if (complete) return fmt::format("It cannot stick at {}.", where);
  return fmt::format("It is not known whether it can stick at {}.", where);
}

void reserve(const Sticking& found, engine::Status ended, std::vector<Reservation>& all) {
  if (found.undecided > 0) {
    const bool one = found.undecided == 1;
    all.push_back(
        {fmt::format("It is undecided whether {} {} a wedged configuration; {} not counted.",
                     counted(found.undecided, "sign pattern"), one ? "has" : "have",
                     one ? "it is" : "they are"),
         true});
  }
  if (found.ambiguous) {
    all.push_back({fmt::format("Some numbers cannot be distinguished from zero: {} may be wrong.",
                               found.proved_cones ? "the list of rays" : "the lists"),
                   true});
  }
  if (found.remainder) reserve(*found.remainder, all);
  if (found.standing == Standing::computed && found.proved_cones) {
    all.push_back({"The rays themselves are computed in floating point, not proved.", false});
  } else if (found.standing == Standing::computed) {
    all.push_back(
        {fmt::format("{} is computed in floating point, not proved in exact arithmetic{}.",
                     found.count == 0U || found.example ? "This" : "The list",
                     found.degenerate == 0
                         ? ""
                         : fmt::format(": of {}, with a margin of zero, nothing is "
                                       "proved",
                                       counted(found.degenerate, "degenerate node"))),
         false});
  } else if (found.grounds == Grounds::solver_bounds && is_complete(found, ended)) {
    all.push_back({fmt::format("{}; --prove adds exact arithmetic.", proved_by_bounds), false});
  }
  if (found.standing == Standing::proved || found.proved_cones)
    reserve_large_displacements(found.displacement_ratio, all);
}

std::string friction_sentence(const std::string& ability, const Bracket& bracket, bool factor,
                              double maximum, bool wide) {
  const auto& [lower, upper] = bracket;
  const auto at = [&](const std::string& value) { return friction_words(value, factor); };
  if (lower && lower->value == 0) {
    const auto without =
        fmt::format("It cannot {} without friction{}", ability, unless_proved(lower->standing));
    if (!upper) return without + "; with friction, this is not known.";
    return fmt::format("{}; at {} it can{}{}.", without, at(support::rounded_up(upper->value)),
                       unless_proved(upper->standing),
                       wide ? "; in between, this is not known" : "");
  }
  if (!upper) {
    return fmt::format("It cannot {} up to {}{}{}.", ability,
                       at(support::rounded_down(lower->value)), unless_proved(lower->standing),
                       lower->value < maximum ? "; above it, this is not known" : "");
  }
  if (!lower) {
    return fmt::format("It can {} at {}{}; below it, this is not known.", ability,
                       at(support::rounded_up(upper->value)), unless_proved(upper->standing));
  }
  const auto shown = support::in_sentence(lower->value, upper->value);
  return fmt::format("It cannot {} below {}{}; at {} it can{}{}.", ability, at(shown.lower),
                     unless_proved(lower->standing), short_friction_words(shown.upper, factor),
                     unless_proved(upper->standing), wide ? "; in between, this is not known" : "");
}

void reserve_undecided(const std::string& ability, const Bracket& bracket, double maximum,
                       std::vector<Reservation>& all) {
  const double lower = bracket.lower ? bracket.lower->value : 0;
  if (bracket.upper || lower >= maximum) return;
  all.push_back(
      {fmt::format("It is undecided whether it can {} at {}s between {} and {:.12g}.", ability,
                   coefficient, support::rounded_down(lower, support::digits_of_table), maximum),
       true});
}

std::string headline_of(const CriticalBracket& found, engine::Status ended) {
  if (!found.bracket.lower && !found.bracket.upper)
    return fmt::format("The {} from which it can stick is not known.", coefficient);
  return friction_sentence("stick", found.bracket, found.factor, found.maximum,
                           found.wide || ended != engine::Status::solved);
}

void reserve(const CriticalBracket& found, engine::Status ended, std::vector<Reservation>& all) {
  const auto& [lower, upper] = found.bracket;
  const bool solved = ended == engine::Status::solved;
  reserve_undecided("stick", found.bracket, found.maximum, all);
  if (found.wide && upper) {
    all.push_back({fmt::format("The bracket is {:.2g} wide, wider than requested ({:g}).",
                               upper->value - (lower ? lower->value : 0), found.width),
                   true});
  }
  if (lower && !is_proved(lower)) {
    all.push_back({fmt::format("Computed, not proved in exact arithmetic: it cannot stick at {}.",
                               support::rounded_down(lower->value, support::digits_of_table)),
                   true});
  }
  if (upper && !is_proved(upper)) {
    const auto claim = fmt::format("Computed, not proved in exact arithmetic: it can stick at {}",
                                   support::rounded_up(upper->value, support::digits_of_table));
    all.push_back({solved ? claim + "; some inequality may hold only as an equality, or within the "
                                    "rounding of the file's numbers."
                          : claim + '.',
                   !solved});
  }
  if (found.grounds == Grounds::solver_bounds && (is_proved(lower) || is_proved(upper))) {
    all.push_back({fmt::format("{}; kusabi verify proves a --certificate in exact arithmetic.",
                               proved_by_bounds),
                   false});
  }
  if (is_proved(lower) || is_proved(upper))
    reserve_large_displacements(found.displacement_ratio, all);
  if (found.patterns_open) {
    all.push_back({fmt::format("The patterns that stick at {} were not determined.",
                               support::rounded_up(upper ? upper->value : found.maximum,
                                                   support::digits_of_table)),
                   true});
  }
}

namespace {

std::string line_of(const std::string& name, const Bracket& bracket) {
  const auto& [lower, upper] = bracket;
  const auto standing = [](const Bound& bound) { return in_brackets(bound.standing); };
  if (upper && upper->value == 0) return fmt::format("{}: 0 {}\n", name, standing(*upper));
  if (lower && upper) {
    const auto shown = support::in_table(lower->value, upper->value);
    if (lower->standing == upper->standing) {
      return fmt::format("{}: between {} and {} {}\n", name, shown.lower, shown.upper,
                         standing(*lower));
    }
    return fmt::format("{}: between {} {} and {} {}\n", name, shown.lower, standing(*lower),
                       shown.upper, standing(*upper));
  }
  if (lower) {
    return fmt::format("{}: above {} {}\n", name,
                       support::rounded_down(lower->value, support::digits_of_table),
                       standing(*lower));
  }
  if (upper) {
    return fmt::format("{}: at most {} {}\n", name,
                       support::rounded_up(upper->value, support::digits_of_table),
                       standing(*upper));
  }
  return fmt::format("{}: open\n", name);
}

}  // namespace

std::string bracket_line(const CriticalBracket& found) {
  return line_of(fmt::format("critical {}", friction_name(found.factor)), found.bracket);
}

std::string bracket_line(const HoldingBracket& found) {
  return line_of(fmt::format("holding {}", friction_name(found.factor)), found.bracket);
}

namespace {

// What the exact test of a sweep has proved: the same list of patterns at each of its coefficients.
const char* counts_text(const FrictionSteps& found) {
  if (!is_proved(found.infeasible) || found.open_at_most > 0) return "";
  return " Exact arithmetic proves this, and the counts at the given coefficients and at both "
         "bounds of each step.";
}

}  // namespace

std::string headline_of(const FrictionSteps& found, engine::Status /*ended*/) {
  const auto maximum = fmt::format("{}", found.maximum);
  if (!found.infeasible || is_refuted(found.remainder))
    return fmt::format("The {} from which it can stick is not known.", coefficient);
  const auto& [value, standing] = *found.infeasible;
  if (found.count == 0U && found.open_at_most == 0 && value >= found.maximum) {
    return fmt::format("It cannot stick up to {}{}.{}", friction_words(maximum, found.factor),
                       unless_proved(standing), counts_text(found));
  }
  // Without friction nothing sticks.
  const auto head =
      value == 0 ? fmt::format("The {} from which it can stick is not known", coefficient)
                 : "It cannot stick up to " +
                       friction_words(support::rounded_down(value, digits_of_sweep), found.factor);
  return fmt::format(
      "{}; at {} there {} {}{}{}.{}", head, short_friction_words(maximum, found.factor),
      found.count == 1U ? "is" : "are", counted(found.count, "sign pattern"),
      found.open_at_most == 0 ? "" : fmt::format(" and {} undecided", found.open_at_most),
      unless_proved(standing), counts_text(found));
}

void reserve(const FrictionSteps& found, engine::Status /*ended*/, std::vector<Reservation>& all) {
  if (found.remainder) reserve(*found.remainder, all);
  if (is_proved(found.infeasible)) reserve_large_displacements(found.displacement_ratio, all);
  if (!found.infeasible) {
    all.push_back(
        {fmt::format("The patterns at {} were not all found, so no count is known.", found.maximum),
         true});
  }
  if (found.open_patterns > 0) {
    all.push_back({fmt::format("The {} from which {} {} is undecided.", coefficient,
                               counted(found.open_patterns, "pattern"),
                               found.open_patterns == 1 ? "sticks" : "stick"),
                   true});
  }
  if (found.open_at_most > 0 && found.open_patterns == 0 && found.undecided_points == 0) {
    all.push_back(
        {fmt::format("The count at {} is undecided. A smaller --width, or another --mu-max, "
                     "may decide it.",
                     found.maximum),
         true});
  }
  if (found.undecided_points > 0) {
    all.push_back(
        {fmt::format("The count is undecided at {} of the requested points: these are within a "
                     "bracket in which a pattern first sticks, or above an undecided "
                     "pattern. A smaller --width, or another point, decides the former.",
                     found.undecided_points),
         true});
  }
}

}  // namespace kusabi::answer
