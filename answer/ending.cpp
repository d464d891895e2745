// Exit codes: 3 for an answer with open reservations, 1 for a refused certificate.
#include "answer/ending.hpp"

#include <algorithm>

#include "answer/values.hpp"
#include "answer/words.hpp"

namespace kusabi::answer {
namespace {

bool has_failed(const Verdict& verdict) {
  if (const auto* const check = std::get_if<CertificateCheck>(&verdict.answer))
    return check->refusals > 0;
  if (const auto* const measurement = std::get_if<Measurement>(&verdict.answer))
    return !measurement->agrees;
  return false;
}

bool is_carried_at_none(const Verdict& verdict) {
  if (const auto* const interval = std::get_if<LoadInterval>(&verdict.answer))
    return interval->carried_at_none.has_value();
  const auto* const steps = std::get_if<LoadSteps>(&verdict.answer);
  return steps != nullptr && steps->nominal_at_none.has_value();
}

}  // namespace

bool is_answered(const Verdict& verdict) {
  return std::ranges::none_of(reservations(verdict), &Reservation::open);
}

ExitCode exit_code(const Verdict& verdict) {
  if (has_failed(verdict)) return failed;
  return is_answered(verdict) ? solved : stopped_early;
}

std::string status_text(const Verdict& verdict) {
  if (verdict.ended != engine::Status::solved) return status_name(verdict.ended);
  const bool of_loads = std::holds_alternative<LoadInterval>(verdict.answer) ||
                        std::holds_alternative<MemberLoss>(verdict.answer) ||
                        std::holds_alternative<LoadSteps>(verdict.answer);
  if (of_loads && !is_answered(verdict)) return "open";
  return is_carried_at_none(verdict) ? "not-carried" : "solved";
}

}  // namespace kusabi::answer
