// run: a whole program around a search, in one process or on the ranks of an MPI job. It has
// options for limits, goal and order, ends on signals, resumes, and prints progress and a summary.
//
//   int main(int argc, char** argv) {
//     const auto words = engine::own_words(argc, argv);  // without the options of `run`
//     Queens queens(words.empty() ? 8 : std::stoi(words[0]));
//     return engine::run(argc, argv, queens, [](const auto& outcome) {
//       std::cout << outcome.solutions.size() << " placements\n";
//     });
//   }
//
//   queens 12 --time-limit 60 --resume state       mpirun -np 8 queens 14
#pragma once

#include <concepts>
#include <cstdint>
#include <cstdio>
#include <exception>
#include <typeinfo>

#include "engine/collectives.hpp"
#include "engine/detail/program.hpp"
#include "engine/search.hpp"

namespace kusabi::engine {

/// A problem whose object has a number that differs between instances with high probability. It
/// protects the state of `--resume` where the instance is not determined by the words of the
/// command line.
template <class P>
concept Fingerprinted = requires(const P& problem) {
  { problem.fingerprint() } -> std::convertible_to<std::uint64_t>;
};

/// Searches the tree of `problem` as the options of the command line say (`--help` lists them). If
/// it has an objective, the goal is `best` unless `--goal` says otherwise. All other words are left
/// to the program (`own_words`), which constructs the problem from them, equally on all ranks.
/// @param report called with the outcome on rank 0, also if the search has stopped early
/// @param options of the program itself; those of the command line take precedence
/// @return the exit code of the program: 0 the whole tree is searched or the gap is reached, 1 an
///   error, 2 a wrong option, 3 stopped early
template <class P, class Report>
int run(int argc, char** argv, P& problem, Report report, const Options& options = {}) {
  try {
    Program program(argc, argv, {.has_objective = Optimising<P>, .bounded = Bounded<P>}, options);
    if (program.exit_code()) return *program.exit_code();
    std::uint64_t instance = 0;
    if constexpr (Fingerprinted<P>) instance = problem.fingerprint();
    program.prepare(typeid(P).name(), instance);
    const auto outcome = search(problem, program.transport(), program.options());
    // An error of the report ends all ranks.
    from_first_rank(program.transport(), [&] {
      report(outcome);
      return true;
    });
    return program.finish({outcome.status, outcome.opened(), outcome.open, outcome.saved});
  } catch (const std::exception& error) {
    std::fprintf(stderr, "error: %s\n", error.what());
    return 1;
  }
}

}  // namespace kusabi::engine
