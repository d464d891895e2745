// A whole parallel search inside one process, in virtual time: the workers are the real ones, only
// the wires are simulated.
//
// A rank that has nodes to open concerns nobody until a message reaches it, it has none left, or a
// survey is due. So it is left alone until the first moment at which one of these can be, and then
// catches up, node by node, each at its own time. This changes nothing but the number of times that
// the simulation turns from one rank to another: thousands of ranks and 10^8 nodes take a minute.
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

/// A problem whose nodes take different times: `seconds()` is the virtual time that all that this
/// object has expanded took, `least_seconds()` what a node takes at least.
template <class P>
concept Timed = requires(const P& problem) {
  { problem.seconds() } -> std::convertible_to<double>;
  { problem.least_seconds() } -> std::convertible_to<double>;
};

template <class P>
struct Simulated;

/// Stops the compiler with a sentence unless `P` can be simulated.
template <class P>
struct CheckedSimulation {
  static constexpr bool copies = std::copy_constructible<P>;
  static constexpr bool tells_its_time = Timed<P> || !(NamesSeconds<P> || NamesLeastSeconds<P>);
  static_assert(copies, "a problem must be copyable to be simulated: each rank has its own");
  static_assert(
      tells_its_time,
      "a timed problem needs `double seconds() const` and `double least_seconds() const`");
  static constexpr bool sound = CheckedProblem<P>::sound && copies && tells_its_time;
  using SimulatedOrNothing = std::conditional_t<sound, Simulated<P>, void>;
};

template <class P>
using SimulatedOf = typename CheckedSimulation<P>::SimulatedOrNothing;

template <class P>
struct Simulated {
  Outcome<P> outcome;
  double seconds = 0;               ///< virtual time at which the last rank was done
  std::size_t largest_message = 0;  ///< in bytes
  std::size_t left_behind = 0;      ///< messages never received; 0 unless the protocol is wrong
};

/// The loop behind `simulate`: which rank takes its next step when.
template <Problem P>
class Simulation {
 public:
  Simulation(const P& problem, int ranks, const Weather& weather, const Options& options)
      : options_(options), network_(ranks, options.seed, weather), node_(weather.node) {
    ranks_.reserve(static_cast<std::size_t>(ranks));
    for (int rank = 0; rank < ranks; ++rank) {
      auto own = std::make_unique<P>(problem);
      auto worker = std::make_unique<Worker<P>>(*own, network_.transport(rank), options_);
      ranks_.push_back({std::move(own), std::move(worker)});
      expect(rank, 0);
    }
  }

  /// @throws std::runtime_error after `most_steps` steps of all ranks
  Simulated<P> run(std::uint64_t most_steps) {
    while (!events_.empty()) {
      const auto [time, number, rank] = events_.top();
      events_.pop();
      visit(rank, time);
      if (steps_ > most_steps) {
        throw std::runtime_error("no end after " + std::to_string(most_steps) + " steps");
      }
    }
    return {std::move(*ranks_.front().worker).outcome(), last_, network_.largest_message(),
            network_.in_flight()};
  }

 private:
  struct Rank {
    std::unique_ptr<P> problem;
    std::unique_ptr<Worker<P>> worker;
    double clock = 0;                                           // of the next step
    double looks_from = 0;                                      // end of the last one
    double expected = std::numeric_limits<double>::infinity();  // its next visit, if no notice
    Pace pace = {};
  };
  using Event = std::tuple<double, std::uint64_t, int>;  // when, a number that breaks ties, who

  // A rank at work takes all its steps up to `time`. One that sleeps takes its step when it wakes
  // up, whatever has arrived; one that looks all the time finds at once what has.
  void visit(int number, double time) {
    auto& rank = ranks_[static_cast<std::size_t>(number)];
    if (rank.expected <= time) rank.expected = std::numeric_limits<double>::infinity();
    const bool looks = rank.pace.state == Pace::State::waiting && !rank.pace.sleeps();
    if (looks && time >= rank.looks_from) rank.clock = std::min(rank.clock, time);
    while (rank.clock <= time && rank.pace.state != Pace::State::done) {
      step(number, rank);
      if (rank.pace.state == Pace::State::waiting) break;
    }
    for (const auto& notice : network_.take_notices()) {
      events_.emplace(notice.time, ++events_seen_, notice.rank);
    }
    if (rank.pace.state == Pace::State::waiting) expect(number, rank.clock);
    if (rank.pace.state == Pace::State::working) expect(number, undisturbed_until(rank));
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
  }

  double work(const Rank& rank, std::uint64_t opened) const {
    if constexpr (Timed<P>) return rank.problem->seconds();
    return node_ * static_cast<double>(opened);
  }

  // Until when it neither runs out of nodes nor has anything to tell.
  double undisturbed_until(const Rank& rank) const {
    double node = node_;
    if constexpr (Timed<P>) node = rank.problem->least_seconds();
    const double open = static_cast<double>(rank.worker->open());
    const double before_last_step = std::max(0.0, open - options_.nodes_per_step);
    const double busy = rank.clock + before_last_step * node;
    return std::max(rank.clock, std::min(busy, rank.worker->quiet_until()));
  }

  Options options_;
  SimulatedNetwork network_;
  double node_;
  std::vector<Rank> ranks_;
  std::priority_queue<Event, std::vector<Event>, std::greater<>> events_;
  std::uint64_t events_seen_ = 0;
  std::uint64_t steps_ = 0;
  double last_ = 0;
};

/// Searches the tree of `problem` (copied for every rank) with `ranks` simulated ranks.
/// @throws std::runtime_error if the search does not end within `most_steps` steps of all ranks
template <class P>
SimulatedOf<P> simulate(const P& problem, int ranks, std::uint64_t seed,
                        const Weather& weather = {}, Options options = {},
                        std::uint64_t most_steps = 100'000'000) {
  if constexpr (CheckedSimulation<P>::sound) {
    options.seed = seed;
    // Virtual clocks do not move within a step, so the stride cannot be measured.
    if (options.nodes_per_step == 0) options.nodes_per_step = 1;
    return Simulation<P>(problem, ranks, weather, options).run(most_steps);
  }
}

}  // namespace kusabi::engine
