// `kusabi bench`: measurements and tests of the search engine, each in a file of its own; options.
#include <string>
#include <utility>
#include <vector>

#include "answer/exit_code.hpp"
#include "engine/collectives.hpp"
#include "nodes/benchmark/standard_trees.hpp"
#include "run/bench/bench_scaling.hpp"
#include "run/bench/bench_schedules.hpp"
#include "run/bench/bench_uts.hpp"
#include "run/command/command_run.hpp"
#include "run/command/registrations.hpp"
#include "run/output/standard_output.hpp"

namespace kusabi::run {
namespace {

// A measurement reads no files and prints as it runs.
class Bench : public Subcommand {
 public:
  void search(CommandRun& run) final {
    const bool good = measure(run.session()) == answer::solved;
    // A reduction adds: the number of ranks on which a measurement failed.
    const auto all =
        engine::all_reduce(run.session().transport(), {.ranks = 1, .found = good ? 0U : 1U});
    agrees_ = all.found == 0;
  }
  std::vector<Step> results(CommandRun& /*run*/) final { return {flush_standard_output}; }
  [[nodiscard]] answer::Verdict verdict() const final {
    return {.answer = answer::Measurement{.agrees = agrees_}};
  }

 protected:
  /// @return the exit code of this rank
  virtual int measure(Session& session) = 0;

 private:
  bool agrees_ = true;
};

// Names of the standard trees, as values of an option.
std::vector<std::pair<std::string, std::string>> standard_names() {
  std::vector<std::pair<std::string, std::string>> names;
  for (const auto& tree : benchmark::standard_trees()) names.emplace_back(tree.name, tree.name);
  return names;
}

class Scaling final : public Bench {
 public:
  void describe(OptionTable& table) override {
    table.file(
        "--trace", options_.trace, Role::input,
        "recorded tree, by option --record of kusabi patterns or of a program of engine::run");
    auto trees = standard_names();
    trees.insert(trees.begin(), {"sized", "sized"});
    table.choice("--tree", options_.tree, trees,
                 "random tree of --nodes nodes, or a standard tree of kusabi bench uts");
    table.number("--nodes", &options_.nodes, above(0), "number of nodes of the random tree");
    table
        .number("--node-us", &options_.node_microseconds, above(0),
                "time to open a node, unless it is recorded")
        .unit("us");
    table
        .number("--latency-us", &options_.latency_microseconds, above(0),
                "latency of a message between machines")
        .unit("us");
    table.number("--machine", &options_.machine, above(0), "ranks on one machine");
    table
        .number("--near-us", &options_.near_latency_microseconds, above(0),
                "latency of a message inside a machine")
        .unit("us");
    table
        .number("--handling-us", &options_.handling_microseconds, above(0),
                "time that the sender, and also the receiver, spends on a message")
        .unit("us");
    table
        .number("--bandwidth", &options_.gigabytes_per_second, above(0), "bandwidth of the network")
        .unit("GB/s");
    table.number("--least-ranks", &options_.min_ranks, above(0),
                 "number of ranks of the first row");
    table.number("--most-ranks", &options_.max_ranks, above(0),
                 "largest number of ranks; each row has four times as many as the one before");
    table.number("--seed", &options_.seed, above(0), "random seed of the tree and of the schedule");
  }

 private:
  int measure(Session& session) override { return bench_scaling(session, options_); }
  BenchScalingOptions options_;
};

class Schedules final : public Bench {
 public:
  void describe(OptionTable& table) override {
    table.number("--seeds", &options_.seeds, above(0), "number of schedules");
    table.number("--first-seed", &options_.first_seed, at_least(0),
                 "random seed of the first schedule");
  }

 private:
  int measure(Session& session) override { return bench_schedules(session, options_); }
  BenchSchedulesOptions options_;
};

class Uts final : public Bench {
 public:
  void describe(OptionTable& table) override {
    constexpr double nodes_in_a_second = 1e7;
    constexpr double max_rounds = 1000;
    table.choice("--tree", options_.tree, standard_names(), "name of the standard tree");
    table.number("--work", &options_.work, between(1, nodes_in_a_second),
                 "number of hashes per node, about 0.1 microseconds each");
    table.number(
        "--rounds", &options_.rounds, between(1, max_rounds),
        "number of rounds, each of a recursion and a search of the whole tree in turns of 50 ms");
    table.serial();
  }

 private:
  int measure(Session& session) override { return bench_uts(session, options_); }
  BenchUtsOptions options_;
};

}  // namespace

constexpr Registration bench_scaling_subcommand{
    {.name = "bench scaling",
     .chapter = "Measurements of the search engine",
     .purpose = "simulated scaling of the search",
     .description =
         "The parallel efficiency of the search on up to 65536 ranks, simulated in virtual time.",
     .example = "--nodes 262144 --most-ranks 64"},
    make<Scaling>};

constexpr Registration bench_schedules_subcommand{
    {.name = "bench schedules",
     .chapter = "Measurements of the search engine",
     .purpose = "search results under random schedules of messages",
     .description =
         "Simulates searches under random schedules of messages and compares the results with "
         "those of one rank.",
     .example = "--seeds 1000"},
    make<Schedules>};

constexpr Registration bench_uts_subcommand{
    {.name = "bench uts",
     .chapter = "Measurements of the search engine",
     .purpose = "Unbalanced Tree Search benchmark",
     .description =
         "The Unbalanced Tree Search benchmark: comparison with the published numbers of nodes, "
         "and of the CPU time of a node with that of a plain recursion.",
     .example = "--tree T1"},
    make<Uts>};

}  // namespace kusabi::run
