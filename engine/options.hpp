// What a caller can choose about a search, and what it can watch.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <string>

namespace kusabi::engine {

/// What is looked for.
enum class Goal {
  all,    ///< every solution
  best,   ///< the one with the least objective; of equals the first in depth-first order
  first,  ///< the first in depth-first order, whichever rank meets one first
};

/// As it is written into checkpoints.
constexpr const char* name_of(Goal goal) {
  return goal == Goal::all ? "all" : goal == Goal::best ? "best" : "first";
}

/// Which of the nodes that wait on a rank is opened next. The outcome does not depend on it.
enum class Order {
  depth_first,  ///< a child of the last one; needs the least memory
  best_first,   ///< the one with the least bound; opens the fewest nodes
  /// From the one with the least bound down, always a first child, to a leaf; then again. Finds
  /// solutions sooner than best_first, at the price of some nodes.
  hybrid,
};

/// Where to stop although the tree is not done. Each counts over all ranks (and over the runs that
/// a restarted search continues, but for the time), and is looked at at every survey, so it may be
/// overrun by what is done between two of them.
struct Limits {
  double seconds = std::numeric_limits<double>::infinity();
  std::uint64_t nodes = std::numeric_limits<std::uint64_t>::max();
  std::uint64_t solutions = std::numeric_limits<std::uint64_t>::max();
  /// Stop when objective - bound <= gap * |objective|; for Goal::best with a bounded problem.
  double gap = 0;
};

/// What somebody outside (a signal, a batch system) wants of a running search.
enum class Interrupt { none, checkpoint, stop };

/// Where the state of the search is kept for a restart. A new search never takes the place of a
/// checkpoint that is there: it must go on from it, or have another `file`.
struct CheckpointOptions {
  std::string file;       ///< the manifest; parts lie beside it. Empty: no checkpoints
  double interval = 600;  ///< seconds between two
  /// Another one whenever the incumbent is better than in the last: for Goal::best.
  bool on_improvement = false;
  std::string resume_from;  ///< a manifest found good by usable_checkpoint(); empty: start anew
  /// Fingerprint of the problem: a number that another problem is unlikely to have. It must be
  /// given with either file, since another problem's checkpoint would lead to a wrong answer.
  std::optional<std::uint64_t> problem;
};

/// The state of a running search, as of the last survey.
struct Progress {
  double seconds = 0;        ///< since the search began
  std::uint64_t opened = 0;  ///< nodes opened, on all ranks
  std::uint64_t open = 0;    ///< nodes waiting
  std::uint64_t found = 0;   ///< solutions
  double closed = 0;         ///< share of the tree that is done, 0 to 1
  std::uint64_t idle = 0;    ///< ranks without work
  std::uint64_t ranks = 1;   ///< all ranks
  double objective = std::numeric_limits<double>::infinity();  ///< of the best solution so far
  double bound = -std::numeric_limits<double>::infinity();     ///< least of the nodes that wait
                                                               ///< (but for nodes on their way)
};

struct Options {
  Goal goal = Goal::all;             ///< Goal::best: of a minimising problem
  Order order = Order::depth_first;  ///< any other: of a bounded problem
  Limits limits;
  CheckpointOptions checkpoint;

  /// Seconds between two surveys while all ranks are busy (idle ranks join at once).
  double survey_interval = 0.05;

  /// Seed of the random choice of victims. The outcome does not depend on it.
  std::uint64_t seed = 1;

  /// Nodes opened between two looks at the messages; 0: as many as take 10 to 20 microseconds.
  unsigned nodes_per_step = 0;

  /// How many nodes a rank keeps in the order of their bounds, roughly. When it has more, it
  /// dives: it searches depth first below the best of them, which adds no more than depth x
  /// branching nodes at any time.
  std::size_t heap_nodes = 100'000;

  /// The size, in bytes, above which the engine splits what it sends. A single node, solution or
  /// tally is sent whole.
  std::size_t message_bytes = std::size_t{64} * 1024;

  /// Share of the nodes, 0 to 1, that are opened twice to see whether `expand` depends on the node
  /// alone: children, solutions and bounds must be the same both times, byte for byte. If they are
  /// not, the search ends with an error that names the node. For trying a problem out: what
  /// `expand` counts or writes for itself, it counts or writes twice.
  double check_expand = 0;

  /// Events that each rank keeps for a trace (Outcome::traces); 0: no trace. The same on all ranks.
  std::size_t trace_events = 0;

  /// Called on rank 0 after each survey.
  std::function<void(const Progress&)> progress;

  /// Asked on every rank before each survey; what one rank is told, all do.
  std::function<Interrupt()> interrupt;

  /// Told, on rank 0, of what went wrong without ending the search: one line.
  std::function<void(const std::string&)> warn;
};

}  // namespace kusabi::engine
