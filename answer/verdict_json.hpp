// Verdict in a result file: the key `verdict`, and first members of `result`.
#pragma once

#include <nlohmann/json.hpp>

#include "answer/verdict.hpp"

namespace kusabi::answer {

/// Sentence, details, reservations and exit code.
nlohmann::ordered_json verdict_json(const Verdict& verdict);

/// Counts and bounds, each bound with its standing; null if the command has no answer.
nlohmann::ordered_json answer_json(const Verdict& verdict);

/// The schemas of both, for `$defs`: `verdict`, and the first members of `result` by their `kind`.
nlohmann::ordered_json answer_definitions();

}  // namespace kusabi::answer
