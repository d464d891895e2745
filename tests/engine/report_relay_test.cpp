// ReportRelay tests: every piece reaches rank 0 once, in messages of bounded size.
#include "engine/detail/protocol/report_relay.hpp"

#include <deque>
#include <map>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "engine/detail/contract.hpp"

namespace kusabi::engine {
namespace {

// All reports of `ranks` ranks, whose messages arrive in the order in which they were sent.
struct Tree {
  Tree(int ranks, std::size_t limit) {
    for (int rank = 0; rank < ranks; ++rank) {
      relays.emplace_back(rank, ranks, limit, [this, rank](int parent, Bytes message) {
        messages.emplace_back(parent, std::move(message));
        if (parent == 0) ++senders_to_root[rank];
      });
    }
  }

  void deliver_all() {
    for (; !messages.empty(); messages.pop_front()) {
      const auto& [to, message] = messages.front();
      relays[static_cast<std::size_t>(to)].relay(message, [this](ReportPart&& part) {
        arrived[{part.rank, part.body.size()}]++;
      });
    }
  }

  std::deque<ReportRelay> relays;
  std::deque<std::pair<int, Bytes>> messages;
  std::map<int, int> senders_to_root;
  std::map<std::pair<int, std::size_t>, int> arrived;
};

TEST(ReportRelay, BringsEachPieceToRank0Once) {
  for (const int ranks : {1, 2, 17, 18, 300}) {
    for (const std::size_t limit : {std::size_t{1}, std::size_t{64} * 1024}) {
      SCOPED_TRACE(ranks);
      Tree tree(ranks, limit);
      for (int rank = ranks - 1; rank >= 0; --rank) {
        auto& relay = tree.relays[static_cast<std::size_t>(rank)];
        EXPECT_FALSE(relay.complete());
        for (std::size_t piece = 1; rank > 0 && piece <= 3; ++piece) {
          relay.put({rank, {}, Bytes(piece, 'x')});
        }
        relay.finish_own();
      }
      tree.deliver_all();
      for (const auto& relay : tree.relays) EXPECT_TRUE(relay.complete());
      EXPECT_EQ(tree.arrived.size(), 3U * static_cast<std::size_t>(ranks - 1));
      for (const auto& [piece, count] : tree.arrived) EXPECT_EQ(count, 1) << "of " << piece.first;
      EXPECT_LE(tree.senders_to_root.size(), 16U);
    }
  }
}

TEST(ReportRelay, IsCompleteOnlyAfterAllRanksBelowIt) {
  Tree tree(3, 1000);
  tree.relays[0].finish_own();
  EXPECT_FALSE(tree.relays[0].complete());
  tree.relays[1].finish_own();
  tree.deliver_all();
  EXPECT_FALSE(tree.relays[0].complete());
  tree.relays[2].finish_own();
  tree.deliver_all();
  EXPECT_TRUE(tree.relays[0].complete());
  EXPECT_THROW(tree.relays[0].finish_own(), ContractBroken);
}

}  // namespace
}  // namespace kusabi::engine
