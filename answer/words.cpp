// Sentences common to all kinds of answer: an early end, and outputs that were not made.
#include "answer/words.hpp"

#include <algorithm>
#include <cctype>
#include <type_traits>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "answer/answer_words.hpp"
#include "answer/values.hpp"

namespace kusabi::answer {

std::string capital(std::string text) {
  text.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(text.front())));
  return text;
}

namespace {

template <class Answer>
constexpr bool answers_nothing =
    std::is_same_v<Answer, std::monostate> || std::is_same_v<Answer, Measurement>;

std::string early_end(const Verdict& verdict) {
  const auto text = fmt::format("Stopped early ({})", status_name(verdict.ended));
  if (std::holds_alternative<CertificateCheck>(verdict.answer))
    return text + ": nothing is proved until all statements are.";
  std::vector<std::string> parts;
  if (const auto left = verdict.nodes_left.value_or(0); left != 0)
    parts.push_back(counted(left, "open node") + (left == 1 ? " is left" : " are left"));
  if (std::holds_alternative<Sticking>(verdict.answer))
    parts.emplace_back("the list is not complete");
  return fmt::format("{}{}{}.", text, parts.empty() ? "" : ": ", fmt::join(parts, ", and "));
}

}  // namespace

const char* standing_word(Standing standing) {
  return name_of(standing).data();
}

const char* in_brackets(Standing standing) {
  return standing == Standing::proved ? "(proved)" : "(computed, not proved)";
}

const char* unless_proved(Standing standing) {
  return standing == Standing::proved ? "" : " (computed, not proved)";
}

std::string headline(const Verdict& verdict) {
  return std::visit(
      [&](const auto& found) -> std::string {
        if constexpr (answers_nothing<std::remove_cvref_t<decltype(found)>>) {
          return {};
        } else {
          return headline_of(found, verdict.ended);
        }
      },
      verdict.answer);
}

std::vector<Reservation> reservations(const Verdict& verdict) {
  std::vector<Reservation> all;
  if (verdict.ended != engine::Status::solved)
    all.push_back({.sentence = early_end(verdict), .open = true});
  std::visit(
      [&](const auto& found) {
        if constexpr (!answers_nothing<std::remove_cvref_t<decltype(found)>>)
          reserve(found, verdict.ended, all);
      },
      verdict.answer);
  // An output that a finished run could not make, such as the certificate of a computed bound,
  // leaves the answer as it is.
  const bool early = verdict.ended != engine::Status::solved;
  for (const auto& each : verdict.missing) all.push_back({.sentence = each, .open = early});
  std::stable_partition(all.begin(), all.end(), [](const auto& each) { return each.open; });
  return all;
}

}  // namespace kusabi::answer
