// One sentence for each subcommand with configurations; the numbers are those of the file.
#include "run/report/first_sentence.hpp"

#include <cmath>
#include <numbers>
#include <variant>

#include <fmt/format.h>

#include "answer/values.hpp"
#include "support/rounded_bounds.hpp"

namespace kusabi::run {
namespace {

constexpr std::size_t longest = 90;  ///< characters of a list of names

// "all 16 slip at once", "a…c slip first", "a slips first".
std::string slipping(const Answer& answer, const ShortNames& names) {
  if (answer.slips.size() > 1 && answer.slips.size() == answer.contact.size())
    return names.of(answer.slips, longest) + " slip at once";
  return fmt::format("{} {} first", names.of(answer.slips, longest),
                     answer.slips.size() == 1 ? "slips" : "slip");
}

// "contact at all 16 candidates", "contact at a…c".
std::string contact(const Answer& answer, const ShortNames& names) {
  const auto text = names.of(answer.contact, longest);
  const bool all = text.starts_with("all ") && !text.starts_with("all but ");
  return fmt::format("contact at {}{}", text, all ? " candidates" : "");
}

// "0.57736 (an angle of friction of 30°)"; a factor of the coefficients of the candidates has no
// angle. @param shown the coefficient, rounded
std::string friction_text(const std::string& shown, double coefficient, bool factor) {
  if (factor) return shown + answer::of_each_candidate(factor);
  return fmt::format("{} (an angle of friction of {:.4g}°)", shown,
                     std::atan(coefficient) * 180 / std::numbers::pi);
}

// The upper end of a bracket. In an open one, less friction may do.
std::string from_friction(const answer::CriticalBracket& found, bool solved, const Answer& leading,
                          const ShortNames& names) {
  const bool closed = solved && !found.wide && found.bracket.lower;
  const auto head = fmt::format(
      "It {} from friction coefficient {} on, with {}", closed ? "sticks" : "is known to stick",
      friction_text(support::rounded_up(*leading.order), *leading.order, found.factor),
      contact(leading, names));
  if (!closed || leading.slips.empty()) return head + ".";
  return fmt::format("{}; with less friction {}.", head, slipping(leading, names));
}

std::string from_friction(const answer::HoldingBracket& found, bool solved, const Answer& leading,
                          const ShortNames& names) {
  if (leading.slips.empty()) return {};
  const bool closed = solved && found.bracket.lower;
  return fmt::format(
      "It {} hold the load from friction coefficient {} on, with {}{}.",
      closed ? "can" : "is known to",
      friction_text(support::rounded_up(*leading.order), *leading.order, found.factor),
      contact(leading, names), closed ? "; with less, " + slipping(leading, names) : "");
}

// The pattern with the largest margin, or the ray that needs the least friction.
std::string of_largest_margin(const answer::Sticking& found, bool solved, bool ray,
                              const Answer& leading, const ShortNames& names) {
  // Flat and undecided patterns have no margin.
  if (!leading.needed || !leading.state.empty()) return {};
  const bool complete =
      solved && found.undecided == 0 && !found.example && !found.ambiguous && !found.remainder;
  const auto head =
      ray ? fmt::format("The extremal ray{} that needs the least friction is number {} ({})",
                        complete ? "" : " known", leading.number, contact(leading, names))
          : fmt::format("It sticks, and with the largest margin in pattern {}{} ({})",
                        leading.number, complete ? "" : " of those known", contact(leading, names));
  if (leading.slips.empty()) return head + "; it needs no friction.";
  return fmt::format(
      "{}, {} friction coefficient {}: with less, {}.", head,
      ray ? "which needs" : "whose configuration needs",
      friction_text(support::rounded_down(*leading.needed), *leading.needed, found.factor),
      slipping(leading, names));
}

}  // namespace

std::string first_sentence(const ResultReader& reader, const answer::Verdict& verdict,
                           const Answer* leading, const ShortNames& names) {
  if (leading == nullptr) return {};
  const bool solved = verdict.ended == engine::Status::solved;
  if (const auto* const found = std::get_if<answer::Sticking>(&verdict.answer)) {
    const bool ray = reader.text(reader.all(), "command") == "rays";
    return of_largest_margin(*found, solved, ray, *leading, names);
  }
  if (!leading->order) return {};
  if (const auto* const found = std::get_if<answer::CriticalBracket>(&verdict.answer))
    return from_friction(*found, solved, *leading, names);
  if (const auto* const found = std::get_if<answer::HoldingBracket>(&verdict.answer))
    return from_friction(*found, solved, *leading, names);
  return {};
}

}  // namespace kusabi::run
