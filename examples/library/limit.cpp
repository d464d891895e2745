// The load factor at which a truss collapses, for the nominal load and in the worst case of
// uncertain loads, in one process or on all ranks of an MPI job:
//   limit limit-3x3.toml 40
#include <cstdio>
#include <cstdlib>

#include <boost/serialization/string.hpp>

#include "engine/collectives.hpp"
#include "engine/transport/mpi.hpp"
#include "engine/transport/single_process.hpp"
#include "nodes/limit/limit_loads.hpp"
#include "problems/files/problem_text.hpp"
#include "problems/files/structure_file.hpp"
#include "problems/limit/limit_problem.hpp"

using namespace kusabi;

int answer(engine::Transport& transport, const char* file, double alpha) {
  const auto text =
      engine::from_first_rank(transport, [&] { return problems::problem_text(file); });
  const auto truss = problems::read_structure(text, file);
  const auto problem = problems::limit_problem(truss);
  engine::require_equal_on_all_ranks(transport, problem.fingerprint);

  engine::Analysis analysis(transport);
  const auto found = limit::limit_loads(analysis, truss, problem, {.alpha = alpha}).answer;
  if (!analysis.is_first()) return 0;
  if (found.nominal) std::printf("nominal load factor %.10f\n", found.nominal->factor);
  if (found.worst) {
    std::printf("worst case %.10f to %.10f%s\n", found.worst->ends.at_least(),
                found.worst->ends.at_most(), found.worst->proved() ? ", proved" : "");
  }
  return found.whole() ? 0 : 3;
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
