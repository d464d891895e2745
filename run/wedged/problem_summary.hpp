// Summary of the problem and its tree in patterns, rays and critical.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "answer/verdict.hpp"
#include "nodes/wedged/pattern_search.hpp"
#include "nodes/wedged/relaxation/sign_pattern.hpp"
#include "problems/wedged/wedged_problem.hpp"

namespace kusabi::run {

/// One line: name, dimension, sizes.
std::string problem_line(const problems::WedgedProblem& problem);

/// "friction coefficient 0.65", "0.65 times the friction given in the file".
std::string friction_text(const problems::WedgedProblem& problem, double coefficient);

/// The member `problem` of a result file. @param problem of the structure
nlohmann::ordered_json problem_json(const problems::Structure& structure,
                                    const problems::WedgedProblem& problem,
                                    const std::string& file);

/// Friction of each candidate at a coefficient of the search.
/// @throws WrongInput if one is neither 0 nor in the range of the arithmetic
std::vector<double> friction_at(const problems::WedgedProblem& problem, double coefficient,
                                const std::string& file);

/// Node names of a set of contact candidates, in their order.
std::vector<std::string> candidate_names(const problems::WedgedProblem& problem,
                                         const support::IndexSet& candidates);

/// Candidates in contact in a pattern, as one cell of a table: their names, or "all but" the others
/// if that is shorter, and inactive candidates. With several blocks always their names.
std::string contact_text(const problems::WedgedProblem& problem,
                         const wedged::SignPattern& pattern);

/// Candidates in contact, separated and inactive; the number of the block, from 1, if there are
/// several. Candidates of blocks that cannot wedge are inactive as well, see `inactive`.
/// @param inactive candidates of such blocks
nlohmann::ordered_json pattern_json(const problems::WedgedProblem& problem, std::uint32_t block,
                                    const wedged::SignPattern& pattern,
                                    const support::IndexSet& inactive = {});

/// Words as one cell of a table; "-" if there are none.
std::string listed(const std::vector<std::string>& words);

/// A dm-vector as m rows of d, in the frame (n, t1[, t2]) of each candidate.
nlohmann::ordered_json candidate_rows(std::span<const double> values, int dimension);

/// Reactions or displacements of all candidates, from those of one block; zero elsewhere.
std::vector<double> of_all_candidates(const problems::WedgedProblem& problem, std::uint32_t block,
                                      std::span<const double> values);

/// Friction of a candidate relative to the coefficient of the search.
double relative_friction(const problems::WedgedProblem& problem, int candidate);

/// |r_t| of a candidate. @param reactions of all candidates, dm
double tangential_reaction(const problems::WedgedProblem& problem,
                           std::span<const double> reactions, int candidate);

/// The same as JSON rows.
nlohmann::ordered_json block_rows(const problems::WedgedProblem& problem, std::uint32_t block,
                                  std::span<const double> values);

inline constexpr const char* begins_explained =
    "       (a pattern exists at a friction coefficient if some configuration loads exactly its\n"
    "        candidates in contact and separates exactly its separated ones)\n";

nlohmann::ordered_json exact_json(const wedged::ExactTest& test);

/// Nothing if the test was not called or has decided everything.
std::optional<answer::ExactRemainder> remainder_of(const wedged::ExactTest& test);

}  // namespace kusabi::run
