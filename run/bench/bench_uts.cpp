// A plain recursion and the search by the engine, in turns of 50 ms, and tables that compare them.
//
// The recursion is an ordinary one and cannot be left in between, but the engine's worker can: at a
// node of the recursion, when its turn is over, the worker makes the steps of its turn.
#include "run/bench/bench_uts.hpp"

#include <algorithm>
#include <chrono>
#include <ctime>
#include <limits>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include <boost/serialization/vector.hpp>
#include <fmt/format.h>

#include "answer/exit_code.hpp"
#include "engine/collectives.hpp"
#include "engine/search.hpp"
#include "nodes/benchmark/standard_trees.hpp"
#include "run/bench/paired_turns.hpp"

namespace kusabi::run {
namespace {

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

}  // namespace

int bench_uts(Session& session, const BenchUtsOptions& options) {
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
  if (!session.is_first()) return right ? answer::solved : answer::failed;

  print_ranks(fastest);
  fmt::print("\n");
  print_counts(fastest.tally().counts, standard.counts);
  if (!right) fmt::print("WRONG: the counts of some round differ\n");
  fmt::print("\n");
  print_speed(least, fastest.opened(), ratios, session.ranks() == 1);
  return right ? answer::solved : answer::failed;
}

}  // namespace kusabi::run
