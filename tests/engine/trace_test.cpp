// Trace tests: completeness, a common time axis, and the limit of events.
#include "engine/trace.hpp"

#include <map>
#include <string>
#include <tuple>
#include <utility>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "engine/simulation.hpp"
#include "tests/engine/random_tree.hpp"

namespace kusabi::engine {
namespace {

using examples::RandomTree;
using Kind = TraceEvent::Kind;

Simulated<RandomTree> traced(int ranks, std::uint64_t seed, std::size_t events) {
  Options options;
  options.trace_events = events;
  options.message_bytes = 1000;  // about thirty events: traces take many pieces
  return simulate(RandomTree(11, 12), ranks, seed, {.stall_probability = 0.01}, options);
}

TEST(Trace, OfASimulatedRunIsComplete) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const auto run = traced(5, seed, 1'000'000);
    const auto& traces = run.outcome.traces;
    ASSERT_EQ(traces.size(), 5U);
    // Nodes and times of the transfers from one rank to another, in order.
    using Transfers = std::vector<std::pair<std::uint64_t, double>>;
    std::map<std::tuple<int, int, bool>, Transfers> sent;
    std::map<std::tuple<int, int, bool>, Transfers> arrived;
    for (int rank = 0; rank < 5; ++rank) {
      const auto& trace = traces[static_cast<std::size_t>(rank)];
      const auto& statistics = run.outcome.ranks[static_cast<std::size_t>(rank)].statistics;
      ASSERT_FALSE(trace.events.empty());
      EXPECT_EQ(trace.dropped, 0U);
      EXPECT_TRUE(trace.events.front().starts_activity());
      EXPECT_EQ(trace.events.front().kind, rank == 0 ? Kind::busy : Kind::idle);
      EXPECT_GE(trace.events.front().time, 0.0);
      EXPECT_GE(trace.ended, trace.events.back().time);
      std::map<Kind, std::uint64_t> count;
      std::uint64_t nodes_given = 0;
      double time = 0;
      auto activity = Kind::closing;
      for (const auto& event : trace.events) {
        EXPECT_GE(event.time, time);
        time = event.time;
        ++count[event.kind];
        if (event.starts_activity()) {
          EXPECT_NE(std::exchange(activity, event.kind), event.kind);
        }
        const bool asked_for =
            event.kind == Kind::transfer_sent || event.kind == Kind::transfer_arrived;
        if (event.kind == Kind::transfer_sent || event.kind == Kind::lifeline_transfer_sent) {
          sent[{rank, event.peer, asked_for}].emplace_back(event.value, time);
          nodes_given += event.value;
        }
        if (event.kind == Kind::transfer_arrived || event.kind == Kind::lifeline_transfer_arrived) {
          arrived[{event.peer, rank, asked_for}].emplace_back(event.value, time);
        }
      }
      EXPECT_EQ(activity, Kind::closing);
      EXPECT_EQ(count[Kind::request_sent], statistics.requests);
      EXPECT_EQ(nodes_given, statistics.nodes_given);
      EXPECT_EQ(count[Kind::transfer_sent] + count[Kind::lifeline_transfer_sent],
                statistics.transfers_sent);
      EXPECT_EQ(count[Kind::transfer_arrived] + count[Kind::lifeline_transfer_arrived],
                statistics.transfers_received);
      EXPECT_EQ(count[Kind::transfer_arrived] + count[Kind::refusal_arrived], statistics.requests);
      EXPECT_EQ(count[Kind::reduction_joined], count[Kind::reduction_arrived]);
    }
    EXPECT_FALSE(sent.empty());
    ASSERT_EQ(sent.size(), arrived.size());
    for (const auto& [pair, transfers] : sent) {
      ASSERT_EQ(transfers.size(), arrived[pair].size());
      for (std::size_t i = 0; i < transfers.size(); ++i) {
        EXPECT_GE(transfers[i].first, arrived[pair][i].first);  // of all messages; of the first
        EXPECT_LT(transfers[i].second, arrived[pair][i].second);
      }
    }
  }
}

