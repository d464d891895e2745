// The chart of a result of `kusabi sweep`.
#pragma once

#include <optional>
#include <string>

#include "pictures/svg/chart.hpp"
#include "run/results/result_reader.hpp"

namespace kusabi::run {

/// False of what is no result, too.
bool is_sweep(const ResultReader& reader);

/// Of a sweep: whether the uncertainty of loads was swept, or else friction. @throws WrongInput
bool sweeps_loads(const ResultReader& reader);

/// The staircase of counts over friction, or the load factor over alpha; nothing if none is known.
/// @param sentence the headline, which it has below its title @throws WrongInput
std::optional<pictures::Chart> sweep_chart(const ResultReader& reader, const std::string& sentence);

}  // namespace kusabi::run
