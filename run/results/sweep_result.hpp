// What a result of `kusabi sweep` comes to: a sentence, and a chart.
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

/// "It cannot stick up to …", or how the worst case falls; empty if nothing is known.
/// @throws WrongInput
std::string sweep_sentence(const ResultReader& reader);

/// The staircase of counts over friction, or the load factor over alpha; nothing if none is known.
/// @throws WrongInput
std::optional<pictures::Chart> sweep_chart(const ResultReader& reader);

}  // namespace kusabi::run
