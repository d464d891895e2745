// Tests of the search over MPI: equal answers on any number of ranks, and a fair share for each.
#include <chrono>
#include <cstdio>

#include <boost/serialization/vector.hpp>
#include <gtest/gtest.h>
#include <mpi.h>

#include "engine/search.hpp"
#include "engine/transport/mpi.hpp"
#include "tests/engine/queens.hpp"
#include "tests/engine/random_tree.hpp"
#include "tests/support/thorough.hpp"

namespace kusabi::engine {
namespace {

using examples::Queens;
using examples::RandomTree;
using test::thorough;

TEST(MpiSearch, OutcomeIsThatOfOneProcess) {
  MpiTransport transport;
  Queens queens(8);
  const auto together = search(queens, transport);
  if (transport.rank() != 0) return;
  Queens again(8);
  const auto alone = search(again);
  EXPECT_EQ(together.ranks.size(), static_cast<std::size_t>(transport.size()));
  EXPECT_EQ(together.fingerprint(), alone.fingerprint());
  EXPECT_EQ(together.opened(), alone.opened());
  ASSERT_EQ(together.solutions.size(), 92U);
  for (std::size_t i = 0; i < 92; ++i) {
    EXPECT_EQ(together.solutions[i].solution.columns, alone.solutions[i].solution.columns);
  }
}

TEST(MpiSearch, GathersManySolutionsInOrder) {
  MpiTransport transport;
  RandomTree tree(1, 24);
  const auto together = search(tree, transport);
  if (transport.rank() != 0) return;
  RandomTree again(1, 24);
  const auto alone = search(again);
  ASSERT_EQ(together.solutions.size(), alone.solutions.size());
  for (std::size_t i = 0; i < alone.solutions.size(); ++i) {
    ASSERT_EQ(together.solutions[i].solution, alone.solutions[i].solution);
  }
  EXPECT_EQ(together.fingerprint(), alone.fingerprint());
  EXPECT_EQ(together.tally(), alone.ranks[0].tally);
}

TEST(MpiSearch, OneSearchAfterAnotherOnTheSameTransport) {
  MpiTransport transport;
  for (int round = 0; round < (thorough ? 50 : 10); ++round) {
    Queens queens(4 + round % 3);
    const auto outcome = search(queens, transport);
    if (transport.rank() != 0) continue;
    constexpr std::size_t known[]{2, 10, 4};
    EXPECT_EQ(outcome.solutions.size(), known[round % 3]);
  }
}

// Nodes and solutions of 40 kB each: every message uses the rendezvous protocol.
struct Heavy {
  struct Node {
    int depth = 0;
    std::vector<double> load;
    template <class Archive>
    void serialize(Archive& archive, unsigned /*version*/) {
      archive& depth& load;
    }
  };
  using Solution = std::vector<double>;
  Node root() const { return {0, std::vector<double>(5000, 0.5)}; }
  void expand(Node&& node, Expansion<Heavy>& out) {
    if (node.depth == 8) {
      out.solution(std::move(node.load));
      return;
    }
    ++node.depth;
    out.branch(node);
    out.branch(std::move(node));
  }
};

TEST(MpiSearch, MessagesAboveTheEagerLimitArrive) {
  MpiTransport transport;
  Heavy heavy;
  const auto outcome = search(heavy, transport);
  if (transport.rank() != 0) return;
  ASSERT_EQ(outcome.solutions.size(), 256U);
  for (const auto& found : outcome.solutions) {
    ASSERT_EQ(found.solution, std::vector<double>(5000, 0.5));
  }
}

TEST(MpiSearch, AnswersRequestsWhenALongExpansionPolls) {
  // Every node takes several steps' time; with `poll` requests are answered during an expansion.
  struct Polling {
    using Node = int;
    using Solution = int;
    Node root() const { return 10; }
    void expand(Node&& node, Expansion<Polling>& out) {
      if (node == 0) return out.solution(node);
      out.branch(node - 1);
      for (int i = 0; i < 20; ++i) out.poll();
      out.branch(node - 1);
    }
  };
  MpiTransport transport;
  Polling polling;
  const auto outcome = search(polling, transport);
  if (transport.rank() != 0) return;
  EXPECT_EQ(outcome.solutions.size(), 1024U);
}

// All ranks step in lock-step, so that the shares do not depend on the clock of the machine.
TEST(MpiSearch, EveryRankOpensAFairShareInLockStep) {
  class LockStep final : public Transport {
   public:
    [[nodiscard]] int rank() const override { return wires_.rank(); }
    [[nodiscard]] int size() const override { return wires_.size(); }
    [[nodiscard]] double now() const override { return 20e-6 * static_cast<double>(round_); }
    void send(int to, MessageTag tag, Bytes body) override {
      wires_.send(to, tag, std::move(body));
    }
    std::optional<Message> receive() override { return wires_.receive(); }
    void join_reduction(const Reduction& own) override { wires_.join_reduction(own); }
    std::optional<Reduction> reduction() override { return wires_.reduction(); }
    void broadcast(Bytes& bytes) override { wires_.broadcast(bytes); }
    void abandon(const std::string& reason) override { wires_.abandon(reason); }

    /// True if all ranks are done.
    bool next_round(bool done) {
      ++round_;
      int all_done = done ? 1 : 0;
      MPI_Allreduce(MPI_IN_PLACE, &all_done, 1, MPI_INT, MPI_MIN, MPI_COMM_WORLD);
      return all_done != 0;
    }

   private:
    MpiTransport wires_;
    std::uint64_t round_ = 0;
  };

  LockStep transport;
  RandomTree tree(1, 20);
  Options options;
  options.nodes_per_step = 16;
  Worker<RandomTree> worker(tree, transport, options);
  for (bool done = false; !transport.next_round(done);) {
    done = worker.step().state == Pace::State::done;
  }
  const auto outcome = std::move(worker).outcome();
  if (transport.rank() != 0) return;
  const auto opened = outcome.opened();
  ASSERT_GT(opened, 10'000U);
  RandomTree again(1, 20);
  EXPECT_EQ(outcome.fingerprint(), search(again).fingerprint());
  for (const auto& rank : outcome.ranks) {
    const double share = static_cast<double>(rank.statistics.opened) / static_cast<double>(opened);
    std::printf("share of %.1f %% of %llu nodes, %llu requests, %llu transfers received\n",
                100 * share, static_cast<unsigned long long>(opened),
                static_cast<unsigned long long>(rank.statistics.requests),
                static_cast<unsigned long long>(rank.statistics.transfers_received));
    EXPECT_GE(share, 0.5 / static_cast<double>(transport.size()));  // 25 % each on two ranks
  }
}

}  // namespace
}  // namespace kusabi::engine
