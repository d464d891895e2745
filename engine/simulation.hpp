// A whole parallel search inside one process, in virtual time: the workers are the real ones, only
// the wires are simulated.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <queue>
#include <stdexcept>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "engine/search.hpp"
#include "engine/transport/simulated.hpp"

namespace kusabi::engine {

template <class P>
struct Simulated {
  Outcome<P> outcome;
  double seconds = 0;               ///< virtual time at which the last rank was done
  std::size_t largest_message = 0;  ///< in bytes
  std::size_t left_behind = 0;      ///< messages never received; 0 unless the protocol is wrong
};

/// Searches the tree of `problem` (copied for every rank) with `ranks` simulated ranks.
/// @throws std::runtime_error if the search does not end within `most_steps` steps of all ranks,
///   naming the seed.
template <Problem P>
Simulated<P> simulate(const P& problem, int ranks, std::uint64_t seed, const Weather& weather = {},
                      Options options = {}, std::uint64_t most_steps = 100'000'000) {
  options.seed = seed;
  // Virtual clocks do not move within a step, so the stride cannot be measured.
  if (options.nodes_per_step == 0) options.nodes_per_step = 1;
  SimulatedNetwork network(ranks, seed, weather);
  std::vector<P> problems(static_cast<std::size_t>(ranks), problem);
  std::vector<std::unique_ptr<Worker<P>>> workers;
  using Event = std::tuple<double, std::uint64_t, int>;  // when, a number that breaks ties, who
  std::priority_queue<Event, std::vector<Event>, std::greater<>> events;
  std::uint64_t steps = 0;
  for (int rank = 0; rank < ranks; ++rank) {
    workers.push_back(std::make_unique<Worker<P>>(problems[static_cast<std::size_t>(rank)],
                                                  network.transport(rank), options));
    events.emplace(0.0, steps++, rank);
  }
  while (!events.empty()) {
    if (++steps > most_steps) {
      throw std::runtime_error("no end after " + std::to_string(most_steps) + " steps; seed " +
                               std::to_string(seed));
    }
    const auto [time, number, rank] = events.top();
    events.pop();
    network.advance(time);
    auto& worker = *workers[static_cast<std::size_t>(rank)];
    const auto opened_before = worker.opened();
    const Pace pace = worker.step();
    if (pace.state == Pace::State::done) continue;
    const double busy = network.step_duration(worker.opened() - opened_before);
    events.emplace(time + busy + pace.wait, steps, rank);
  }
  auto outcome = std::move(*workers.front()).outcome();
  return {std::move(outcome), network.now(), network.largest_message(), network.in_flight()};
}

}  // namespace kusabi::engine
