// Simulated searches, one per row, with the use of their time.
#include "run/bench/bench_scaling.hpp"

#include <algorithm>
#include <cstdio>
#include <stdexcept>

#include <fmt/format.h>

#include "engine/simulation.hpp"
#include "nodes/benchmark/sized_tree.hpp"
#include "run/output/exit_code.hpp"

namespace kusabi::run {
namespace {

constexpr double micro = 1e-6;

// Totals over all ranks.
struct Sums {
  std::uint64_t requests = 0;
  std::uint64_t transfers = 0;
  double ramp_up = 0;
  double between = 0;
  double tail = 0;
  double last_node = 0;  // time at which the last node is done
  double end = 0;        // termination is known to the last rank
};

Sums sums(const engine::Outcome<benchmark::SizedTree>& outcome) {
  Sums sums;
  for (const auto& [rank, tally] : outcome.ranks) {
    sums.requests += rank.requests;
    sums.transfers += rank.transfers_received;
    sums.ramp_up += rank.ramp_up_seconds;
    sums.tail += rank.tail_seconds;
    sums.between += rank.idle_seconds - rank.ramp_up_seconds - rank.tail_seconds;
    sums.last_node = std::max(sums.last_node, rank.seconds - rank.tail_seconds);
    sums.end = std::max(sums.end, rank.seconds);
  }
  return sums;
}

void print_row(const BenchScalingOptions& options, int ranks) {
  const engine::Weather weather{.latency = options.latency_microseconds * micro,
                                .bandwidth = options.gigabytes_a_second * 1e9,
                                .node = options.node_microseconds * micro,
                                .handling = options.handling_microseconds * micro};
  const auto run = engine::simulate(benchmark::SizedTree(options.seed, options.nodes), ranks,
                                    options.seed, weather, {}, UINT64_MAX);
  if (run.outcome.opened() != options.nodes || run.left_behind != 0) {
    throw std::runtime_error(
        fmt::format("{} ranks: {} of {} nodes opened, {} messages not received", ranks,
                    run.outcome.opened(), options.nodes, run.left_behind));
  }
  const auto sum = sums(run.outcome);
  const double available = ranks * sum.end;
  const double work = static_cast<double>(options.nodes) * options.node_microseconds * micro;
  const auto percent = [&](double seconds) { return 100 * seconds / available; };
  const double idle = sum.ramp_up + sum.between + sum.tail;
  fmt::print(
      "{:>6} {:>10.3f} {:>12.6f} {:>12.6f} {:>8.2f} {:>8.2f} {:>8.2f} {:>9.2f} {:>9.1f} {:>9.1f} "
      "{:>10.3f}\n",
      ranks, work / available, sum.end, sum.last_node, percent(sum.ramp_up), percent(sum.between),
      percent(sum.tail), percent(available - work - idle),
      static_cast<double>(sum.transfers) / ranks,
      static_cast<double>(sum.requests - sum.transfers) / ranks, 1e3 * (run.seconds - sum.end));
  std::fflush(stdout);
}

}  // namespace

int bench_scaling(Session& session, const BenchScalingOptions& options) {
  if (session.ranks() > 1) {
    throw WrongInput(
        "kusabi bench scaling: was started on several ranks, but simulates all in one process; "
        "expected one process");
  }
  fmt::print(
      "A tree of {} nodes of {} us; latency {} us, {} us at either end; {} GB/s.\n"
      "Lost time in % of all ranks' time; transfers and refusals per rank; the reports follow the "
      "end.\n\n"
      "{:>6} {:>10} {:>12} {:>12} {:>8} {:>8} {:>8} {:>9} {:>9} {:>9} {:>10}\n",
      options.nodes, options.node_microseconds, options.latency_microseconds,
      options.handling_microseconds, options.gigabytes_a_second, "ranks", "efficiency", "seconds",
      "last node s", "ramp-up", "between", "tail", "messages", "transfers", "refusals",
      "reports ms");
  for (int ranks = options.least_ranks; ranks <= options.most_ranks; ranks *= 4) {
    print_row(options, ranks);
  }
  return solved;
}

}  // namespace kusabi::run
