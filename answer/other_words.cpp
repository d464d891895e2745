// Sentences about zero-one programs and certificates.
#include <limits>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "answer/answer_words.hpp"
#include "answer/values.hpp"
#include "support/input_error.hpp"
#include "support/rounded_bounds.hpp"

namespace kusabi::answer {
namespace {

std::string bound_text(const MixedOptimum& found) {
  return fmt::format(
      "{} bound {}", found.maximise ? "upper" : "lower",
      found.bound ? fmt::format("{} {}", found.bound->value, in_brackets(found.bound->standing))
                  : "not known");
}

// "alpha = 3"
std::string loads_claim(const LoadRange& loads) {
  return loads.half_width ? fmt::format("alpha = {}", *loads.half_width)
                          : "uncertain loads within these half-widths";
}

// " for displacements up to 1e+06 times the strains"; empty: for all.
std::string for_displacements(std::optional<double> ratio) {
  return ratio ? fmt::format(" for displacements up to {:.2g} times the strains", *ratio) : "";
}

std::string of_list(const CertificateCheck::List& list) {
  if (list.undecided > 0 && list.nodes == 0)
    return "NOTHING PROVED: all nodes are marginal, and the certificate claims nothing about them";
  const auto patterns = counted(list.patterns, "pattern");
  const auto except = for_displacements(list.displacement_ratio);
  if (list.undecided > 0) {
    return fmt::format("PROVED except for {}: the list of {} is complete{} except for these",
                       counted(list.undecided, "marginal node"), patterns,
                       except.empty() ? "" : except + ",");
  }
  return fmt::format("PROVED: the list of {} is complete{}{}", patterns,
                     list.patterns == 0 ? ": it cannot stick" : "", except);
}

}  // namespace

std::string proved(const std::string& claim) {
  return "PROVED: " + claim;
}

std::string no_certificate(const std::string& why) {
  return fmt::format("No certificate was written, since {}.", why);
}

std::string no_certificate_of(std::size_t without, const std::string& all, const std::string& why) {
  return fmt::format(
      "No certificate was written for {} of {}, since {}; an older file is unchanged.", without,
      all, why);
}

std::string factor_claim(const CertificateCheck::Factor& factor) {
  auto loads = loads_claim(factor.loads);
  if (factor.cases > 1) loads += fmt::format(" in these {} load cases", factor.cases);
  if (factor.at_none) {
    return fmt::format("for {} some admissible load is carried at no load factor", loads);
  }
  const auto& [lower, upper] = factor.largest;
  if (!upper) return fmt::format("for {} nothing is claimed", loads);
  const auto shown = support::in_table(factor.largest.at_least(), upper->value);
  auto text = fmt::format("the worst-case load factor for {} is ", loads) +
              (lower ? fmt::format("between {} and {}", shown.lower, shown.upper)
                     : fmt::format("at most {}",
                                   support::rounded_up(upper->value, support::digits_of_table)));
  if (factor.struts) {
    text += lower ? ", while no strut falls below its residual strength"
                  : ", an upper value: no lower bound at residual strength is proved";
  }
  const auto& [none_below, from] = factor.minimum;
  if (none_below && none_below->value > upper->value) {
    return text + fmt::format(
                      "; there is no load factor that is carried under every admissible load: the "
                      "least factor of one is {} or more",
                      support::rounded_down(none_below->value, support::digits_of_table));
  }
  if (!none_below || !from || !lower || from->value > lower->value) return text;
  const auto [low, high] = support::inside(from->value, lower->value, support::digits_of_table);
  return text + fmt::format(
                    "; every load factor from {} to {} is carried under every admissible "
                    "load, and some admissible load is carried at no factor below {}",
                    low, high, support::rounded_down(none_below->value, support::digits_of_table));
}

namespace {

std::string range_text(const Bracket& range) {
  const auto& [lower, upper] = range;
  if (!lower && !upper) return "all factors";
  constexpr int digits = support::digits_of_table;
  // All numbers of one sign.
  constexpr double least = std::numeric_limits<double>::denorm_min();
  if (!lower && upper->value == -least) return "below 0";
  if (!upper && lower->value == least) return "above 0";
  if (!lower) return fmt::format("up to {}", support::rounded_down(upper->value, digits));
  if (!upper) return fmt::format("from {} on", support::rounded_up(lower->value, digits));
  if (lower->value == upper->value) return fmt::format("{}", lower->value);
  const auto [low, high] = support::inside(lower->value, upper->value, digits);
  return fmt::format("from {} to {}", low, high);
}

std::string ranges_text(const std::vector<Bracket>& ranges) {
  std::string text;
  for (const auto& range : ranges) text += (text.empty() ? "" : ", ") + range_text(range);
  return text;
}

bool is_of_dead_load(const CertificateCheck::Held& held) {
  if (!held.of_reference) return true;
  if (held.held.size() + held.none.size() != 1) return false;
  const auto& only = held.held.empty() ? held.none.front() : held.held.front();
  return only == Bracket::proved(0, 0);
}

std::string grip_text(const CertificateCheck::Grip& grip) {
  constexpr int digits = support::digits_of_table;
  const auto& [lower, upper] = grip.sum;
  auto text =
      fmt::format("the normal reactions of every state under the dead load add up to {} or more",
                  support::rounded_down(lower ? lower->value : 0, digits));
  if (upper) text += fmt::format(" and {} or less", support::rounded_up(upper->value, digits));
  if (grip.states) {
    const auto [low, high] =
        support::inside(grip.states->at_least(), grip.states->at_most(), digits);
    text += fmt::format(", those of some states to {} and {}", low, high);
  }
  return text;
}

std::string of_held(const CertificateCheck::Held& held) {
  const bool grip = held.grip && held.grip->says_something();
  if (held.held.empty() && held.none.empty() && !grip)
    return "NOTHING PROVED: the certificate has neither a state nor a complete tree";
  auto text = held.friction
                  ? fmt::format("PROVED: at friction coefficient {}", *held.friction)
                  : std::string("PROVED: at the friction coefficients of the certificate");
  if (!held.load_case.empty())
    text += fmt::format(" in load case {}", support::in_quotes(held.load_case));
  if (held.total) text += fmt::format(" and with normal reactions that add up to {}", *held.total);
  std::string separator = ", ";
  const auto add = [&](const std::string& part) {
    text += separator + part;
    separator = "; ";
  };
  if (is_of_dead_load(held)) {
    if (!held.held.empty()) add("it can hold the dead load");
    if (!held.none.empty()) add("it cannot hold the dead load");
  } else {
    if (!held.held.empty())
      add(fmt::format("it can hold these factors of the reference load: {}",
                      ranges_text(held.held)));
    if (!held.none.empty()) add(fmt::format("it cannot hold: {}", ranges_text(held.none)));
  }
  if (grip) add(grip_text(*held.grip));
  if (held.displacement_ratio) text += "; all" + for_displacements(held.displacement_ratio);
  return text;
}

// "admissible load (alpha = 3)"
std::string admissible(const CertificateCheck::Loss& loss, const char* load) {
  return fmt::format("admissible {} ({})", load, loads_claim(loss.loads));
}

// " and under every admissible load (alpha = 3)"; empty: the dead load is certain
std::string loads_text(const CertificateCheck::Loss& loss, const char* quantity) {
  if (loss.uncertain) return fmt::format(" and under {} {}", quantity, admissible(loss, "load"));
  return loss.as_given ? " and under the dead load as given" : "";
}

}  // namespace

std::string loss_claim(const CertificateCheck::Loss& loss) {
  const auto lost = after_worst_loss(loss.lost, loss.sudden);
  const auto proved = loss.load_case.empty() ? std::string("PROVED: ")
                                             : fmt::format("PROVED: in load case {}, ",
                                                           support::in_quotes(loss.load_case));
  if (loss.fatal)
    return fmt::format("{}{} {} is carried at no load factor", proved, lost,
                       loss.uncertain  ? "some " + admissible(loss, "dead load")
                       : loss.as_given ? "the dead load as given"
                                       : "the dead load");
  const auto& [lower, upper] = loss.factor;
  if (!lower)
    return fmt::format("{}{}{} the load factor is at most {}", proved, lost,
                       loads_text(loss, "some"),
                       support::rounded_up(loss.factor.at_most(), support::digits_of_table));
  const auto shown = support::in_table(lower->value, loss.factor.at_most());
  const auto members =
      loss.maximum == 1 ? "any member" : fmt::format("any {} members", loss.maximum);
  return fmt::format(
      "{}{}{}{}{} the load factor is at least {}; {} it is at most {}", proved,
      after_loss_of(members + except_kept(loss.kept), loss.sudden), loads_text(loss, "every"),
      loss.cases == 1 ? std::string() : fmt::format(" in each of {} load cases", loss.cases),
      loss.struts ? ", while no strut falls below its residual strength," : "", shown.lower, lost,
      shown.upper);
}

std::string headline_of(const MixedOptimum& found, engine::Status /*ended*/) {
  switch (found.state) {
    case MixedOptimum::State::infeasible:
      return fmt::format("No point satisfies all rows, bounds and binaries {}.",
                         in_brackets(found.standing));
    case MixedOptimum::State::unbounded:
      return fmt::format("The objective has no {} bound {}.", found.maximise ? "upper" : "lower",
                         in_brackets(found.standing));
    case MixedOptimum::State::unknown:
      return fmt::format("No point was found, and it is not known whether one exists; {}.",
                         bound_text(found));
    case MixedOptimum::State::optimal:
    case MixedOptimum::State::feasible:
      break;
  }
  const auto text = fmt::format(
      "{} {} {}; {}",
      found.state == MixedOptimum::State::optimal ? "The optimum is"
                                                  : "The best point so far has the objective",
      found.objective.value_or(0), in_brackets(found.standing), bound_text(found));
  return found.gap ? fmt::format("{}, gap {:.2g} %.", text, 100 * *found.gap) : text + ".";
}

void reserve(const MixedOptimum& found, engine::Status ended, std::vector<Reservation>& all) {
  using State = MixedOptimum::State;
  const bool answered = found.state != State::feasible && found.state != State::unknown;
  const bool one = found.unproved == 1;
  const char* const point = found.objective ? "better point" : "point";
  const auto nodes =
      fmt::format("{} {} closed without a proof that {} no {}", counted(found.unproved, "node"),
                  one ? "was" : "were", one ? "it contains" : "they contain", point);
  if (ended == engine::Status::solved && !answered) {
    all.push_back(
        {found.unproved == 0
             ? "Not answered: the search is done, but the bounds of some nodes are too weak."
             : fmt::format("Not answered: the search is done, but {}.", nodes),
         true});
  } else if (found.unproved != 0) {
    all.push_back({fmt::format("{}; the computed bounds exclude a {}.", nodes, point), false});
  }
  const bool has_bound = found.state != State::infeasible && found.state != State::unbounded;
  if (has_bound && found.bound && found.bound->standing == Standing::computed) {
    all.push_back(
        {"The bound is computed in floating point, not proved in rational numbers, which are used "
         "for small programs without cuts only. Where columns have no bounds, or very large ones, "
         "a "
         "rounding error may change it by any amount.",
         false});
  }
  if (found.objective && found.standing == Standing::computed) {
    all.push_back(
        {"It is not proved in rational numbers that the point satisfies all rows, or that it is "
         "optimal.",
         false});
  }
}

std::string headline_of(const CertificateCheck& found, engine::Status ended) {
  if (found.refusals > 0) return "NOT PROVED";
  if (ended != engine::Status::solved) return "NOTHING PROVED";
  if (const auto* const list = std::get_if<CertificateCheck::List>(&found.claim))
    return of_list(*list);
  if (const auto* const example = std::get_if<CertificateCheck::Example>(&found.claim)) {
    return fmt::format("PROVED: it can stick, by {}; other patterns are not decided",
                       counted(example->patterns, "pattern"));
  }
  if (const auto* const factor = std::get_if<CertificateCheck::Factor>(&found.claim))
    return proved(factor_claim(*factor));
  if (const auto* const held = std::get_if<CertificateCheck::Held>(&found.claim))
    return of_held(*held);
  if (const auto* const loss = std::get_if<CertificateCheck::Loss>(&found.claim))
    return loss_claim(*loss);
  return "NOT PROVED";
}

void reserve(const CertificateCheck& found, engine::Status /*ended*/,
             std::vector<Reservation>& all) {
  if (const auto* const held = std::get_if<CertificateCheck::Held>(&found.claim)) {
    const bool grip = held->grip && held->grip->says_something();
    if (found.refusals == 0 && held->held.empty() && held->none.empty() && !grip)
      all.push_back({"The certificate claims nothing about any load.", true});
  }
  const auto* const list = std::get_if<CertificateCheck::List>(&found.claim);
  if (list == nullptr || list->undecided == 0) return;
  all.push_back({fmt::format("The certificate claims nothing about {}.",
                             counted(list->undecided, "marginal node")),
                 true});
}

}  // namespace kusabi::answer
