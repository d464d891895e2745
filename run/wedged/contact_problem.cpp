// Stages of the preparation.
#include "run/wedged/contact_problem.hpp"

#include "run/output/values.hpp"
#include "run/session/kept_state.hpp"
#include "run/wedged/ignored_loads.hpp"
#include "run/wedged/problem_comparison.hpp"
#include "support/fingerprint.hpp"

namespace kusabi::run {

ContactProblem contact_problem(CommandRun& run, const ProblemInput& input,
                               std::optional<double> friction) {
  auto [structure, facets] = input.structure_and_facets(run);
  warn_all(run.session(), ignored_loads(structure, run.name()));
  if (friction) warn_of_facets(run, input, facets, *friction);
  auto problem = agreed_problem(run, structure);
  return {std::move(structure), std::move(facets), std::move(problem)};
}

problems::WedgedProblem agreed_problem(CommandRun& run,
                                       const problems::CheckedStructure& structure) {
  auto problem = run.within_limits(
      [&](const auto& work) { return problems::wedged_problem(structure, work); });
  make_equal_on_all_ranks(run.session(), problem);
  return problem;
}

void warn_of_facets(CommandRun& run, const ProblemInput& input,
                    const std::vector<problems::FacetWarning>& facets, double friction) {
  warn_all(run.session(), warning_lines(facets, friction, input.file));
}

void keep_state(CommandRun& run, const CheckpointChoice& choice,
                const problems::WedgedProblem& problem) {
  run.keep_state(choice, {{"the problem", hexadecimal(problem.provenance.fingerprint)}});
}

std::uint64_t fingerprint_of_loads(const problems::Structure& structure) {
  support::Fingerprint fingerprint;
  for (const auto& load : structure.loads) {
    fingerprint.add(load.kind == problems::Load::Kind::dead ? 0.0 : 1.0);
    fingerprint.add(static_cast<double>(load.node));
    if (!load.load_case.empty()) fingerprint.add(std::string_view(load.load_case));
    for (const double component : load.force) fingerprint.add(component);
  }
  for (const double force : structure.imposed_forces.reshaped()) fingerprint.add(force);
  for (const auto& point : structure.contact) fingerprint.add(point.clearance);
  return fingerprint.value();
}

}  // namespace kusabi::run
