// Load factors carried under every admissible load: text and JSON.
#pragma once

#include <string>

#include <nlohmann/json.hpp>

#include "nodes/limit/guaranteed_interval.hpp"

namespace kusabi::run {

/// "-2.634577 ... 1.882777, proved": the known bounds, without a line end.
std::string interval_text(const limit::GuaranteedInterval& interval);

/// Statement on the design load at every stage of loading, without a line end.
std::string passed_text(const limit::GuaranteedInterval& interval);

/// The key `guaranteed_interval` of a result (docs/result-files.md).
nlohmann::ordered_json interval_json(const limit::GuaranteedInterval& interval);

}  // namespace kusabi::run
