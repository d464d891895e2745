// Configurations in CSV: columns common to patterns, rays and critical.
#pragma once

#include <cstdint>
#include <span>

#include "nodes/wedged/relaxation/sign_pattern.hpp"
#include "problems/wedged/wedged_problem.hpp"
#include "run/output/csv.hpp"

namespace kusabi::run {

/// block, contact, separated, at_rest.
void add_pattern_columns(CsvWriter& csv);
/// @param inactive candidates of blocks that cannot wedge, which are inactive, too
void add_pattern(CsvWriter& csv, const problems::WedgedProblem& problem, std::uint32_t block,
                 const wedged::SignPattern& pattern, const support::IndexSet& inactive = {});

/// "r_n a" of all candidates, then "r_t a" (in space "r_t1 a", "r_t2 a"), then the same for u.
void add_configuration_columns(CsvWriter& csv, const problems::WedgedProblem& problem);
/// @param reactions dm, in the frames of all candidates; force. Empty: empty cells
/// @param displacements likewise; length
void add_configuration(CsvWriter& csv, const problems::WedgedProblem& problem,
                       std::span<const double> reactions, std::span<const double> displacements);

}  // namespace kusabi::run
