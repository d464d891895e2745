// Statistics of ranks, with artificial values.
#include "run/output/rank_table.hpp"

#include <sstream>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace kusabi::run {
namespace {

using testing::ElementsAre;

std::vector<std::vector<std::string>> words(const std::string& text) {
  std::vector<std::vector<std::string>> lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) {
    std::istringstream cells(line);
    auto& list = lines.emplace_back();
    for (std::string cell; cells >> cell;) {
      if (cell != "%") list.push_back(cell);
    }
  }
  return lines;
}

engine::RankStatistics some(std::uint64_t opened, double idle) {
  engine::RankStatistics statistics;
  statistics.opened = opened;
  statistics.requests = 9;
  statistics.transfers_received = 2;
  statistics.messages_sent = 20;
  statistics.idle_seconds = idle;
  statistics.seconds = 4;
  return statistics;
}

TEST(RankTable, ShowsSharesMessagesAndIdleTime) {
  RankTable table({"leaves"});
  table.add(some(300, 1), {7});
  table.add(some(100, 3), {5});
  const auto lines = words(table.text());
  ASSERT_EQ(lines.size(), 4U);
  EXPECT_THAT(lines[0], ElementsAre("rank", "opened", "share", "leaves", "requests", "transfers",
                                    "messages", "idle", "seconds"));
  EXPECT_THAT(lines[1], ElementsAre("0", "300", "75.0", "7", "9", "2", "20", "25.0", "4.000"));
  EXPECT_THAT(lines[2], ElementsAre("1", "100", "25.0", "5", "9", "2", "20", "75.0", "4.000"));
  EXPECT_THAT(lines[3], ElementsAre("all", "400", "100.0", "12", "18", "4", "40", "50.0", "4.000"));
}

TEST(RankTable, PutsColumnsBelowEachOtherOnANarrowPage) {
  RankTable table({"branched", "pruned", "leaves"});
  table.add(some(300, 1), {7, 8, 9});
  table.add(some(100, 3), {5, 6, 4});
  const auto text = table.text(40);
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) EXPECT_LE(line.size(), 40U) << line;
  // Joined again, the columns are those of a wide page.
  auto wide = words(table.text());
  auto narrow = words(text);
  std::vector<std::vector<std::string>> joined(wide.size());
  std::size_t row = 0;
  for (const auto& line : narrow) {
    if (line.empty()) {
      row = 0;
      continue;
    }
    EXPECT_EQ(line.front(), wide[row].front());
    auto& own = joined[row++];
    own.insert(own.end(), line.begin() + (own.empty() ? 0 : 1), line.end());
  }
  EXPECT_EQ(joined, wide);
}

TEST(RankTable, OfOneRankHasNoSum) {
  RankTable table({});
  table.add(some(300, 1), {});
  EXPECT_EQ(words(table.text()).size(), 2U);
}

TEST(RankTable, CountsEarlierRunsInItsSums) {
  RankTable table({});
  table.add(some(300, 0), {});
  table.add_earlier(some(100, 0), {});
  const auto lines = words(table.text());
  ASSERT_EQ(lines.size(), 4U);
  EXPECT_THAT(lines[1], testing::Contains("75.0"));
  EXPECT_EQ(lines[2].front(), "before");
  EXPECT_THAT(lines[3], ElementsAre("all", "400", "100.0", "18", "4", "40", "0.0", "4.000"));
}

TEST(RankTable, OfManyRanksShowsTheSpread) {
  RankTable table({});
  for (std::uint64_t rank = 0; rank < 100; ++rank) table.add(some(1 + 2 * rank, 2), {});
  const auto lines = words(table.text());
  ASSERT_EQ(lines.size(), 5U);
  EXPECT_THAT(lines[1], ElementsAre("least", "1", "0.0", "9", "2", "20", "50.0", "4.000"));
  EXPECT_THAT(lines[2], ElementsAre("mean", "100", "1.0", "9", "2", "20", "50.0", "4.000"));
  EXPECT_THAT(lines[3], ElementsAre("most", "199", "2.0", "9", "2", "20", "50.0", "4.000"));
  EXPECT_THAT(lines[4],
              ElementsAre("all", "10000", "100.0", "900", "200", "2000", "50.0", "4.000"));
}

TEST(RankTable, OfASearchWithoutNodesHasZeros) {
  RankTable table({});
  table.add({}, {});
  table.add({}, {});
  EXPECT_THAT(words(table.text())[3],
              ElementsAre("all", "0", "0.0", "0", "0", "0", "0.0", "0.000"));
}

}  // namespace
}  // namespace kusabi::run
