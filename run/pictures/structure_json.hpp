// Structure in a result file, so that pictures need no problem file.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "problems/limit/limit_problem.hpp"
#include "problems/structure/model/structure.hpp"

namespace kusabi::run {

/// Names and positions of nodes, members, elements, supports, candidates and loads
/// (docs/result-files.md). Nodes are referred to by index, from 0; empty parts are left out.
nlohmann::ordered_json structure_json(const problems::Structure& structure);

/// Elements in the order of the result file, shape by shape: their indices in the structure.
std::vector<std::size_t> listed_elements(const problems::Structure& structure);

/// The member `problem` of limit analysis: sizes, units, uncertain loads and structure (docs/result-files.md).
/// @param truss structure of `problem`
/// @param file its name in the call
nlohmann::ordered_json limit_problem_json(const problems::LimitProblem& problem,
                                          const problems::Structure& truss,
                                          const std::string& file);

}  // namespace kusabi::run
