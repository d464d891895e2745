// What a result file says of a truss whose limit load was asked for, whichever command asked.
#pragma once

#include <string>

#include <nlohmann/json.hpp>

#include "problems/limit/limit_problem.hpp"
#include "problems/structure/model/structure.hpp"

namespace kusabi::run {

/// Sizes, units, uncertain loads and structure (docs/result-files.md).
/// @param truss of which `problem` is  @param file as the call has it
nlohmann::ordered_json limit_problem_json(const problems::LimitProblem& problem,
                                          const problems::Structure& truss,
                                          const std::string& file);

}  // namespace kusabi::run
