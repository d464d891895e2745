// Chart of a result of `kusabi sweep`, and of a curve of `kusabi limit`.
#pragma once

#include <optional>
#include <string>

#include "pictures/svg/chart.hpp"
#include "run/results/result_reader.hpp"

namespace kusabi::run {

/// False also if it is not a result.
bool is_sweep(const ResultReader& reader);

/// True if the uncertainty of loads was swept, false if friction was. @throws WrongInput
bool sweeps_loads(const ResultReader& reader);

/// Staircase of counts over friction, or load factor over alpha; nothing if none is known.
/// @param sentence headline, below the title
/// @throws WrongInput
std::optional<pictures::Chart> sweep_chart(const ResultReader& reader, const std::string& sentence);

/// Load factor over beta, by the pieces under `key` of the result of `kusabi limit`; nothing if
/// there are none. @param name of the curve  @throws WrongInput
std::optional<pictures::Chart> load_curve_chart(const ResultReader& reader, const char* key,
                                                const std::string& name);

}  // namespace kusabi::run
