// Tests of the transport over MPI and of its collective operations.
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include <boost/serialization/string.hpp>
#include <boost/serialization/vector.hpp>
#include <gtest/gtest.h>
#include <mpi.h>

#include "engine/analysis/shared_work.hpp"
#include "engine/collectives.hpp"
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

Message awaited(Transport& transport) {
  for (;;) {
    if (auto message = transport.receive()) return *std::move(message);
  }
}

// While a rank waits for reports, others may have begun the next search. Their messages would be
// missing in that search, which would never end.
TEST(MpiTransport, AMessageOfTheNextSearchIsReceivedInThatSearch) {
  MpiTransport transport;
  if (transport.size() == 1) return;
  transport.begin_search();
  if (transport.rank() == 1) {
    transport.send(0, MessageTag::report, {});
    transport.begin_search();
    transport.send(0, MessageTag::incumbent, {});
  }
  MPI_Barrier(MPI_COMM_WORLD);
  if (transport.rank() != 0) return;
  EXPECT_EQ(awaited(transport).tag, MessageTag::report);
  ASSERT_FALSE(transport.receive().has_value());
  transport.begin_search();
  EXPECT_EQ(awaited(transport).tag, MessageTag::incumbent);
}

}  // namespace
}  // namespace kusabi::engine
