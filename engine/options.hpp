// Options of a search, and the progress it reports.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <string>

namespace kusabi::engine {

/// Goal of a search.
enum class Goal {
  all,    ///< all solutions
  best,   ///< the solution of the best objective; among equals the first in depth-first order
  first,  ///< the first solution in depth-first order, whichever rank finds one first
};

/// Name in checkpoints.
constexpr const char* name_of(Goal goal) {
  return goal == Goal::all ? "all" : goal == Goal::best ? "best" : "first";
}

/// Order in which a rank opens its nodes. The outcome does not depend on it.
enum class Order {
  depth_first,  ///< last in, first out; needs the least memory
  best_first,   ///< least bound first; opens the fewest nodes
  /// Dives from the node of least bound along first children to a leaf, repeatedly. Finds solutions
  /// sooner than best_first and opens somewhat more nodes.
  hybrid,
};

/// Limits at which a search stops early. They count over all ranks and, except for the time, over
/// the resumed runs. They are checked at every reduction, so a search may exceed them slightly.
struct Limits {
  double seconds = std::numeric_limits<double>::infinity();
  std::uint64_t nodes = std::numeric_limits<std::uint64_t>::max();
  std::uint64_t solutions = std::numeric_limits<std::uint64_t>::max();
  /// Relative gap: stops when objective - bound <= gap * |objective|. For Goal::best with a bounded
  /// problem.
  double gap = 0;
};

/// Solutions that Goal::best keeps: the `count` best ones, of equal objectives those first in
/// depth-first order, as far as their objectives differ from the best one by at most both gaps.
struct Pool {
  static constexpr std::uint64_t no_limit = std::numeric_limits<std::uint64_t>::max();

  std::uint64_t count = 1;
  double gap = std::numeric_limits<double>::infinity();
  /// Relative to the size of the best objective; less than 1, or infinite.
  double relative_gap = std::numeric_limits<double>::infinity();
};

/// Request from outside (a signal, a batch system) to a running search.
enum class Interrupt { none, checkpoint, stop };

/// Files in which the state of a search is saved. A new search never overwrites a checkpoint: it
/// must resume from it, or use another `file`.
struct CheckpointOptions {
  std::string file;       ///< manifest; parts lie beside it. Empty: no checkpoints
  double interval = 600;  ///< seconds between two checkpoints
  /// Writes a checkpoint, in addition, when the incumbent has improved since the last: for
  /// Goal::best.
  bool on_improvement = false;
  std::string resume_from;  ///< a manifest verified by usable_checkpoint(); empty: a new search
  /// Fingerprint of the problem: a number that differs between problems with high probability.
  /// Required with either file, since the checkpoint of another problem would give a wrong answer.
  std::optional<std::uint64_t> problem;
};

/// State of a running search, as of the last reduction. Objective and bound are infinite as long as
/// there is none.
struct Progress {
  double seconds = 0;                                          ///< since the search began
  std::uint64_t opened = 0;                                    ///< nodes opened, on all ranks
  std::uint64_t open = 0;                                      ///< open nodes
  std::uint64_t found = 0;                                     ///< solutions found
  double closed = 0;                                           ///< closed share of the tree, 0 to 1
  std::uint64_t idle = 0;                                      ///< ranks without an open node
  std::uint64_t ranks = 1;                                     ///< number of ranks
  double objective = std::numeric_limits<double>::infinity();  ///< of the incumbent
  /// least of the open nodes (nodes in flight excluded)
  double bound = -std::numeric_limits<double>::infinity();
};

struct Options {
  Goal goal = Goal::all;             ///< Goal::best requires an objective()
  Order order = Order::depth_first;  ///< other orders require a bounded problem
  Limits limits;
  Pool pool;
  /// Objective of a solution known in advance: Goal::best keeps only solutions that are as good.
  /// (A known solution itself is reported by `expand` at the root.)
  std::optional<double> cutoff;
  CheckpointOptions checkpoint;

  /// Seconds between two reductions while all ranks are busy (idle ranks join at once).
  double reduction_interval = 0.05;

  /// Random seed of the choice of victims, the same on all ranks. The outcome does not depend on
  /// it.
  std::uint64_t seed = 1;

  /// Nodes opened between two polls of the messages; 0: as many as take 10 to 20 microseconds.
  unsigned nodes_per_step = 0;

  /// Approximate number of nodes that a rank keeps in its heap. Above it, the rank searches depth
  /// first below its best node, which adds at most depth x branching nodes.
  std::size_t heap_nodes = 100'000;

  /// The same for the memory of the heap, in bytes, as the sum of the sizes of its nodes in
  /// messages and of their paths.
  std::size_t heap_bytes = std::numeric_limits<std::size_t>::max();

  /// Message size, in bytes, above which the engine splits its messages. A single node, solution or
  /// tally is not split. With their headers, messages of this size are below the usual eager limits
  /// of MPI, from 4 KiB on.
  std::size_t message_bytes = 4000;

  /// Share of the nodes, 0 to 1, that are expanded twice, to test that `expand` depends on the node
  /// alone: children, solutions and bounds must be equal byte for byte. A difference ends the
  /// search with an error that names the node. For tests of a problem: side effects of `expand`,
  /// such as counts, happen twice.
  double check_expand = 0;

  /// Amount, relative to the greater of 1 and the objective, by which a bound may contradict the
  /// objective of a solution of its node (Goal::best). A greater difference ends the search with an
  /// error, since the bound has the wrong sign or prunes too much.
  double bound_tolerance = 1e-6;

  /// Number of events that each rank keeps for a trace (Outcome::traces); 0: no trace. The same on
  /// all ranks.
  std::size_t trace_events = 0;

  /// Called after each node with its depth and the CPU time of its expansion, in seconds: a
  /// recording from which `kusabi bench scaling` predicts the search on many ranks. Requires one
  /// rank and depth-first order, in which the depths alone determine the tree.
  std::function<void(std::size_t depth, double seconds)> record;

  /// Called on rank 0 after each reduction.
  std::function<void(const Progress&)> progress;

  /// Called on every rank before each reduction; a request on one rank applies to all.
  std::function<Interrupt()> interrupt;

  /// Called with a line about a fault that does not end the search; without it, the line goes to
  /// standard error.
  std::function<void(const std::string&)> warn;
};

}  // namespace kusabi::engine
