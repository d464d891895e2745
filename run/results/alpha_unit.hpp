// Unit of alpha in a result of limit analysis.
#pragma once

#include <optional>
#include <string>

#include "run/results/result_reader.hpp"

namespace kusabi::run {

/// The file's unit of force if every uncertain load is one component of weight one; nothing where
/// alpha multiplies loads with weights or shapes.
/// @throws WrongInput if the file is not of limit analysis
std::optional<std::string> unit_of_alpha(const ResultReader& reader);

}  // namespace kusabi::run
