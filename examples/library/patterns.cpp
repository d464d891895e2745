// All sign patterns of wedged configurations, in one process or on all ranks of an MPI job:
//   patterns plane-truss.toml 0.8
#include <cstdio>
#include <cstdlib>

#include <boost/serialization/string.hpp>

#include "engine/collectives.hpp"
#include "engine/transport/mpi.hpp"
#include "engine/transport/single_process.hpp"
#include "nodes/wedged/pattern_search.hpp"
#include "nodes/wedged/tree/candidate_friction.hpp"
#include "problems/files/problem_text.hpp"
#include "problems/files/structure_file.hpp"
#include "problems/wedged/wedged_problem.hpp"

using namespace kusabi;

int answer(engine::Transport& transport, const char* file, double coefficient) {
  // One rank reads the file; each rank computes the problem, and all problems must be equal.
  const auto text =
      engine::from_first_rank(transport, [&] { return problems::problem_text(file); });
  const auto problem = problems::wedged_problem(problems::read_structure(text, file));
  engine::require_equal_on_all_ranks(transport, problem.provenance.fingerprint);

  engine::Analysis analysis(transport);
  const auto friction = wedged::candidate_friction(problem, coefficient);
  const auto found = wedged::find_patterns(analysis, problem, friction);
  if (!analysis.is_first()) return 0;
  for (const auto& leaf : found.leaves) {
    std::printf("t* = %.3e, in contact:", leaf.lower);
    for (const int i : leaf.pattern.contact)
      std::printf(" %s", problem.contact_names[static_cast<std::size_t>(i)].c_str());
    std::printf("\n");
  }
  std::printf("%s sign patterns, %zu open, on %zu ranks\n", found.count().digits().c_str(),
              found.unresolved(), found.outcome.ranks.size());
  return found.whole() && found.unresolved() == 0 ? 0 : 3;
}

int main(int argc, char** argv) {
  if (argc != 3) return 2;
  if (!engine::MpiEnvironment::launched()) {
    engine::SingleProcess alone;
    return answer(alone, argv[1], std::atof(argv[2]));
  }
  engine::MpiEnvironment mpi(argc, argv);
  engine::MpiTransport transport;
  return answer(transport, argv[1], std::atof(argv[2]));
}
