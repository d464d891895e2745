// Sentences about zero-one programs and certificates.
#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "answer/answer_words.hpp"
#include "answer/values.hpp"
#include "support/input_error.hpp"

namespace kusabi::answer {
namespace {

const char* in_brackets(Standing standing) {
  return standing == Standing::proved ? "(proved)" : "(computed, not proved)";
}

std::string bound_text(const MixedOptimum& found) {
  return fmt::format(
      "{} bound {}", found.maximise ? "upper" : "lower",
      found.bound ? fmt::format("{} {}", found.bound->value, in_brackets(found.bound->standing))
                  : "not known");
}

std::string of_list(const CertificateCheck::List& list) {
  if (list.undecided > 0 && list.nodes == 0)
    return "NOTHING PROVED: all nodes are marginal, and the certificate claims nothing about them";
  const auto patterns = counted(list.patterns, "pattern");
  const auto except = list.except_large_displacements == 0
                          ? std::string{}
                          : fmt::format(" for displacements up to {:.2g} times the strains",
                                        list.displacement_ratio);
  if (list.undecided > 0) {
    return fmt::format("PROVED except for {}: the list of {} is complete{} except for these",
                       counted(list.undecided, "marginal node"), patterns,
                       except.empty() ? "" : except + ",");
  }
  return fmt::format("PROVED: the list of {} is complete{}{}", patterns,
                     list.patterns == 0 ? ": it cannot stick" : "", except);
}

}  // namespace

std::string factor_claim(const CertificateCheck::Factor& factor) {
  auto loads = factor.loads.half_width ? fmt::format("alpha = {}", *factor.loads.half_width)
                                       : std::string("uncertain loads within these half-widths");
  if (factor.cases > 1) loads += fmt::format(" in these {} load cases", factor.cases);
  if (factor.at_none) {
    return fmt::format("for {} some admissible load is carried at no load factor", loads);
  }
  auto text = std::isfinite(factor.lower)
                  ? fmt::format("the worst-case load factor for {} is between {:.17g} and {:.17g}",
                                loads, factor.lower, factor.upper)
                  : fmt::format("the worst-case load factor for {} is at most {:.17g}", loads,
                                factor.upper);
  if (factor.struts) {
    text += std::isfinite(factor.lower)
                ? ", while no strut falls below its residual strength"
                : ", an upper value: no lower bound at residual strength is proved";
  }
  if (!factor.minimum) return text;
  const auto& [lower, upper] = *factor.minimum;
  if (lower > factor.upper) {
    return text + fmt::format(
                      "; no load factor is carried under every admissible load: the least "
                      "factor of one is {:.17g} or more",
                      lower);
  }
  if (upper > factor.lower) return text;
  return text + fmt::format(
                    "; every load factor from {:.17g} to {:.17g} is carried under every admissible "
                    "load; no factor below {:.17g} is carried",
                    upper, factor.lower, lower);
}

namespace {

std::string range_text(const CertificateCheck::Range& range) {
  if (std::isinf(range.low) && std::isinf(range.high)) return "all factors";
  if (std::isinf(range.low)) return fmt::format("up to {:.17g}", range.high);
  if (std::isinf(range.high)) return fmt::format("from {:.17g} on", range.low);
  if (range.low == range.high) return fmt::format("{:.17g}", range.low);
  return fmt::format("from {:.17g} to {:.17g}", range.low, range.high);
}

std::string ranges_text(const std::vector<CertificateCheck::Range>& ranges) {
  std::string text;
  for (const auto& range : ranges) text += (text.empty() ? "" : ", ") + range_text(range);
  return text;
}

bool is_of_dead_load(const CertificateCheck::Held& held) {
  if (!held.of_reference) return true;
  if (held.held.size() + held.none.size() != 1) return false;
  const auto& only = held.held.empty() ? held.none.front() : held.held.front();
  return only.low == 0 && only.high == 0;
}

std::string grip_text(const CertificateCheck::GripBounds& grip) {
  auto text = fmt::format(
      "the normal reactions of every state under the dead load add up to {:.17g} or more",
      grip.below);
  if (grip.above) text += fmt::format(" and {:.17g} or less", *grip.above);
  if (grip.states) {
    text += fmt::format(", those of some states to {:.17g} and {:.17g}", grip.states->low,
                        grip.states->high);
  }
  return text;
}

std::string of_held(const CertificateCheck::Held& held) {
  const bool grip = held.grip && held.grip->says_something();
  if (held.held.empty() && held.none.empty() && !grip)
    return "NOTHING PROVED: the certificate has neither a state nor a complete tree";
  auto text = fmt::format("PROVED: at friction coefficient {}", held.friction);
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
  if (held.except_large_displacements) {
    text += fmt::format("; all for displacements up to {:.2g} times the strains",
                        held.displacement_ratio);
  }
  return text;
}

// "admissible load (alpha = 3)"
std::string admissible(const CertificateCheck::Loss& loss, const char* load) {
  return fmt::format("admissible {} ({})", load,
                     loss.loads.half_width ? fmt::format("alpha = {}", *loss.loads.half_width)
                                           : "uncertain loads within these half-widths");
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
  if (!loss.lower)
    return fmt::format("{}{}{} the load factor is at most {:.17g}", proved, lost,
                       loads_text(loss, "some"), loss.upper);
  const auto members =
      loss.maximum == 1 ? "any member" : fmt::format("any {} members", loss.maximum);
  return fmt::format(
      "{}{}{}{}{} the load factor is at least {:.17g}; {} it is at most {:.17g}", proved,
      after_loss_of(members + except_kept(loss.kept), loss.sudden), loads_text(loss, "every"),
      loss.cases == 1 ? std::string() : fmt::format(" in each of {} load cases", loss.cases),
      loss.struts ? ", while no strut falls below its residual strength," : "", *loss.lower, lost,
      loss.upper);
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
  return found.bound ? fmt::format("{}, gap {:.2g} %.", text, 100 * found.gap) : text + ".";
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
        {"The bound is not proved in rational numbers, as of a large program or with cuts, and any "
         "rounding error counts without limit where columns have no bounds, or almost so.",
         false});
  }
  if (found.objective && found.standing == Standing::computed) {
    all.push_back(
        {"The point is not proved to satisfy its rows, or not to be optimal, in rational numbers.",
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
    return "PROVED: " + factor_claim(*factor);
  if (const auto* const held = std::get_if<CertificateCheck::Held>(&found.claim))
    return of_held(*held);
  if (const auto* const loss = std::get_if<CertificateCheck::Loss>(&found.claim))
    return loss_claim(*loss);
  return "NOT PROVED";
}

void reserve(const CertificateCheck& found, std::vector<Reservation>& all) {
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