TEST(Trace, IsRecordedOnRequestWithoutChangingTheOutcome) {
  const auto with = traced(5, 1, 1000);
  const auto without = traced(5, 1, 0);
  EXPECT_EQ(with.outcome.fingerprint(), without.outcome.fingerprint());
  EXPECT_EQ(with.outcome.solutions.size(), without.outcome.solutions.size());
  EXPECT_EQ(with.left_behind, 0U);
  EXPECT_TRUE(without.outcome.traces.empty());
}

TEST(Trace, KeepsTheFirstEventsAndCountsTheOthers) {
  const auto whole = traced(3, 1, 1'000'000);
  const auto part = traced(3, 1, 20);
  for (std::size_t rank = 0; rank < 3; ++rank) {
    const auto& all = whole.outcome.traces[rank].events;
    const auto& trace = part.outcome.traces[rank];
    ASSERT_GT(all.size(), 20U);
    ASSERT_EQ(trace.events.size(), 20U);
    EXPECT_EQ(trace.dropped, all.size() - 20);
    EXPECT_EQ(trace.events.back().time, all[19].time);
  }
}

TEST(Trace, ShowsAStopForACheckpointThatCannotBeWritten) {
  Options options;
  options.trace_events = 1000;
  options.limits.nodes = 100;
  options.checkpoint.file = "/proc/no-files-here";
  options.checkpoint.problem = 1;
  const auto run = simulate(RandomTree(11, 12), 3, 1, {}, options);
  for (const auto& trace : run.outcome.traces) {
    std::vector<Kind> last;
    for (const auto& event : trace.events) {
      if (event.starts_activity()) last.push_back(event.kind);
    }
    ASSERT_GE(last.size(), 3U);
    last.erase(last.begin(), last.end() - 3);
    EXPECT_THAT(last, testing::ElementsAre(Kind::pausing, Kind::writing, Kind::closing));
  }
}

TEST(TraceClocks, OfOneMachineKeepTheirOrder) {
  // Both ranks joined before either saw the end of the reduction, by one clock.
  std::vector<RankTrace> traces(2);
  traces[0] = {.joined = 100, .began = 103, .ended = 110, .events = {{.time = 104}}};
  traces[1] = {.joined = 101, .began = 102, .ended = 111, .events = {{.time = 105}}};
  align_clocks(traces);
  EXPECT_EQ(traces[0].events[0].time, 2);
  EXPECT_EQ(traces[1].events[0].time, 3);
  EXPECT_EQ(traces[1].ended, 9);
}

TEST(TraceClocks, OfTwoMachinesCountFromTheBeginningOfTheSearch) {
  std::vector<RankTrace> traces(2);
  traces[0] = {.joined = 100, .began = 103, .ended = 110, .events = {{.time = 104}}};
  traces[1] = {.joined = 7001, .began = 7002, .ended = 7009, .events = {{.time = 7005}}};
  align_clocks(traces);
  EXPECT_EQ(traces[0].events[0].time, 1);
  EXPECT_EQ(traces[1].events[0].time, 3);
  EXPECT_EQ(traces[0].ended, 7);
  EXPECT_EQ(traces[1].ended, 7);
}

TEST(RankTrace, IsPutTogetherFromItsPieces) {
  RankTrace whole{.joined = 1, .began = 2, .ended = 3, .dropped = 4, .events = {}};
  for (int i = 0; i < 25; ++i) whole.events.push_back({.time = static_cast<double>(i)});
  const auto pieces = whole.pieces(10);
  ASSERT_EQ(pieces.size(), 3U);
  RankTrace again;
  for (const auto& piece : pieces) {
    EXPECT_LE(piece.events.size(), 10U);
    again.append(piece);
  }
  ASSERT_EQ(again.events.size(), 25U);
  for (int i = 0; i < 25; ++i) EXPECT_EQ(again.events[static_cast<std::size_t>(i)].time, i);
  EXPECT_EQ(again.ended, 3);
  EXPECT_EQ(again.dropped, 4U);
}

}  // namespace
}  // namespace kusabi::engine
