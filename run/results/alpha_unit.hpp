// What the alpha of a result of limit analysis is counted in.
#pragma once

#include <optional>
#include <string>

#include "run/results/result_reader.hpp"

namespace kusabi::run {

/// The file's unit of force, if every uncertain load is one component that is there up to alpha;
/// nothing where alpha is a number of times loads with weights or shapes of their own.
/// @throws WrongInput if the file is none of limit analysis
std::optional<std::string> unit_of_alpha(const ResultReader& reader);

}  // namespace kusabi::run
