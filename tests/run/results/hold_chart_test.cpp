// Frames of charts of loads that can be held.
#include "run/results/hold_chart.hpp"

#include <utility>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "run/results/result_reader.hpp"

namespace kusabi::run {
namespace {

// As without a dead load: no load is held by every pattern.
TEST(HoldChart, ShowsTheVerticesBesideOneThatAllPiecesHave) {
  auto pieces = ResultJson::array();
  for (const int x : {-200, -100, 0, 100}) {
    pieces.push_back({{"pattern", {{"contact", {"tip"}}, {"separated", ResultJson::array()}}},
                      {"vertices", {{0, 0}, {x, 100}, {x + 100, 100}}},
                      {"rays", ResultJson::array()},
                      {"everything", false},
                      {"fine", true}});
  }
  ResultJson result{{"command", "hold"},
                    {"result", {{"cases", {"push", "pull"}}, {"pieces", std::move(pieces)}}}};
  const ResultReader reader(std::move(result), "result.json");
  const auto chart = hold_chart(reader, "It can hold the pairs.");
  ASSERT_TRUE(chart && chart->shown);
  EXPECT_EQ(chart->series.size(), 4U);
  for (const double x : {-200.0, 0.0, 200.0})
    EXPECT_TRUE(chart->shown->contains(Eigen::Vector2d(x, x == 0 ? 0 : 100))) << x;
}

}  // namespace
}  // namespace kusabi::run
