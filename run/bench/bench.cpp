// `kusabi bench`: measurements and tests of the search engine. `bench uts` compares it with a plain
// recursion, in turns of 50 ms: the recursion cannot be left in between, but the worker of the engine
// can, so it makes the steps of its turn at a node of the recursion.
#include <algorithm>
#include <array>
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <ctime>
#include <exception>
#include <fstream>
#include <limits>
#include <random>
#include <stdexcept>
#include <string>
#include <thread>
#include <type_traits>
#include <utility>
#include <vector>

#include <boost/serialization/vector.hpp>
#include <fmt/format.h>

#include "engine/collectives.hpp"
#include "engine/search.hpp"
#include "engine/simulation.hpp"
#include "engine/transport/simulated.hpp"
#include "nodes/benchmark/recorded_tree.hpp"
#include "nodes/benchmark/sized_tree.hpp"
#include "nodes/benchmark/standard_trees.hpp"
#include "run/bench/paired_turns.hpp"
#include "run/command/command_run.hpp"
#include "run/command/subcommand.hpp"
#include "run/output/standard_output.hpp"
#include "run/session/session.hpp"

namespace kusabi::run {
namespace {

struct BenchScalingOptions {
  std::string trace;                       ///< file of a recorded tree; empty: none
  std::string tree = "sized";              ///< or a standard tree, if no trace is given
  std::uint64_t nodes = 100'000'000;       ///< nodes of the tree `sized`
  double node_microseconds = 10;           ///< time to open a node, unless it is recorded
  double latency_microseconds = 2;         ///< latency of a message between machines
  double near_latency_microseconds = 0.5;  ///< the same inside a machine
  int machine = 1;                         ///< ranks on one machine
  double handling_microseconds = 0.5;      ///< time per message of its sender, and of its receiver
  double gigabytes_per_second = 10;        ///< bandwidth
  int min_ranks = 1;
  int max_ranks = 65536;  ///< largest number of ranks; four times as many in each row
  std::uint64_t seed = 1;
};

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

// Runs the command. @return true: it has no reference
bool bench_scaling(Session& session, const BenchScalingOptions& options) {
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
  return true;
}

struct BenchSchedulesOptions {
  std::uint64_t seeds = 10'000;  ///< number of schedules, divided among the ranks under mpirun
  std::uint64_t first_seed = 1;
};

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

// Simulates one search per seed, with machine, tree and goal drawn from the seed, and compares it
// with the search on one rank.
// @return false if any search differs, with one line each
bool bench_schedules(Session& session, const BenchSchedulesOptions& options) {
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
  return failed_seeds == 0;
}

struct BenchUtsOptions {
  std::string tree = "T1";  ///< name of a tree in benchmark::standard_trees
  unsigned work = 1;        ///< hashes per node, about 0.1 microseconds each
  unsigned rounds = 5;      ///< number of recursions and searches over the whole tree
};

using benchmark::TreeCounts;
using benchmark::UnbalancedTree;

constexpr std::chrono::milliseconds turn_length{50};
// Of each half of a pair; a turn in which other processes have the core has less.
constexpr double least_seconds_of_half = 0.5 * std::chrono::duration<double>(turn_length).count();

// CPU time of this process since its start.
double cpu_seconds() {
  return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

// True in every other turn of the clock. All ranks of a machine have the same turns, so that a rank
// that requests nodes does not wait for one in its recursion.
bool is_turn_of_search() {
  const auto now = std::chrono::system_clock::now().time_since_epoch();
  return now / turn_length % 2 == 0;
}

// Statistics of one rank.
struct Part {
  TreeCounts counts;
  double search_seconds = 0;
  std::vector<double> ratios;

  Part& operator+=(const Part& other) {
    counts += other.counts;
    search_seconds += other.search_seconds;
    ratios.insert(ratios.end(), other.ratios.begin(), other.ratios.end());
    return *this;
  }

  template <class Archive>
  void serialize(Archive& archive, unsigned /*version*/) {
    archive& counts& search_seconds& ratios;
  }
};

// The tree, with the CPU times of its turns. The engine reads the tally during the last one.
class TimedTree : public UnbalancedTree {
 public:
  using Tally = Part;
  using UnbalancedTree::UnbalancedTree;

  void add_recursion(const Turn& turn) { turns_.add_recursion(turn); }

  void begin_search_turn() {
    searching_ = true;
    before_ = {cpu_seconds(), UnbalancedTree::tally().nodes};
  }

  void end_search_turn() {
    turns_.add_search(current());
    searching_ = false;
  }

  [[nodiscard]] Tally tally() const {
    auto turns = turns_;
    if (searching_) turns.add_search(current());
    return {UnbalancedTree::tally(), turns.search_seconds(), turns.ratios()};
  }

 private:
  // The work since the begin of the turn.
  [[nodiscard]] Turn current() const {
    return {cpu_seconds() - before_.seconds, UnbalancedTree::tally().nodes - before_.nodes};
  }

  PairedTurns turns_{least_seconds_of_half};
  bool searching_ = false;
  Turn before_;
};

// One recursion over the whole tree and one search, in turn.
class Round {
 public:
  Round(TimedTree& tree, engine::Transport& transport, unsigned work)
      : tree_(tree),
        worker_(tree, transport, options_),
        nodes_between_looks_(std::max(256U / work, 1U)) {}

  /// @return the counts of the recursion
  TreeCounts run() {
    begin_recursion_turn();
    visit(tree_.root());
    end_recursion_turn();
    tree_.begin_search_turn();
    while (!searched_) step();
    tree_.end_search_turn();
    return seen_;
  }

  engine::Outcome<TimedTree> outcome() && { return std::move(worker_).outcome(); }

 private:
  // Plain recursion, as a program without an engine has it, that looks at the clock now and then.
  void visit(const UnbalancedTree::Node& node) {
    const auto children = tree_.children(node);
    seen_ += {1, children == 0 ? 1U : 0U, node.depth};
    if (--nodes_before_look_ == 0) look();
    for (std::uint32_t number = 0; number < children; ++number) {
      visit(tree_.child(node, number));
    }
  }

  void look() {
    nodes_before_look_ = nodes_between_looks_;
    if (searched_ || !is_turn_of_search()) return;
    end_recursion_turn();
    tree_.begin_search_turn();
    while (!searched_ && is_turn_of_search()) step();
    tree_.end_search_turn();
    begin_recursion_turn();
  }

  void begin_recursion_turn() { before_ = {cpu_seconds(), seen_.nodes}; }
  void end_recursion_turn() {
    tree_.add_recursion({cpu_seconds() - before_.seconds, seen_.nodes - before_.nodes});
  }

  void step() {
    const auto pace = worker_.step();
    searched_ = pace.state == engine::Pace::State::done;
    // As engine::search waits between the steps of a rank without nodes.
    if (pace.sleeps()) {
      std::this_thread::sleep_for(std::chrono::duration<double>(pace.wait));
    } else if (pace.state == engine::Pace::State::waiting) {
      std::this_thread::yield();
    }
  }

  TimedTree& tree_;
  const engine::Options options_;
  engine::Worker<TimedTree> worker_;
  const unsigned nodes_between_looks_;  // some 25 microseconds
  unsigned nodes_before_look_ = 1;
  bool searched_ = false;
  TreeCounts seen_;
  Turn before_;
};

void print_ranks(const engine::Outcome<TimedTree>& outcome) {
  fmt::print("{:<6} {:>12} {:>7} {:>9} {:>9} {:>12}\n", "rank", "opened", "share", "requests",
             "transfers", "CPU seconds");
  const auto row = [&](const std::string& name, std::uint64_t opened, std::uint64_t requests,
                       std::uint64_t transfers, double seconds) {
    const double share = 100 * static_cast<double>(opened) / static_cast<double>(outcome.opened());
    fmt::print("{:<6} {:>12} {:>5.1f} % {:>9} {:>9} {:>12.3f}\n", name, opened, share, requests,
               transfers, seconds);
  };
  std::uint64_t requests = 0;
  std::uint64_t transfers = 0;
  double seconds = 0;
  for (std::size_t rank = 0; rank < outcome.ranks.size(); ++rank) {
    const auto& [statistics, part] = outcome.ranks[rank];
    row(std::to_string(rank), statistics.opened, statistics.requests, statistics.transfers_received,
        part.search_seconds);
    requests += statistics.requests;
    transfers += statistics.transfers_received;
    seconds += part.search_seconds;
  }
  if (outcome.ranks.size() > 1) row("all", outcome.opened(), requests, transfers, seconds);
}

void print_counts(const TreeCounts& counted, const TreeCounts& published) {
  const auto line = [](const char* name, std::uint64_t count, std::uint64_t expected) {
    fmt::print("{:<8} {:>14}   {}\n", name, count,
               count == expected ? "as published" : fmt::format("WRONG: not {}", expected));
  };
  line("nodes", counted.nodes, published.nodes);
  line("leaves", counted.leaves, published.leaves);
  line("depth", counted.depth, published.depth);
}

void print_speed(double seconds, std::uint64_t opened, const std::vector<double>& ratios,
                 bool alone) {
  fmt::print("{:<10} {:>12.3f} CPU seconds, {:.3f} million nodes per CPU second\n", "search",
             seconds, static_cast<double>(opened) / 1e6 / seconds);
  if (ratios.empty()) {
    fmt::print("{:<10} {:>12} the tree is too small\n", "efficiency", "-");
    return;
  }
  const auto [lower, median, upper] = quartiles(ratios);
  fmt::print("{:<10} {:>12.3f} (median; quartiles {:.3f} and {:.3f}; pairs of turns: {})\n",
             "efficiency", median, lower, upper, ratios.size());
  fmt::print("It is the CPU time of a node in a recursion divided by that in the search{}.\n",
             alone ? "" : "; each rank compares its own turns");
}

// Runs the command on all ranks.
// @return false if the counts are not the published ones
// @throws std::out_of_range if there is no tree of that name
bool bench_uts(Session& session, const BenchUtsOptions& options) {
  const auto& standard = benchmark::standard_tree(options.tree);
  bool right = true;
  double least = std::numeric_limits<double>::infinity();
  engine::Outcome<TimedTree> fastest;
  std::vector<double> ratios;
  for (unsigned number = 0; number < options.rounds; ++number) {
    TimedTree tree(standard.parameters, options.work);
    engine::all_reduce(session.transport());  // the ranks begin together
    Round round(tree, session.transport(), options.work);
    right &= round.run() == standard.counts;
    auto outcome = std::move(round).outcome();
    if (!session.is_first()) continue;
    const auto all = outcome.tally();
    right &= all.counts == standard.counts;
    ratios.insert(ratios.end(), all.ratios.begin(), all.ratios.end());
    if (all.search_seconds < least) {
      least = all.search_seconds;
      fastest = std::move(outcome);
    }
  }
  if (!session.is_first()) return right;

  print_ranks(fastest);
  fmt::print("\n");
  print_counts(fastest.tally().counts, standard.counts);
  if (!right) fmt::print("WRONG: the counts of some round differ\n");
  fmt::print("\n");
  print_speed(least, fastest.opened(), ratios, session.ranks() == 1);
  return right;
}

// A measurement reads no files and prints as it runs.
class Bench : public Subcommand {
 public:
  void search(CommandRun& run) final {
    const bool good = measure(run.session());
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
  /// @return true if this rank agrees with the reference
  virtual bool measure(Session& session) = 0;

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
  bool measure(Session& session) override { return bench_scaling(session, options_); }
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
  bool measure(Session& session) override { return bench_schedules(session, options_); }
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
  bool measure(Session& session) override { return bench_uts(session, options_); }
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
