// One sentence for each subcommand with configurations; the numbers are those of the file.
#include "run/report/first_sentence.hpp"

#include <cmath>
#include <numbers>

#include <fmt/format.h>

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

bool is_complete(const ResultReader& reader) {
  return reader.text(reader.all(), "status") == "solved";
}

}  // namespace

std::string friction_text(double coefficient) {
  return fmt::format("{:.4g} (an angle of friction of {:.4g}°)", coefficient,
                     std::atan(coefficient) * 180 / std::numbers::pi);
}

std::string first_sentence(const ResultReader& reader, const Answer* leading,
                           const ShortNames& names) {
  if (leading == nullptr) return {};
  const auto command = reader.text(reader.all(), "command");
  if (command == "critical") {
    if (!leading->order) return {};
    const auto head = fmt::format("It sticks from friction coefficient {} on, with {}",
                                  friction_text(*leading->order), contact(*leading, names));
    if (leading->slips.empty()) return head + ".";
    return fmt::format("{}; with less friction {}.", head, slipping(*leading, names));
  }
  if (command == "hold") {
    if (!leading->order || leading->slips.empty()) return {};
    return fmt::format(
        "It can hold the load from friction coefficient {} on, with {}; with less, {}.",
        friction_text(*leading->order), contact(*leading, names), slipping(*leading, names));
  }
  if (!leading->needed) return {};
  const auto* const known = is_complete(reader) ? "" : " known";
  const auto head =
      command == "rays"
          ? fmt::format("The extremal ray{} that needs the least friction is number {} ({})", known,
                        leading->number, contact(*leading, names))
          : fmt::format("It sticks, and with the largest margin in pattern {}{} ({})",
                        leading->number, *known == '\0' ? "" : " of those known",
                        contact(*leading, names));
  if (leading->slips.empty()) return head + "; it needs no friction.";
  return fmt::format("{}, {} friction coefficient {}: with less, {}.", head,
                     command == "rays" ? "from" : "whose configuration needs",
                     friction_text(*leading->needed), slipping(*leading, names));
}

}  // namespace kusabi::run
