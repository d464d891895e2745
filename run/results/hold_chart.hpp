// Charts of results of `kusabi hold`: load factors that can be held, over friction or of two loads.
#pragma once

#include <optional>
#include <string>

#include "pictures/svg/chart.hpp"
#include "run/results/result_reader.hpp"

namespace kusabi::run {

/// True if a chart is the picture of the result: of several friction coefficients, or of two loads.
bool is_charted_hold(const ResultReader& reader);

/// A bar for each interval of load factors, the same at each friction coefficient, or areas of two
/// factors; nothing for a holding friction coefficient. @param sentence below the title
/// @throws WrongInput
std::optional<pictures::Chart> hold_chart(const ResultReader& reader, const std::string& sentence);

}  // namespace kusabi::run
