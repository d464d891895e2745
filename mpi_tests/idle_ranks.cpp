// Cost and latency of idle ranks. Rank 0 works alone, two seconds of CPU time on a chain that
// cannot be shared, and then has many nodes to give. Until then the CPU time of the other ranks,
// whose requests fail, must be a small part of that of rank 0. (The comparison is not with wall
// time: on a loaded machine a spinning rank gets little CPU time as well.)
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <limits>
#include <vector>

#include <mpi.h>
#include <sys/resource.h>

#include "engine/search.hpp"
#include "engine/transport/mpi.hpp"

namespace {

using kusabi::engine::Expansion;

// CPU time, which does not depend on the load of the machine.
double cpu_seconds() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  const auto seconds = [](const timeval& time) {
    return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
  };
  return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

double wall_seconds() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

void work(double seconds) {
  const double end = cpu_seconds() + seconds;
  while (cpu_seconds() < end) {
  }
}

// A chain of 2000 nodes of a millisecond; its last node has 400 children of a tenth of a
// millisecond.
class ChainThenBush {
 public:
  using Node = int;
  using Solution = int;

  static constexpr int length = 2000;
  static constexpr double never = std::numeric_limits<double>::infinity();

  // Wall and CPU time of this rank at the end of the chain (rank 0) or at its first node (the
  // others). Ranks of one machine share one clock.
  double first_seen = never;
  double first_seen_cpu = never;

  Node root() const { return 0; }

  void expand(Node&& node, Expansion<ChainThenBush>& out) {
    if (node < length) {
      work(1e-3);
      out.branch(node + 1);
    } else if (node == length) {
      note();
      for (int child = 0; child < 400; ++child) out.branch(length + 1);
    } else {
      note();
      work(1e-4);
    }
  }

 private:
  void note() {
    if (first_seen < never) return;
    first_seen = wall_seconds();
    first_seen_cpu = cpu_seconds();
  }
};

}  // namespace

int main(int argc, char** argv) {
  const kusabi::engine::MpiEnvironment mpi(argc, argv);
  kusabi::engine::MpiTransport transport;
  ChainThenBush tree;
  MPI_Barrier(MPI_COMM_WORLD);
  const double start = wall_seconds();
  const double start_cpu = cpu_seconds();
  const auto outcome = kusabi::engine::search(tree, transport);
  // A rank that got no node was idle to the end.
  const double idle_until = std::min(tree.first_seen, wall_seconds());
  const double idle_until_cpu = std::min(tree.first_seen_cpu, cpu_seconds());

  const double own[]{idle_until, idle_until - start, idle_until_cpu - start_cpu,
                     static_cast<double>(outcome.ranks.front().statistics.requests)};
  constexpr int figures = 4;
  const auto ranks = static_cast<std::size_t>(transport.size());
  std::vector<double> all(figures * ranks);
  MPI_Gather(static_cast<const double*>(own), figures, MPI_DOUBLE, all.data(), figures, MPI_DOUBLE,
             0, MPI_COMM_WORLD);
  if (transport.rank() != 0) return 0;

  // About 2 to 5 % is usual; a spinning rank uses as much as a working one.
  constexpr double maximum = 0.20;
  bool good = true;
  for (std::size_t rank = 1; rank < ranks; ++rank) {
    const double* const its = all.data() + figures * rank;
    const double share = its[2] / all[2];
    std::printf(
        "rank %zu: idle for %.2f s, of which %.3f s on a core (%.1f %% of rank 0's), %.0f "
        "requests; "
        "awake %.2f ms after the first node to share\n",
        rank, its[1], its[2], 100 * share, its[3], 1e3 * (its[0] - all[0]));
    good = good && all[2] > 1.9 && share < maximum;
  }
  return good ? 0 : 1;
}
