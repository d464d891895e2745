// Truss of limit analysis in a result file, for all subcommands.
#pragma once

#include <string>

#include <nlohmann/json.hpp>

#include "problems/limit/limit_problem.hpp"
#include "problems/structure/model/structure.hpp"

namespace kusabi::run {

/// Sizes, units, uncertain loads and structure (docs/result-files.md).
/// @param truss structure of `problem`
/// @param file its name in the call
nlohmann::ordered_json limit_problem_json(const problems::LimitProblem& problem,
                                          const problems::Structure& truss,
                                          const std::string& file);

}  // namespace kusabi::run
