// The smallest friction coefficient at which anything can wedge, with proved bounds. The search
// ends after a minute, or at Ctrl-C, with the bounds found so far:
//   critical two-bars.toml
#include <cstdio>

#include "engine/signals.hpp"
#include "engine/transport/single_process.hpp"
#include "nodes/wedged/critical_search.hpp"
#include "problems/files/problem_text.hpp"
#include "problems/files/structure_file.hpp"
#include "problems/wedged/wedged_problem.hpp"

using namespace kusabi;

int main(int argc, char** argv) {
  if (argc != 2) return 2;
  const auto structure = problems::read_structure(problems::problem_text(argv[1]), argv[1]);
  const auto problem = problems::wedged_problem(structure);

  engine::install_signal_handlers();
  engine::AnalysisOptions analysis_options;
  analysis_options.limits.seconds = 60;
  analysis_options.interrupt = engine::asked_by_signal;
  analysis_options.watch = [](engine::Goal, const engine::ShownObjective&) {
    return [](const engine::Progress& state) {
      std::fprintf(stderr, "%llu nodes\n", static_cast<unsigned long long>(state.opened));
    };
  };
  engine::SingleProcess alone;
  engine::Analysis analysis(alone, analysis_options);
  const auto found = wedged::find_critical_friction(analysis, structure, problem, {.width = 1e-9});
  std::printf("nothing wedges below %.10f%s\n", found.bracket.at_least(),
              is_proved(found.bracket.lower) ? ", proved" : "");
  if (found.bracket.upper) {
    std::printf("something does at %.10f%s\n", found.bracket.at_most(),
                is_proved(found.bracket.upper) ? ", proved" : "");
  }
  return found.answered() ? 0 : 3;
}
