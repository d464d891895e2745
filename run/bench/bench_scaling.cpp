// Simulated searches, one per row, with the use of their time.
#include "run/bench/bench_scaling.hpp"

#include <algorithm>
#include <cstdio>
#include <fstream>
#include <stdexcept>
#include <string>
#include <type_traits>

#include <fmt/format.h>

#include "answer/exit_code.hpp"
#include "engine/simulation.hpp"
#include "nodes/benchmark/recorded_tree.hpp"
#include "nodes/benchmark/sized_tree.hpp"
#include "nodes/benchmark/standard_trees.hpp"

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

template <class Tree>
Sums sums(const engine::Outcome<Tree>& outcome) {
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

// A tree, the number of its nodes and the time of all together.
template <class Tree>
struct Subject {
  Tree tree;
  std::uint64_t nodes;
  double seconds;
};

template <class Tree>
void print_row(const BenchScalingOptions& options, const Subject<Tree>& subject, int ranks) {
  const engine::MachineModel machine{.latency = options.latency_microseconds * micro,
                                     .bandwidth = options.gigabytes_per_second * 1e9,
                                     .node = options.node_microseconds * micro,
                                     .handling = options.handling_microseconds * micro,
                                     .machine = options.machine,
                                     .near_latency = options.near_latency_microseconds * micro};
  const auto run = engine::simulate(subject.tree, ranks, options.seed, machine, {}, UINT64_MAX);
  if (run.outcome.opened() != subject.nodes || run.left_behind != 0) {
    throw std::runtime_error(
        fmt::format("{} ranks: {} of {} nodes opened, {} messages not received", ranks,
                    run.outcome.opened(), subject.nodes, run.left_behind));
  }
  const auto sum = sums(run.outcome);
  const double available = ranks * sum.end;
  const auto percent = [&](double seconds) { return 100 * seconds / available; };
  const double idle = sum.ramp_up + sum.between + sum.tail;
  fmt::print(
      "{:>6} {:>10.3f} {:>12.6f} {:>12.6f} {:>8.2f} {:>8.2f} {:>8.2f} {:>9.2f} {:>9.1f} {:>9.1f} "
      "{:>10.3f}\n",
      ranks, subject.seconds / available, sum.end, sum.last_node, percent(sum.ramp_up),
      percent(sum.between), percent(sum.tail), percent(available - subject.seconds - idle),
      static_cast<double>(sum.transfers) / ranks,
      static_cast<double>(sum.requests - sum.transfers) / ranks, 1e3 * (run.seconds - sum.end));
  std::fflush(stdout);
}

template <class Tree>
void print_table(const BenchScalingOptions& options, const Subject<Tree>& subject) {
  fmt::print(
      "A tree of {} nodes of {:.4g} us on average; latency {} us, {} us on machines of {}; {} us "
      "at either end; {} GB/s.\n"
      "Lost time in % of all ranks' time; transfers and refusals per rank; the reports follow the "
      "end.\n\n"
      "{:>6} {:>10} {:>12} {:>12} {:>8} {:>8} {:>8} {:>9} {:>9} {:>9} {:>10}\n",
      subject.nodes, subject.seconds / micro / static_cast<double>(subject.nodes),
      options.latency_microseconds, options.near_latency_microseconds, options.machine,
      options.handling_microseconds, options.gigabytes_per_second, "ranks", "efficiency", "seconds",
      "last node s", "ramp-up", "between", "tail", "messages", "transfers", "refusals",
      "reports ms");
  for (int ranks = options.min_ranks; ranks <= options.max_ranks; ranks *= 4) {
    print_row(options, subject, ranks);
  }
}

benchmark::RecordedTree recorded(const std::string& file) {
  std::ifstream stream(file);
  if (!stream) throw WrongInput(file + ": the file cannot be read; expected a recorded tree");
  try {
    return benchmark::RecordedTree::read(stream, file);
  } catch (const std::invalid_argument& wrong) {
    throw WrongInput(wrong.what());
  }
}

}  // namespace

int bench_scaling(Session& session, const BenchScalingOptions& options) {
  if (session.ranks() > 1) {
    throw WrongInput(
        "kusabi bench scaling: was started on several ranks, but simulates all in one process; "
        "expected one process");
  }
  const auto of_equal_nodes = [&](const auto& tree, std::uint64_t nodes) {
    const double seconds = static_cast<double>(nodes) * options.node_microseconds * micro;
    print_table(options, Subject<std::decay_t<decltype(tree)>>{tree, nodes, seconds});
  };
  if (!options.trace.empty()) {
    const auto tree = recorded(options.trace);
    if (!tree.complete())
      fmt::print("The recorded search ended early; the prediction is for the nodes it opened.\n");
    fmt::print("The longest path takes {:.6f} s: no number of ranks is faster.\n",
               tree.longest_path());
    print_table(options, Subject<benchmark::RecordedTree>{tree, tree.size(), tree.total_seconds()});
  } else if (options.tree == "sized") {
    of_equal_nodes(benchmark::SizedTree(options.seed, options.nodes), options.nodes);
  } else {
    const auto& standard = benchmark::standard_tree(options.tree);
    of_equal_nodes(benchmark::UnbalancedTree(standard.parameters), standard.counts.nodes);
  }
  return answer::solved;
}

}  // namespace kusabi::run
