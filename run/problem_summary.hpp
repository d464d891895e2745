// What every command says about the problem it was given.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "problems/wedged_problem.hpp"

namespace kusabi::run {

/// One line: name, dimension, sizes.
std::string problem_line(const problems::WedgedProblem& problem);

/// The member `problem` of a result file.
nlohmann::ordered_json problem_json(const problems::WedgedProblem& problem,
                                    const std::string& file);

/// The node names of a set of contact candidates, in their order.
std::vector<std::string> candidate_names(const problems::WedgedProblem& problem,
                                         std::uint64_t candidates);

/// Words as one cell of a table; "-" if there are none.
std::string listed(const std::vector<std::string>& words);

/// A dm-vector as m rows of d, in the frame (n, t1[, t2]) of each candidate.
nlohmann::ordered_json candidate_rows(std::span<const double> values, int dimension);

}  // namespace kusabi::run
