// Tests of the collective operations over MPI.
#include <cstdint>
#include <string>
#include <vector>

#include <boost/serialization/string.hpp>
#include <boost/serialization/vector.hpp>
#include <gtest/gtest.h>

#include "engine/analysis/shared_work.hpp"
#include "engine/collectives.hpp"
#include "engine/search.hpp"
#include "engine/transport/mpi.hpp"

namespace kusabi::engine {
namespace {

TEST(MpiCollectives, BroadcastsTheValueOfTheFirstRank) {
  MpiTransport transport;
  const auto received = from_first_rank(transport, [&] {
    EXPECT_EQ(transport.rank(), 0);
    return std::vector<std::string>{"one", "", "three"};
  });
  EXPECT_EQ(received, (std::vector<std::string>{"one", "", "three"}));
}

TEST(MpiCollectives, AReductionAddsTheContributions) {
  MpiTransport transport;
  const auto ranks = static_cast<std::uint64_t>(transport.size());
  const auto own = static_cast<std::uint64_t>(transport.rank());
  const auto all = all_reduce(transport, {.ranks = 1, .found = own});
  EXPECT_EQ(all.ranks, ranks);
  EXPECT_EQ(all.found, ranks * (ranks - 1) / 2);
}

TEST(MpiCollectives, AMismatchIsThrownOnEveryRank) {
  MpiTransport transport;
  EXPECT_NO_THROW(require_equal_on_all_ranks(transport, 7));
  const bool last = transport.rank() == transport.size() - 1;
  if (transport.size() == 1) return;
  EXPECT_THROW(require_equal_on_all_ranks(transport, last ? 8 : 7), RankMismatch);
}

TEST(MpiCollectives, EveryRankGetsAllResultsInOrder) {
  MpiTransport transport;
  constexpr std::uint64_t pieces = 1000;
  const auto results = share_work<std::uint64_t>(
      transport, pieces, [](std::uint64_t number) { return number * number; });
  ASSERT_EQ(results.size(), pieces);
  for (std::uint64_t i = 0; i < pieces; ++i) ASSERT_EQ(results[i], i * i);
}

// Tree whose root is a solution: rank 0 broadcasts an incumbent at its first step.
struct AtOnce {
  using Node = int;  ///< depth
  using Solution = int;

  int root() const { return 0; }
  void expand(int&& depth, Expansion<AtOnce>& out) {
    out.solution(-depth);
    for (int child = 0; child < 2 && depth < 3; ++child) out.branch(depth + 1);
  }
  double objective(int solution) const { return solution; }
  double bound(int /*node*/) const { return -3; }
};

// A rank that has sent its report must not receive messages of the next search from another rank
// that is ahead: the messages would be missing in that search, which would never end.
TEST(MpiCollectives, SearchesOneAfterAnotherDoNotMixTheirMessages) {
  MpiTransport transport;
  Options options;
  options.goal = Goal::best;
  for (int search = 0; search < 200; ++search) {
    AtOnce problem;
    const auto outcome = engine::search(problem, transport, options);
    if (transport.rank() != 0) continue;
    EXPECT_TRUE(outcome.solutions.size() == 1 && outcome.solutions.front().solution == -3);
  }
}

}  // namespace
}  // namespace kusabi::engine
