// ContactProblem: problem of a subcommand on wedged configurations, from its file to its comparison
// on all ranks.
#pragma once

#include <optional>
#include <vector>

#include "problems/files/draft/facet_warning.hpp"
#include "problems/structure/checks/checked_structure.hpp"
#include "problems/wedged/wedged_problem.hpp"
#include "run/command/command_run.hpp"
#include "run/command/problem_input.hpp"

namespace kusabi::run {

struct ContactProblem {
  problems::CheckedStructure structure;
  std::vector<problems::FacetWarning> facets;
  problems::WedgedProblem problem;
};

/// Parses the input, with warnings on its faults and on what the subcommand ignores, and prepares
/// the problem on every rank.
/// @param friction coefficient for warnings on normals of faceted surfaces; none: without them
/// @throws WrongInput, support::InputError, support::Stopped, engine::RankMismatch on every rank
ContactProblem contact_problem(CommandRun& run, const ProblemInput& input,
                               std::optional<double> friction = {});

/// The problem of a structure, the same on all ranks.
problems::WedgedProblem agreed_problem(CommandRun& run,
                                       const problems::CheckedStructure& structure);

/// Warnings on normals of faceted surfaces.
void warn_of_facets(CommandRun& run, const ProblemInput& input,
                    const std::vector<problems::FacetWarning>& facets, double friction);

/// Opens the state file of --resume, if given, for this problem.
void keep_state(CommandRun& run, const CheckpointChoice& choice,
                const problems::WedgedProblem& problem);

/// Fingerprint of the loads and clearances of a structure.
std::uint64_t fingerprint_of_loads(const problems::Structure& structure);

}  // namespace kusabi::run
