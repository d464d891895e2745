// Random schedules of messages from a seed, and the invariants that every schedule must satisfy.
#include "run/bench/bench_schedules.hpp"

#include <array>
#include <chrono>
#include <cstdio>
#include <exception>
#include <random>
#include <string>

#include <fmt/format.h>

#include "answer/exit_code.hpp"
#include "engine/simulation.hpp"
#include "nodes/benchmark/sized_tree.hpp"
#include "run/output/standard_output.hpp"

namespace kusabi::run {
namespace {

using benchmark::SizedTree;
using engine::Goal;
using engine::MachineModel;
using engine::Order;

// Machines on which one activity or another is the slowest.
constexpr std::array machines{
    MachineModel{},
    MachineModel{.latency = 100e-6},                         // messages
    MachineModel{.latency = 20e-6, .bandwidth = 1e6},        // long messages
    MachineModel{.latency = 50e-6, .node = 0},               // everything but nodes
    MachineModel{.node = 100e-6},                            // nodes
    MachineModel{.handling = 5e-6},                          // sending and receiving
    MachineModel{.latency = 20e-6, .machine = 4},            // between machines
    MachineModel{.stall = 5e-3, .stall_probability = 0.02},  // some ranks stall
    MachineModel{.latency = 200e-6, .stall = 2e-3, .stall_probability = 0.1}  // a random mixture
};

struct Draw {
  SizedTree tree;
  int ranks;
  MachineModel machine;
  engine::Options options;
};

Draw draw(std::uint64_t seed) {
  std::mt19937_64 random(seed);
  const auto below = [&](std::uint64_t bound) { return random() % bound; };
  Draw draw{SizedTree(random(), 1 + below(400), 1 + below(8)),
            static_cast<int>(1 + below(below(4) == 0 ? 100 : 10)),
            machines[below(machines.size())],
            {}};
  constexpr std::array goals{Goal::all, Goal::all, Goal::best, Goal::first};
  draw.options.goal = goals[below(goals.size())];
  constexpr std::array orders{Order::depth_first, Order::depth_first, Order::best_first,
                              Order::hybrid};
  draw.options.order = orders[below(orders.size())];
  if (below(2) == 0) draw.options.heap_nodes = 1 + below(30);
  draw.options.nodes_per_step = below(4) == 0 ? 16 : 1;
  draw.options.message_bytes = below(2) == 0 ? engine::Options{}.message_bytes : below(200);
  constexpr std::array intervals{0.05, 0.05, 1e-4, 1e-5};
  draw.options.reduction_interval = intervals[below(intervals.size())];
  if (below(8) == 0) draw.options.limits.nodes = 1 + below(300);
  if (below(8) == 0) draw.options.trace_events = 1 + below(20);
  if (below(4) == 0) draw.options.pool.count = 1 + below(20);
  if (below(4) == 0) draw.options.pool.gap = static_cast<double>(below(4));
  if (below(8) == 0) draw.options.cutoff = static_cast<double>(below(6));
  if (below(8) == 0) draw.options.heap_bytes = below(5000);
  return draw;
}

// The failed invariant of the search of this seed; empty: none.
std::string fault(std::uint64_t seed) {
  auto [tree, ranks, machine, options] = draw(seed);
  engine::Options depth_first;
  depth_first.goal = options.goal;
  depth_first.pool = options.pool;
  depth_first.cutoff = options.cutoff;
  const auto alone = engine::search(tree, depth_first);
  constexpr std::uint64_t max_steps = 10'000'000;
  const auto many = engine::simulate(tree, ranks, seed, machine, options, max_steps);
  if (many.left_behind != 0) return fmt::format("{} messages not received", many.left_behind);
  const auto& outcome = many.outcome;
  if (outcome.status == engine::Status::node_limit) {
    const bool right = outcome.opened() >= options.limits.nodes && outcome.open > 0;
    return right ? "" : "ended before the limit";
  }
  if (outcome.status != engine::Status::solved || outcome.open != 0) return "ended early";
  if (options.goal == Goal::all && outcome.opened() != alone.opened()) {
    return fmt::format("opened {} nodes, expected {}", outcome.opened(), alone.opened());
  }
  if (options.goal == Goal::all && outcome.fingerprint() != alone.fingerprint()) {
    return "opened a node twice and another one not at all";
  }
  if (outcome.solutions.size() != alone.solutions.size()) {
    return fmt::format("found {} solutions, expected {}", outcome.solutions.size(),
                       alone.solutions.size());
  }
  for (std::size_t i = 0; i < alone.solutions.size(); ++i) {
    const auto& [path, solution] = outcome.solutions[i];
    if (path != alone.solutions[i].path || solution != alone.solutions[i].solution) {
      return fmt::format("solution {} is at {}, expected {}", i, engine::to_string(path),
                         engine::to_string(alone.solutions[i].path));
    }
  }
  return {};
}

std::string fault_or_exception(std::uint64_t seed) {
  try {
    return fault(seed);
  } catch (const std::exception& error) {
    return error.what();
  }
}

}  // namespace

int bench_schedules(Session& session, const BenchSchedulesOptions& options) {
  using Clock = std::chrono::steady_clock;
  constexpr std::chrono::seconds interval{5};
  auto next_line = Clock::now() + interval;
  std::uint64_t tried = 0;
  std::uint64_t failed_seeds = 0;
  const auto step = static_cast<std::uint64_t>(session.ranks());
  const auto end = options.first_seed + options.seeds;
  for (auto seed = options.first_seed + static_cast<std::uint64_t>(session.transport().rank());
       seed < end; seed += step) {
    ++tried;
    if (const auto wrong = fault_or_exception(seed); !wrong.empty()) {
      ++failed_seeds;
      fmt::print("seed {}: {}; repeat with: kusabi bench schedules --first-seed {} --seeds 1\n",
                 seed, wrong, seed);
      std::fflush(stdout);
    }
    if (!session.is_first() || Clock::now() < next_line) continue;
    next_line = Clock::now() + interval;
    print_message("{} of {} schedules, {} failed\n", tried * step, options.seeds, failed_seeds);
  }
  fmt::print("{} schedules{}, {} failed\n", tried,
             step == 1 ? "" : fmt::format(" on rank {}", session.transport().rank()), failed_seeds);
  return failed_seeds == 0 ? answer::solved : answer::failed;
}

}  // namespace kusabi::run
