// What patterns, rays and critical say about the problem they were given and about its tree.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "nodes/wedged/tree/sign_pattern.hpp"
#include "problems/wedged/wedged_problem.hpp"

namespace kusabi::run {

/// One line: name, dimension, sizes.
std::string problem_line(const problems::WedgedProblem& problem);

/// The member `problem` of a result file. @param problem of the structure
nlohmann::ordered_json problem_json(const problems::Structure& structure,
                                    const problems::WedgedProblem& problem,
                                    const std::string& file);

/// The friction of each candidate at a coefficient of the search.
/// @throws WrongInput if one is neither 0 nor in the range that is computed with
std::vector<double> friction_at(const problems::WedgedProblem& problem, double coefficient,
                                const std::string& file);

/// The node names of a set of contact candidates, in their order.
std::vector<std::string> candidate_names(const problems::WedgedProblem& problem,
                                         const support::IndexSet& candidates);

/// Who touches in a pattern, as one cell of a table: their names, or "all but" those who do not if
/// that is shorter, and who is at rest. In one of several blocks their names.
std::string contact_text(const problems::WedgedProblem& problem,
                         const wedged::SignPattern& pattern);

/// Where a pattern touches, separates and, if anywhere, stays at rest; the number of its block,
/// from 1, if there are several. Blocks that cannot wedge at all are at rest as well, see `idle`.
/// @param idle candidates of such blocks
nlohmann::ordered_json pattern_json(const problems::WedgedProblem& problem, std::uint32_t block,
                                    const wedged::SignPattern& pattern,
                                    const support::IndexSet& idle = {});

/// Words as one cell of a table; "-" if there are none.
std::string listed(const std::vector<std::string>& words);

/// A dm-vector as m rows of d, in the frame (n, t1[, t2]) of each candidate.
nlohmann::ordered_json candidate_rows(std::span<const double> values, int dimension);

/// Reactions or displacements of one block's candidates among those of all, which are zero.
std::vector<double> of_all_candidates(const problems::WedgedProblem& problem, std::uint32_t block,
                                      std::span<const double> values);

/// The same of reactions or displacements of one block's candidates: those of all others are zero.
nlohmann::ordered_json block_rows(const problems::WedgedProblem& problem, std::uint32_t block,
                                  std::span<const double> values);

}  // namespace kusabi::run
