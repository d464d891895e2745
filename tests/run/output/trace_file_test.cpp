// Timeline file: valid JSON that a viewer can draw.
#include "run/output/trace_file.hpp"

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <map>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace kusabi::run {
namespace {

using engine::RankTrace;
using Kind = engine::TraceEvent::Kind;
using nlohmann::json;

// Rank 0 always works and sends three nodes to rank 1, which is idle at first.
std::vector<RankTrace> two_ranks() {
  RankTrace giver{
      .ended = 9e-3,
      .events = {{.time = 0, .open = 1, .kind = Kind::busy},
                 {.time = 1e-3, .open = 6, .kind = Kind::reduction_joined},
                 {.time = 2e-3, .value = 3, .open = 3, .peer = 1, .kind = Kind::transfer_sent},
                 {.time = 3e-3, .value = 1, .open = 3, .kind = Kind::reduction_arrived},
                 {.time = 8e-3, .open = 0, .kind = Kind::closing}}};
  RankTrace taker{
      .ended = 9e-3,
      .events = {{.time = 0, .kind = Kind::idle},
                 {.time = 1e-3, .peer = 0, .kind = Kind::request_sent},
                 {.time = 2.5e-3, .value = 3, .open = 3, .peer = 0, .kind = Kind::transfer_arrived},
                 {.time = 2.5e-3, .open = 3, .kind = Kind::busy},
                 {.time = 6e-3, .kind = Kind::idle},
                 {.time = 8e-3, .kind = Kind::closing}}};
  return {giver, taker};
}

json written(const std::vector<RankTrace>& traces) {
  std::ostringstream out;
  write_trace(out, traces);
  return json::parse(out.str())["traceEvents"];
}

std::vector<json> of_phase(const json& events, const std::string& phase) {
  std::vector<json> list;
  std::copy_if(events.begin(), events.end(), std::back_inserter(list),
               [&](const json& event) { return event["ph"] == phase; });
  return list;
}

TEST(TraceFile, SlicesOfATrackHaveNoGaps) {
  const auto events = written(two_ranks());
  std::map<std::pair<int, int>, std::vector<json>> tracks;
  for (const auto& slice : of_phase(events, "X")) {
    tracks[{slice["pid"].get<int>(), slice["tid"].get<int>()}].push_back(slice);
  }
  ASSERT_EQ(tracks.size(), 3U);  // two of work, one of reductions
  const auto& work = tracks[{1, 0}];
  ASSERT_EQ(work.size(), 4U);
  double time = 0;
  for (const auto& slice : work) {
    EXPECT_EQ(slice["ts"], time);
    time += slice["dur"].get<double>();
  }
  EXPECT_EQ(time, 9000);  // microseconds
  EXPECT_EQ(work[0]["name"], "idle");
  EXPECT_EQ(work[1]["name"], "busy");
  EXPECT_EQ(work[3]["name"], "closing");
  const auto& reductions = tracks[{0, 1}];
  ASSERT_EQ(reductions.size(), 1U);
  EXPECT_EQ(reductions[0]["dur"], 2000);
}

TEST(TraceFile, ArrowLeadsFromSenderToReceiver) {
  const auto events = written(two_ranks());
  const auto starts = of_phase(events, "s");
  const auto ends = of_phase(events, "f");
  ASSERT_EQ(starts.size(), 1U);
  ASSERT_EQ(ends.size(), 1U);
  EXPECT_EQ(starts[0]["id"], ends[0]["id"]);
  EXPECT_EQ(starts[0]["pid"], 0);
  EXPECT_EQ(ends[0]["pid"], 1);
}

TEST(TraceFile, EachTransferHasAnArrowOfItsOwn) {
  auto traces = two_ranks();
  traces[0].events.push_back({.time = 8.5e-3, .value = 1, .peer = 1, .kind = Kind::transfer_sent});
  traces[1].events.push_back(
      {.time = 8.7e-3, .value = 1, .peer = 0, .kind = Kind::transfer_arrived});
  const auto events = written(traces);
  const auto starts = of_phase(events, "s");
  const auto ends = of_phase(events, "f");
  ASSERT_EQ(starts.size(), 2U);
  EXPECT_NE(starts[0]["id"], starts[1]["id"]);
  EXPECT_EQ(starts[0]["id"], ends[0]["id"]);
  EXPECT_EQ(starts[1]["id"], ends[1]["id"]);
}

TEST(TraceFile, DrawsTheOpenNodesWhenTheyChange) {
  std::vector<std::uint64_t> curve;
  for (const auto& point : of_phase(written(two_ranks()), "C")) {
    if (point["pid"] == 0) curve.push_back(point["args"]["open"].get<std::uint64_t>());
  }
  EXPECT_EQ(curve, (std::vector<std::uint64_t>{1, 6, 3, 0}));
}

TEST(TraceFile, ReportsDroppedEvents) {
  auto traces = two_ranks();
  traces[0].dropped = 17;
  std::ostringstream out;
  write_trace(out, traces);
  EXPECT_NE(out.str().find("17 later events were dropped"), std::string::npos);
  for (const auto& slice : of_phase(json::parse(out.str())["traceEvents"], "X")) {
    if (slice["pid"] != 0) continue;
    EXPECT_LE(slice["ts"].get<double>() + slice["dur"].get<double>(), 8000);
  }
}

TEST(TraceFile, LimitsTheEventsOfAllRanksTogether) {
  EXPECT_EQ(trace_events_per_rank(1), 1'000'000U);
  EXPECT_EQ(trace_events_per_rank(1000), 4000U);
  EXPECT_GE(trace_events_per_rank(100'000'000), 1U);
}

}  // namespace
}  // namespace kusabi::run
