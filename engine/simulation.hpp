// Simulation of a parallel search inside one process, in virtual time: real workers on a simulated
// transport.
//
// A rank with open nodes affects no other rank until it looks at a message, it runs out of nodes,
// or a reduction is due. It is not simulated before the first moment at which one of these can
// happen; then it catches up node by node, each at its own time. A message that arrives inside a
// node is looked at when that node is done. This changes only the number of switches between ranks,
// no time: thousands of ranks and 10^8 nodes take a minute.
#pragma once

#include <algorithm>
#include <concepts>
#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <queue>
#include <stdexcept>
#include <string>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

#include "engine/search.hpp"
#include "engine/transport/simulated.hpp"

namespace kusabi::engine {

/// A problem with virtual expansion times: `seconds()` is the virtual time of all expansions by
/// this object, `least_seconds()` a lower bound of the time of one node.
template <class P>
concept Timed = requires(const P& problem) {
  { problem.seconds() } -> std::convertible_to<double>;
  { problem.least_seconds() } -> std::convertible_to<double>;
};

template <class P>
struct Simulated;

/// Fails to compile, with a sentence, unless `P` can be simulated.
template <class P>
struct CheckedSimulation {
  static constexpr bool copies = std::copy_constructible<P>;
  static constexpr bool has_expansion_times =
      Timed<P> || !(NamesSeconds<P> || NamesLeastSeconds<P>);
  static_assert(copies, "a problem must be copyable to be simulated: each rank has its own");
  static_assert(
      has_expansion_times,
      "a timed problem needs `double seconds() const` and `double least_seconds() const`");
  static constexpr bool sound = CheckedProblem<P>::sound && copies && has_expansion_times;
  using SimulatedOrNothing = std::conditional_t<sound, Simulated<P>, void>;
};

template <class P>
using SimulatedOf = typename CheckedSimulation<P>::SimulatedOrNothing;

template <class P>
struct Simulated {
  Outcome<P> outcome;
  double seconds = 0;               ///< virtual time of the end of the last rank
  std::size_t largest_message = 0;  ///< bytes
  std::size_t left_behind = 0;      ///< messages never received; 0 unless the protocol is wrong
};

/// Simulation of ranks that have open nodes: both give the same times.
enum class Stepping {
  lazy,       ///< only when they can affect another rank
  each_step,  ///< always; for tests
};

/// Event loop of `simulate`.
template <Problem P>
class Simulation {
 public:
  Simulation(const P& problem, int ranks, const MachineModel& machine, const Options& options,
             Stepping stepping)
      : options_(options),
        network_(ranks, options.seed, machine),
        node_(machine.node),
        stepping_(stepping) {
    ranks_.reserve(static_cast<std::size_t>(ranks));
    for (int rank = 0; rank < ranks; ++rank) {
      auto own = std::make_unique<P>(problem);
      auto worker = std::make_unique<Worker<P>>(*own, network_.transport(rank), options_);
      ranks_.push_back({std::move(own), std::move(worker)});
      expect(rank, 0);
    }
  }

  /// @throws std::runtime_error after `max_steps` steps of all ranks
  Simulated<P> run(std::uint64_t max_steps) {
    while (!events_.empty()) {
      const auto [time, number, rank] = events_.top();
      events_.pop();
      visit(rank, time);
      if (steps_ > max_steps) {
        throw std::runtime_error("no end after " + std::to_string(max_steps) + " steps");
      }
    }
    return {std::move(*ranks_.front().worker).outcome(), last_, network_.largest_message(),
            network_.in_flight()};
  }

 private:
  struct Rank {
    std::unique_ptr<P> problem;
    std::unique_ptr<Worker<P>> worker;
    double clock = 0;       // of the next step
    double looks_from = 0;  // end of the last step
    // time of the next visit if no notice arrives
    double expected = std::numeric_limits<double>::infinity();
    Pace pace = {};
  };
  using Event = std::tuple<double, std::uint64_t, int>;  // time, a number that breaks ties, rank

