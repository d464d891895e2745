// ContactProblem: problem of a subcommand on wedged configurations, from its file to its comparison
// on all ranks, with the words of --cuts and the messages on loads that are ignored.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "nodes/wedged/relaxation/pattern_options.hpp"
#include "problems/files/draft/facet_warning.hpp"
#include "problems/structure/checks/checked_structure.hpp"
#include "problems/structure/model/structure.hpp"
#include "problems/wedged/wedged_problem.hpp"
#include "run/command/command_run.hpp"
#include "run/command/option_table.hpp"
#include "run/command/problem_input.hpp"
#include "run/session/session.hpp"

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

/// Replaces stiffness and compliance by those of rank 0 if they differ in a single bit. (The
/// displacements under unit reactions are used on rank 0 only.)
/// @throws engine::RankMismatch on every rank unless all have the same input
void make_equal_on_all_ranks(Session& session, problems::WedgedProblem& problem);

/// One line for loads, one for clearances, each if the file has any.
std::vector<std::string> ignored_loads(const problems::Structure& structure,
                                       std::string_view command);

/// A line for the uncertain loads whose half-widths the file does not give, if there are any.
std::vector<std::string> ignored_uncertainty(const problems::Structure& structure,
                                             std::string_view command);

/// Words of --cuts.
inline const OptionWords<wedged::Tightening>& cuts_words() {
  static const OptionWords<wedged::Tightening> words{{"auto", wedged::Tightening::automatic},
                                                     {"none", wedged::Tightening::never},
                                                     {"always", wedged::Tightening::always}};
  return words;
}

}  // namespace kusabi::run
