// Verdict in a result file: the key `verdict`.
#pragma once

#include <nlohmann/json.hpp>

#include "answer/verdict.hpp"

namespace kusabi::answer {

/// Sentence, details, reservations, exit code, and counts and bounds, each bound with its standing.
nlohmann::ordered_json verdict_json(const Verdict& verdict);

/// "proved" or "computed".
const char* standing_name(Standing standing);

/// "exact-arithmetic" or "solver-bounds".
const char* grounds_name(Grounds grounds);

}  // namespace kusabi::answer