  // Runs the steps of a busy rank up to `time`. A sleeping rank steps when it wakes up, whatever
  // has arrived; a polling rank receives at once.
  void visit(int number, double time) {
    auto& rank = ranks_[static_cast<std::size_t>(number)];
    if (rank.expected <= time) rank.expected = std::numeric_limits<double>::infinity();
    const double sees = std::max(time, rank.looks_from);
    if (looks(rank) && network_.has_arrived(number, sees)) rank.clock = std::min(rank.clock, sees);
    while (rank.clock <= time && rank.pace.state != Pace::State::done) {
      step(number, rank);
      if (rank.pace.state == Pace::State::waiting) break;
    }
    for (const auto& notice : network_.take_notices()) {
      events_.emplace(notice.time, ++events_seen_, notice.rank);
    }
    if (looks(rank) && network_.has_arrived(number, rank.looks_from)) rank.clock = rank.looks_from;
    if (rank.pace.state == Pace::State::waiting) expect(number, rank.clock);
    if (rank.pace.state == Pace::State::working) {
      const bool now = stepping_ == Stepping::each_step || network_.has_arrived(number, rank.clock);
      expect(number, now ? rank.clock : undisturbed_until(rank));
    }
  }

  static bool looks(const Rank& rank) {
    return rank.pace.state == Pace::State::waiting && !rank.pace.sleeps();
  }

  void expect(int number, double time) {
    auto& rank = ranks_[static_cast<std::size_t>(number)];
    if (time >= rank.expected) return;
    rank.expected = time;
    events_.emplace(time, ++events_seen_, number);
  }

  void step(int number, Rank& rank) {
    ++steps_;
    network_.advance(rank.clock);
    const auto opened = rank.worker->opened();
    const double spent = work(rank, 0);
    rank.pace = rank.worker->step();
    const double busy =
        network_.step_duration(number, work(rank, rank.worker->opened() - opened) - spent);
    last_ = std::max(last_, rank.clock);
    rank.looks_from = rank.clock + busy;
    rank.clock = rank.looks_from + rank.pace.wait;
    // Looks that would find nothing are left out.
    if (looks(rank)) rank.clock = std::max(rank.clock, rank.worker->quiet_until());
  }

  double work(const Rank& rank, std::uint64_t opened) const {
    if constexpr (Timed<P>) return rank.problem->seconds();
    return node_ * static_cast<double>(opened);
  }

  // Time until which the rank neither runs out of nodes nor requests any nor sends a message.
  double undisturbed_until(const Rank& rank) const {
    double node = node_;
    if constexpr (Timed<P>) node = rank.problem->least_seconds();
    const double open = static_cast<double>(rank.worker->open());
    const double before_last_step =
        std::max(0.0, open - options_.nodes_per_step - rank.worker->requests_at());
    const double busy = rank.clock + before_last_step * node;
    return std::max(rank.clock, std::min(busy, rank.worker->quiet_until()));
  }

  Options options_;
  SimulatedNetwork network_;
  double node_;
  Stepping stepping_;
  std::vector<Rank> ranks_;
  std::priority_queue<Event, std::vector<Event>, std::greater<>> events_;
  std::uint64_t events_seen_ = 0;
  std::uint64_t steps_ = 0;
  double last_ = 0;
};

/// Searches the tree of `problem` (copied for every rank) with `ranks` simulated ranks.
/// @throws std::runtime_error if the search does not end within `max_steps` steps of all ranks
template <class P>
SimulatedOf<P> simulate(const P& problem, int ranks, std::uint64_t seed,
                        const MachineModel& machine = {}, Options options = {},
                        std::uint64_t max_steps = 100'000'000, Stepping stepping = Stepping::lazy) {
  if constexpr (CheckedSimulation<P>::sound) {
    options.seed = seed;
    // Virtual clocks do not advance within a step, so the stride cannot be measured.
    if (options.nodes_per_step == 0) options.nodes_per_step = 1;
    return Simulation<P>(problem, ranks, machine, options, stepping).run(max_steps);
  }
}

}  // namespace kusabi::engine
