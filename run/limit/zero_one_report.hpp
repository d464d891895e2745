// What `kusabi limit` says of the 0-1 program (29): in the table, and in JSON.
#pragma once

#include <string>

#include <nlohmann/json.hpp>

#include "nodes/limit/root/limit_answer.hpp"

namespace kusabi::run {

/// The lines on ends that are those of (29) itself.
std::string printed_ends_text(const limit::LimitWorstCase& worst);

/// The lines on what (29) came to and took. @pre worst.zero_one
std::string zero_one_text(const limit::LimitWorstCase& worst);

/// Without what depends on the number of ranks.
nlohmann::ordered_json zero_one_json(const limit::LimitZeroOne& zero_one);

/// Whether exact arithmetic has shown (29) to be wrong: its M is too small.
bool is_refuted(const limit::LimitWorstCase& worst);

}  // namespace kusabi::run
