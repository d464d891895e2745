// Plain recursion, search by the engine, and tables that compare them. Costs are CPU times, the
// minimum over some rounds, since wall-clock times depend on other load of the machine.
#include "run/bench/bench_uts.hpp"

#include <algorithm>
#include <ctime>
#include <limits>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "engine/collectives.hpp"
#include "engine/search.hpp"
#include "nodes/benchmark/standard_trees.hpp"
#include "run/output/exit_code.hpp"

namespace kusabi::run {
namespace {

using benchmark::TreeCounts;
using benchmark::UnbalancedTree;

constexpr double infinity = std::numeric_limits<double>::infinity();

// CPU time of this process since its start.
double cpu_seconds() {
  return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

// Plain recursion, as a program without an engine has it.
void visit(const UnbalancedTree& tree, const UnbalancedTree::Node& node, TreeCounts& seen) {
  const auto children = tree.children(node);
  seen += {1, children == 0 ? 1U : 0U, node.depth};
  for (std::uint32_t number = 0; number < children; ++number) {
    visit(tree, tree.child(node, number), seen);
  }
}

// Statistics of one rank and its CPU time.
struct Part {
  TreeCounts counts;
  double recursion_seconds = 0;  // of one recursion over the whole tree
  double search_seconds = 0;

  Part& operator+=(const Part& other) {
    counts += other.counts;
    recursion_seconds += other.recursion_seconds;
    search_seconds += other.search_seconds;
    return *this;
  }

  template <class Archive>
  void serialize(Archive& archive, unsigned /*version*/) {
    archive& counts& recursion_seconds& search_seconds;
  }
};

// The tree; its tally records CPU times when the engine reads it at the end of the search.
class TimedTree : public UnbalancedTree {
 public:
  using Tally = Part;
  using UnbalancedTree::UnbalancedTree;

  /// Walks the whole tree without the engine. @return its counts
  TreeCounts recur() {
    TreeCounts seen;
    const double start = cpu_seconds();
    visit(*this, root(), seen);
    recursion_seconds_ = cpu_seconds() - start;
    return seen;
  }

  void start() { start_ = cpu_seconds(); }

  [[nodiscard]] Tally tally() const {
    return {UnbalancedTree::tally(), recursion_seconds_, cpu_seconds() - start_};
  }

 private:
  double recursion_seconds_ = 0;
  double start_ = 0;
};

// The search alone: the ranks begin together, after all recursions.
engine::Outcome<TimedTree> search(Session& session, TimedTree& tree) {
  engine::all_reduce(session.transport());
  tree.start();
  return engine::search(tree, session.transport());
}

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

// CPU seconds of one round over all ranks: the mean recursion of a rank, and the whole search.
struct Times {
  double recursion = 0;
  double search = 0;
};

Times times_of(const engine::Outcome<TimedTree>& outcome) {
  const auto all = outcome.tally();
  return {all.recursion_seconds / static_cast<double>(outcome.ranks.size()), all.search_seconds};
}

void print_times(const Times& times, std::uint64_t opened) {
  const auto line = [&](const char* name, double seconds) {
    fmt::print("{:<10} {:>12.3f} CPU seconds {:>10.3f} million nodes per CPU second\n", name,
               seconds, static_cast<double>(opened) / 1e6 / seconds);
  };
  line("recursion", times.recursion);
  line("search", times.search);
  fmt::print("{:<10} {:>12.3f}\n", "efficiency", times.recursion / times.search);
}

}  // namespace

int bench_uts(Session& session, const BenchUtsOptions& options) {
  const auto& standard = benchmark::standard_tree(options.tree);
  bool right = true;
  Times minimum{infinity, infinity};
  engine::Outcome<TimedTree> fastest;
  for (unsigned round = 0; round < options.rounds; ++round) {
    TimedTree tree(standard.parameters, options.work);
    // Every rank recurs over the whole tree at the same time, so that the reference time is
    // measured on the cores of the search and under its load.
    right &= tree.recur() == standard.counts;
    auto outcome = search(session, tree);
    if (!session.is_first()) continue;
    right &= outcome.tally().counts == standard.counts;
    const auto times = times_of(outcome);
    minimum.recursion = std::min(minimum.recursion, times.recursion);
    if (times.search < minimum.search) {
      minimum.search = times.search;
      fastest = std::move(outcome);
    }
  }
  if (!session.is_first()) return right ? solved : failed;

  print_ranks(fastest);
  fmt::print("\n");
  print_counts(fastest.tally().counts, standard.counts);
  if (!right) fmt::print("WRONG: the counts of some round differ\n");
  fmt::print("\n");
  print_times(minimum, fastest.opened());
  return right ? solved : failed;
}

}  // namespace kusabi::run
