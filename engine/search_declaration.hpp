// Declaration of engine::search, for problem types whose search is compiled once, which takes 4 to
// 8 seconds. The header of such a type P declares
//
//   extern template OutcomeOf<P> engine::search(P&, engine::Transport&, const engine::Options&);
//
// and one of its sources, which includes engine/search.hpp, has the same line without `extern`.
#pragma once

#include "engine/detail/problem_check.hpp"
#include "engine/options.hpp"
#include "engine/transport/transport.hpp"

namespace kusabi::engine {

/// Searches the tree of `problem` on all ranks of `transport`. Every rank makes the same call with
/// its own copy of the problem.
///
/// @pre `P` is a Problem (engine/problem.hpp); otherwise compilation fails with a sentence
/// @post every node is opened exactly once, on one rank; apart from the statistics, the outcome on
///     rank 0 depends neither on the number of ranks nor on timing
/// @return an Outcome<P>
/// @throws ExpansionFailed if `expand` throws and the search runs in this process alone; over MPI
///   one line is printed and all ranks end
template <class P>
OutcomeOf<P> search(P& problem, Transport& transport, const Options& options = {});

}  // namespace kusabi::engine
