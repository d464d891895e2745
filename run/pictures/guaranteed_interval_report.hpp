// Load factors carried under every admissible load: text and JSON.
#pragma once

#include <string>
#include <string_view>

#include <nlohmann/json.hpp>

#include "nodes/limit/guaranteed_interval.hpp"

namespace kusabi::run {

/// "2.26027659894 ... 2.2602765995, proved": bounds of a factor with their standing, rounded
/// outwards.
std::string factor_text(const support::Bracket& factor);

/// "factors -2.634577 ... 1.882777 are carried under all admissible loads, proved": the known
/// bounds, without a line end. @param loads those of the interval
std::string interval_text(const limit::GuaranteedInterval& interval, std::string_view loads);

/// Statement on the design load at every stage of loading, without a line end.
std::string passed_text(const limit::GuaranteedInterval& interval);

/// The bounds of a worst case, and the standing of both together.
nlohmann::ordered_json worst_case_json(const limit::LimitWorstCase& worst);

/// The key `guaranteed_interval` of a result (docs/result-files.md).
nlohmann::ordered_json interval_json(const limit::GuaranteedInterval& interval);

}  // namespace kusabi::run
