// Answers of `kusabi hold` with what is proved of each.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <tuple>
#include <utility>

#include <fmt/format.h>

#include "answer/answer_words.hpp"
#include "answer/values.hpp"
#include "problems/wedged/problem_block.hpp"
#include "problems/wedged/wedged_problem.hpp"
#include "run/hold/hold.hpp"
#include "run/wedged/contact_words.hpp"
#include "run/wedged/problem_summary.hpp"
#include "support/input_error.hpp"

namespace kusabi::run {
namespace {

// The end at `held`, with a factor beyond it that is not held; nothing for an end at infinity.
support::Bracket end_of(double held, const support::Bound& out, support::Standing standing,
                        bool upward) {
  if (std::isinf(held)) return {};
  const support::Bound end{held, standing};
  const auto outside = std::isfinite(out.value) ? std::optional(out) : std::nullopt;
  return upward ? support::Bracket{end, outside} : support::Bracket{outside, end};
}

// A state at the upper bound, where there may be others; in a closed bracket also its slipping
// candidates. Empty if it needs no friction.
std::string one_state(const wedged::LoadedProblem& loaded, const wedged::HoldingFriction& found) {
  if (!found.bracket.upper || !found.pattern || !found.state) return {};
  const auto& problem = loaded.problem;
  const auto contact =
      problems::in_whole(found.pattern->contact, problems::blocks_of(problem)[found.block]);
  const auto need = friction_need(problem, found.block, contact, found.state->reaction);
  if (need.slips.empty()) return {};
  auto text = "One state has " + contact_words(problem, found.block, contact);
  if (found.status == engine::Status::solved && found.bracket.lower)
    text += "; with less friction " + slip_words(problem, found.block, contact, need);
  return text + '.' + angle_sentence(problem, found.bracket.at_most());
}

answer::HoldingDiagram diagram_of(const HoldOptions& options, const wedged::LoadedProblem& loaded,
                                  const wedged::Diagram& found) {
  const auto count = [&](auto is) {
    return static_cast<std::uint64_t>(std::ranges::count_if(found.pieces, is));
  };
  answer::HoldingDiagram answer{
      .friction = options.points.front(),
      .factor = !problems::uniform_friction(loaded.problem),
      .cases = options.cases,
      .pieces = found.pieces.size(),
      .everything = count([](const auto& piece) { return piece.is_whole_plane; }) > 0,
      .open = found.unresolved || found.status != engine::Status::solved,
      .coarse = count([](const auto& piece) { return !piece.fine; })};
  if (!answer.open && !answer.everything) answer.outside = found.outside;
  return answer;
}

answer::HoldingGrip grip_of(const wedged::GripRange& found) {
  answer::HoldingGrip grip{.held = found.held,
                           .standing = found.standing,
                           .unbounded = found.maximum.unbounded,
                           .unbounded_standing = found.maximum.held.standing};
  if (!found.held) return grip;
  const auto& [minimum, maximum] = std::tie(found.minimum, found.maximum);
  grip.minimum.lower = minimum.out;
  if (minimum.known) grip.minimum.upper = minimum.held;
  if (!maximum.unbounded && maximum.known) grip.maximum = {maximum.held, maximum.out};
  return grip;
}

// "the body turns clockwise about (0, 3)", "the body of node "a" moves along x, the body of node "b"
// moves against x, and 3 more move".
std::string bodies_words(const problems::BodyMotion& motion) {
  if (motion.only_body) return "the body " + motion.bodies.front().words;
  constexpr std::size_t most = 3;
  std::vector<std::string> parts;
  for (const auto& body : motion.bodies) {
    if (parts.size() == most) break;
    parts.push_back(
        fmt::format("the body of node {} {}", support::in_quotes(body.node), body.words));
  }
  const auto more = motion.bodies.size() - parts.size();
  if (more > 0) parts.push_back(fmt::format("{} more {}", more, more == 1 ? "moves" : "move"));
  std::string text;
  for (std::size_t k = 0; k < parts.size(); ++k)
    text += (k == 0 ? "" : k + 1 == parts.size() ? " and " : ", ") + parts[k];
  return text;
}

// "friction is used up at a, b; contact is lost at c"; empty without candidates.
// @param slides, opens words before the names of sliding and of opening candidates
std::string contacts_words(const wedged::LoadedProblem& loaded, const std::string& slides,
                           const support::IndexSet& sliding, const std::string& opens,
                           const support::IndexSet& opening) {
  constexpr int most = 6;
  const auto names = [&](const support::IndexSet& set) {
    return set.size() > most
               ? answer::counted(set.size(), "candidate")
               : fmt::format("{}", fmt::join(candidate_names(loaded.problem, set), ", "));
  };
  std::vector<std::string> parts;
  if (!sliding.empty()) parts.push_back(slides + names(sliding));
  if (!opening.empty()) parts.push_back(opens + names(opening));
  return fmt::format("{}", fmt::join(parts, "; "));
}

// Why a load beyond the answer cannot be held.
std::string exclusion_words(const wedged::LoadedProblem& loaded, const HoldFindings& findings,
                            const wedged::ExcludingMotion& motion) {
  using Side = wedged::ExcludedLoad::Side;
  const auto beyond = [&]() -> std::string {
    if (findings.friction) return findings.friction->bracket.upper ? " with less friction" : "";
    if (motion.load.side == Side::alone) return loaded.has_reference ? " the dead load alone" : "";
    return motion.load.side == Side::more ? " a larger factor" : " a smaller factor";
  };
  // If contact is lost everywhere, far from the end of a range, the motion is one of many.
  const auto contacts = motion.opens_all
                            ? ""
                            : contacts_words(loaded, "contact slides at ", motion.sliding,
                                             "contact opens at ", motion.opening);
  return fmt::format(
      "Why not{}? Statics alone excludes it: if {}, the load does positive work, and reactions "
      "within their friction cones can only add to it.{}",
      beyond(), bodies_words(motion.bodies),
      contacts.empty() ? "" : fmt::format(" {}.", answer::capital(contacts)));
}

// "At the largest factor friction is used up at a, b; contact is lost at c." Nothing if neither is so,
// if a motion says why the factor is the largest, or if the state is not at an end.
std::string end_words(const HoldOptions& options, const wedged::LoadedProblem& loaded,
                      const HoldFindings& findings) {
  constexpr double near = 1e-6;  // of an inequality to its limit: the state is 10^-9 from the end
  using Side = wedged::ExcludedLoad::Side;
  if (findings.points.size() != 1 || options.points.size() != 1 || !findings.of_reference ||
      findings.status() != engine::Status::solved)
    return {};
  const auto& found = findings.points.front().factors;
  if (found.intervals.size() != 1 || found.unresolved) return {};
  const auto& held = found.intervals.front();
  if (!held.state || !held.pattern) return {};
  const bool high = held.state->factor == held.high;
  if (!std::isfinite(held.state->factor) || (!high && held.state->factor != held.low)) return {};
  const double out = (high ? held.high_out : held.low_out).value;
  if (!(std::abs(out - held.state->factor) <= near * std::abs(out))) return {};
  const auto side = high ? Side::more : Side::less;
  if (std::ranges::any_of(findings.exclusions,
                          [&](const auto& motion) { return motion.load.side == side; }))
    return {};
  const auto& problem = loaded.problem;
  const auto d = static_cast<std::size_t>(problem.dimension);
  const auto block = problems::blocks_of(problem)[held.block];
  const auto reaction_of = [&](int i) {
    return std::span(held.state->reaction).subspan(d * static_cast<std::size_t>(i), d);
  };
  double largest = 0;
  for (const int i : held.pattern->contact) largest = std::max(largest, reaction_of(i).front());
  support::IndexSet sliding, opening;  // of the block
  auto whole = block.begin();
  for (int i = 0; i < block.size(); ++i, ++whole) {
    if (!held.pattern->contact.contains(i)) continue;
    const auto r = reaction_of(i);
    const double mu = options.points.front() * problem.friction[static_cast<std::size_t>(*whole)];
    if (r.front() <= near * largest)
      opening.insert(i);
    else if (mu > 0 && std::hypot(r[1], d == 3 ? r[2] : 0) >= (1 - near) * mu * r.front())
      sliding.insert(i);
  }
  const auto text =
      contacts_words(loaded, "friction is used up at ", problems::in_whole(sliding, block),
                     "contact is lost at ", problems::in_whole(opening, block));
  if (text.empty()) return {};
  return fmt::format("At the {} factor {}.", high ? "largest" : "smallest", text);
}

// Load cases that decide the answer. Nothing if none is known to.
std::string decisive_words(const HoldFindings& findings) {
  const auto& [smallest, largest, none] = findings.decisive;
  const auto named = [](const std::string& name) { return support::in_quotes(name); };
  if (findings.friction)
    return largest.empty() ? "" : fmt::format("Load case {} needs most friction.", named(largest));
  if (!largest.empty() && smallest == largest)
    return fmt::format("Load case {} bounds the factors on both sides.", named(largest));
  std::vector<std::string> parts;
  if (!smallest.empty())
    parts.push_back("the smallest factor is that of load case " + named(smallest));
  if (!largest.empty())
    parts.push_back("the largest factor is that of load case " + named(largest));
  return parts.empty() ? "" : answer::capital(fmt::format("{}.", fmt::join(parts, ", ")));
}

// A sentence for each certificate that was not written. The least coefficient, zero, has none
// below.
std::vector<std::string> missing_certificates(const HoldFindings& findings) {
  if (!findings.enclosed) return {answer::no_certificate(answer::stiffness_is_not_enclosed)};
  const bool ended = findings.status() != engine::Status::solved;
  if (findings.friction && !ended) {
    std::vector<std::string> sentences;
    const auto& found = *findings.friction;
    if (found.bracket.at_most() > 0 && !is_proved(found.bracket.lower))
      sentences.emplace_back(answer::no_proved_lower_bound);
    if (found.bracket.upper && !is_proved(found.bracket.upper))
      sentences.emplace_back(answer::no_proved_upper_bound);
    return sentences;
  }
  if (!findings.friction && findings.certified) return {};
  return {answer::no_certificate(ended ? "the search ended early" : answer::nothing_is_proved)};
}

}  // namespace

answer::HoldingBracket bracket_of(const wedged::LoadedProblem& loaded,
                                  const HoldFindings& findings) {
  const auto& found = *findings.friction;
  answer::HoldingBracket answer{.bracket = found.bracket,
                                .factor = !problems::uniform_friction(loaded.problem),
                                .maximum = found.maximum};
  answer.load_case = findings.load_case;
  if (found.any_by_supports) answer.reason = answer::HoldReason::supports;
  if (found.not_in_equilibrium) answer.reason = answer::HoldReason::unbalanced;
  for (const auto& each : findings.cases) {
    const auto own = bracket_of(loaded, each);
    answer.cases.push_back({each.load_case, own.bracket, own.reason});
  }
  return answer;
}

answer::HoldingFactors factors_of(const HoldOptions& options, const wedged::LoadedProblem& loaded,
                                  const HoldFindings& findings, std::size_t index) {
  const HeldPoint& point = findings.points.at(index);
  const auto& found = point.factors;
  answer::HoldingFactors answer{.friction = point.mu,
                                .factor = !problems::uniform_friction(loaded.problem),
                                .of_reference = findings.of_reference,
                                .intervals = {},
                                .open = found.unresolved || found.status != engine::Status::solved};
  answer.load_case = point.load_case;
  answer.total = options.parameters.total;
  if (found.any_by_supports) answer.reason = answer::HoldReason::supports;
  if (found.any_by_wedging) answer.reason = answer::HoldReason::wedging;
  if (found.not_in_equilibrium) answer.reason = answer::HoldReason::unbalanced;
  for (const auto& each : found.intervals) {
    answer.intervals.push_back(answer::HoldingFactors::Interval::from(
        each.standing, end_of(each.low, each.low_out, each.standing, false),
        end_of(each.high, each.high_out, each.standing, true)));
  }
  if (!answer.open && !answer.holds_all()) answer.outside = found.outside;
  if (point.grip && point.grip->status == engine::Status::solved)
    answer.grip = grip_of(*point.grip);
  for (const auto& each : findings.cases) {
    if (index >= each.points.size()) {
      answer.cases.push_back({.name = each.load_case, .open = true});
      continue;
    }
    auto own = factors_of(options, loaded, each, index);
    answer.cases.push_back(
        {each.load_case, std::move(own.intervals), own.outside, own.open, own.reason});
  }
  return answer;
}

answer::Verdict hold_verdict(const HoldOptions& options, const wedged::LoadedProblem& loaded,
                             const HoldFindings& findings) {
  answer::Verdict verdict{.ended = findings.status()};
  bool any = false;
  if (!findings.cases.empty()) {
    if (auto text = decisive_words(findings); !text.empty())
      verdict.details.push_back(std::move(text));
  }
  if (findings.friction) {
    verdict.answer = bracket_of(loaded, findings);
    any = findings.friction->any_by_supports;
    if (auto text = one_state(loaded, *findings.friction); !text.empty())
      verdict.details.push_back(std::move(text));
  } else if (findings.diagram) {
    verdict.answer = diagram_of(options, loaded, *findings.diagram);
  } else if (options.points.size() > 1) {
    answer::HoldingSweep sweep{.requested = options.points.size()};
    for (std::size_t k = 0; k < findings.points.size(); ++k)
      sweep.points.push_back(factors_of(options, loaded, findings, k));
    verdict.answer = std::move(sweep);
    any = !findings.points.empty() && findings.points.front().factors.any_by_supports;
  } else if (!findings.points.empty()) {
    auto factors = factors_of(options, loaded, findings, 0);
    if (factors.grip)
      verdict.details.push_back(answer::grip_sentence(*factors.grip));
    else if (options.grip)
      verdict.missing.emplace_back(answer::no_grip_range);
    verdict.answer = std::move(factors);
    any = findings.points.front().factors.any_by_supports;
  }
  for (const auto& motion : findings.exclusions)
    verdict.details.push_back(exclusion_words(loaded, findings, motion));
  if (auto text = end_words(options, loaded, findings); !text.empty())
    verdict.details.push_back(std::move(text));
  if (!options.certificate.empty())
    std::ranges::move(missing_certificates(findings), std::back_inserter(verdict.missing));
  if (!any) {
    verdict.details.emplace_back(
        "\"Can hold\" means that a state of equilibrium exists; whether it is reached depends on "
        "the history of loading. Where it cannot hold a load, no history leads to such a state.");
  }
  return verdict;
}

}  // namespace kusabi::run
