// A problem as one self-contained HTML page, before anything is solved.
#pragma once

#include <string>
#include <vector>

#include "run/results/result_reader.hpp"

namespace kusabi::run {

/// @param problem a result without an answer
/// @param summary of the structure, lines
/// @throws WrongInput
std::string problem_page(const ResultReader& problem, const std::string& summary,
                         const std::vector<std::string>& warnings);

}  // namespace kusabi::run
