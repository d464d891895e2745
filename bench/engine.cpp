// Cost of the engine without the nodes: one figure per operation.
//
// Nanoseconds of CPU time; items are nodes. MPI runs on one rank without messages, so its figures
// are the cost of polling.
#include <cstdint>
#include <utility>
#include <vector>

#include <benchmark/benchmark.h>

#include "engine/detail/nodes/heap.hpp"
#include "engine/search.hpp"
#include "engine/transport/mpi.hpp"

namespace kusabi::engine {
namespace {

// A node like those of the tree of sign patterns: a sign for each of 40 contact nodes.
struct Signs {
  std::vector<std::int8_t> signs = std::vector<std::int8_t>(40);

  template <class Archive>
  void serialize(Archive& archive, unsigned /*version*/) {
    archive& signs;
  }
};

// A node without cost.
struct Depth {
  std::uint32_t left = 0;

  template <class Archive>
  void serialize(Archive& archive, unsigned /*version*/) {
    archive& left;
  }
};

// Complete binary tree whose nodes cost nothing. Its first leaf is a solution, and no bound closes
// a node: all goals except Goal::first open all nodes.
struct EmptyTree {
  using Node = Depth;
  using Solution = Depth;

  std::uint32_t depth = 0;
  bool reported = false;

  Node root() const { return {depth}; }
  void expand(Node&& node, Expansion<EmptyTree>& out) {
    if (node.left == 0) {
      if (!std::exchange(reported, true)) out.solution(node);
      return;
    }
    out.branch({node.left - 1});
    out.branch({node.left - 1});
  }
  [[nodiscard]] double objective(const Solution& /*solution*/) const { return 1; }
  [[nodiscard]] double bound(const Node& /*node*/) const { return 0; }
};

constexpr std::uint32_t depth = 18;
constexpr std::int64_t nodes = (std::int64_t{1} << (depth + 1)) - 1;

// ---- pools --------------------------------------------------------------------------------------

// One pass through the tree, without an explorer.
void frontier_push_pop(benchmark::State& state) {
  for (auto _ : state) {
    Frontier<Depth> frontier;
    frontier.add_root({depth});
    double closed = 0;
    while (!frontier.empty()) {
      const auto node = frontier.open();
      if (node.left > 0) {
        frontier.branch({node.left - 1});
        frontier.branch({node.left - 1});
      }
      closed += frontier.close();
    }
    benchmark::DoNotOptimize(closed);
  }
  state.SetItemsProcessed(state.iterations() * nodes);
}

// Takes one node out and puts one in, with many nodes waiting.
void heap_push_pop(benchmark::State& state) {
  std::uint64_t random = 1;
  const auto bound = [&](const Depth&) {
    random = branch_hash(random, 0);
    return static_cast<double>(random % 1000);
  };
  const auto bundle = [] { return Bundle<Depth>{{TrailStep{0, 1, 1, 1}}, {{Depth{}, 1, 0}}}; };
  Heap<Depth> heap;
  for (std::int64_t i = 0; i < state.range(0); ++i) heap.put(bundle(), bound);
  for (auto _ : state) {
    benchmark::DoNotOptimize(heap.take());
    heap.put(bundle(), bound);
  }
  state.SetItemsProcessed(state.iterations());
}

// ---- sharing ------------------------------------------------------------------------------------

Frontier<Signs> frontier_of(std::int64_t size) {
  Frontier<Signs> frontier;
  frontier.add_root({});
  frontier.open();
  for (std::int64_t i = 0; i < size; ++i) frontier.branch({});
  frontier.close();
  return frontier;
}

// Work of sender and receiver for a transfer of that many nodes, without the message.
void steal(benchmark::State& state) {
  const auto full = frontier_of(2 * state.range(0));
  for (auto _ : state) {
    state.PauseTiming();
    auto giver = full;
    Frontier<Signs> taker;
    state.ResumeTiming();
    const auto body = pack(Transfer<Signs>{giver.give(std::size_t{1} << 30U)});
    auto transfer = unpack<Transfer<Signs>>(body);
    taker.take(std::move(transfer.front()));
    benchmark::DoNotOptimize(taker);
  }
  state.SetItemsProcessed(state.iterations() * state.range(0));
}

void serialise(benchmark::State& state) {
  const Transfer<Signs> transfer{frontier_of(state.range(0)).take_all()};
  for (auto _ : state) benchmark::DoNotOptimize(pack(transfer));
  state.SetItemsProcessed(state.iterations() * state.range(0));
}

void deserialise(benchmark::State& state) {
  const auto body = pack(Transfer<Signs>{frontier_of(state.range(0)).take_all()});
  for (auto _ : state) benchmark::DoNotOptimize(unpack<Transfer<Signs>>(body));
  state.SetItemsProcessed(state.iterations() * state.range(0));
}

// ---- search -------------------------------------------------------------------------------------

// @param nodes_per_step between two checks for messages; 0: adapted to the cost of a node
template <class AnyTransport>
void search_empty_tree(benchmark::State& state) {
  EmptyTree tree{depth};
  Options options;
  options.nodes_per_step = static_cast<unsigned>(state.range(0));
  AnyTransport transport;
  for (auto _ : state) benchmark::DoNotOptimize(search(tree, transport, options));
  state.SetItemsProcessed(state.iterations() * nodes);
}

// Cost per node of a search for the best solution: checking its bound.
void search_empty_tree_for_the_best(benchmark::State& state) {
  Options options;
  options.goal = Goal::best;
  for (auto _ : state) {
    EmptyTree tree{depth};
    benchmark::DoNotOptimize(search(tree, options));
  }
  state.SetItemsProcessed(state.iterations() * nodes);
}

template <class AnyTransport>
void look_for_messages(benchmark::State& state) {
  AnyTransport transport;
  for (auto _ : state) benchmark::DoNotOptimize(transport.receive());
}

template <class AnyTransport>
void look_at_the_clock(benchmark::State& state) {
  AnyTransport transport;
  for (auto _ : state) benchmark::DoNotOptimize(transport.now());
}

BENCHMARK(frontier_push_pop)->Unit(benchmark::kMillisecond);
BENCHMARK(heap_push_pop)->Arg(100)->Arg(100'000);
BENCHMARK(steal)->Arg(1)->Arg(16)->Arg(256);
BENCHMARK(serialise)->Arg(1)->Arg(16)->Arg(256);
BENCHMARK(deserialise)->Arg(1)->Arg(16)->Arg(256);
BENCHMARK_TEMPLATE(search_empty_tree, SingleProcess)
    ->ArgName("step")
    ->Arg(0)
    ->Arg(1)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_TEMPLATE(search_empty_tree, MpiTransport)
    ->ArgName("step")
    ->Arg(0)
    ->Arg(1)
    ->Unit(benchmark::kMillisecond);
BENCHMARK(search_empty_tree_for_the_best)->Unit(benchmark::kMillisecond);
BENCHMARK_TEMPLATE(look_for_messages, SingleProcess);
BENCHMARK_TEMPLATE(look_for_messages, MpiTransport);
BENCHMARK_TEMPLATE(look_at_the_clock, SingleProcess);
BENCHMARK_TEMPLATE(look_at_the_clock, MpiTransport);

}  // namespace
}  // namespace kusabi::engine

int main(int argc, char** argv) {
  const kusabi::engine::MpiEnvironment mpi(argc, argv);
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 1;
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
  return 0;
}
