// Results of the zero-one program (29) in table and JSON of `kusabi limit`.
#pragma once

#include <string>

#include <nlohmann/json.hpp>

#include "nodes/limit/root/limit_answer.hpp"

namespace kusabi::run {

/// Lines on the bounds of (29).
std::string printed_ends_text(const limit::LimitWorstCase& worst);

/// Lines on the result and the cost of (29). @pre worst.zero_one
std::string zero_one_text(const limit::LimitWorstCase& worst);

/// JSON without values that depend on the number of ranks.
nlohmann::ordered_json zero_one_json(const limit::LimitZeroOne& zero_one);

/// True if its M is too small: exact arithmetic, or the load of the best point of the printed
/// method, refutes (29).
bool is_refuted(const limit::LimitWorstCase& worst);

}  // namespace kusabi::run
