// The load factors that are carried under every admissible load: in the table, and in JSON.
#pragma once

#include <string>

#include <nlohmann/json.hpp>

#include "nodes/limit/guaranteed_interval.hpp"

namespace kusabi::run {

/// "-2.634577 ... 1.882777, proved": what is known of it, without a line end.
std::string interval_text(const limit::GuaranteedInterval& interval);

/// The key `guaranteed_interval` of a result (docs/result-files.md).
nlohmann::ordered_json interval_json(const limit::GuaranteedInterval& interval);

}  // namespace kusabi::run
