// Parallel tree search for any branching problem: the header that users of the engine include.
//
//   struct Queens {
//     struct Node { ... };                  // a subproblem; Boost-serialisable
//     struct Solution { ... };              // the result of a leaf; Boost-serialisable
//     Node root() const;
//     void expand(Node&& node, engine::Expansion<Queens>& out);   // out.branch, out.solution
//   };
//
//   Queens queens(8);
//   auto outcome = engine::search(queens);               // in this process, without MPI
//
//   engine::MpiEnvironment mpi(argc, argv);              // or on every rank of an MPI job
//   engine::MpiTransport transport;
//   auto outcome = engine::search(queens, transport);    // the same outcome, on rank 0
//
// engine/run.hpp makes a program of it; examples/engine is a project to copy, with five programs.
// engine/detail/protocol/rank.hpp and docs/engine.md describe the protocol.
#pragma once

#include <chrono>
#include <exception>
#include <string>
#include <thread>
#include <utility>

#include "engine/detail/worker.hpp"
#include "engine/options.hpp"
#include "engine/outcome.hpp"
#include "engine/problem.hpp"
#include "engine/search_declaration.hpp"
#include "engine/transport/single_process.hpp"
#include "engine/transport/transport.hpp"

namespace kusabi::engine {

template <class P>
OutcomeOf<P> search(P& problem, Transport& transport, const Options& options) {
  if constexpr (CheckedProblem<P>::sound) {
    try {
      Worker<P> worker(problem, transport, options);
      for (;;) {
        const Pace pace = worker.step();
        if (pace.state == Pace::State::done) return std::move(worker).outcome();
        if (pace.sleeps()) {
          std::this_thread::sleep_for(std::chrono::duration<double>(pace.wait));
        } else if (pace.state == Pace::State::waiting) {
          std::this_thread::yield();
        }
      }
    } catch (const std::exception& error) {
      transport.abandon(error.what());
      throw;
    }
  }
}

/// As above, in this process alone, without MPI.
template <class P>
OutcomeOf<P> search(P& problem, const Options& options = {}) {
  SingleProcess transport;
  return search(problem, transport, options);
}

}  // namespace kusabi::engine
