// Tests of the collective operations with one rank; mpi_tests/collectives_mpi_test.cpp has more.
#include "engine/collectives.hpp"

#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "engine/analysis/analysis.hpp"
#include "engine/analysis/budget.hpp"
#include "engine/analysis/shared_work.hpp"
#include "engine/detail/contract.hpp"
#include "engine/transport/simulated.hpp"
#include "engine/transport/single_process.hpp"
#include "tests/engine/queens.hpp"

namespace kusabi::engine {
namespace {

TEST(Collectives, BroadcastsWithinOneProcess) {
  SingleProcess alone;
  EXPECT_EQ(from_first_rank(alone, [] { return std::string("said"); }), "said");
  EXPECT_EQ(all_reduce(alone, {.ranks = 1, .found = 7}).found, 7U);
  EXPECT_NO_THROW(require_equal_on_all_ranks(alone, 0xBAD));
}

TEST(Collectives, AnExceptionOfASingleProcessReachesTheCaller) {
  SingleProcess alone;
  EXPECT_THROW(from_first_rank(alone, []() -> int { throw std::runtime_error("no file"); }),
               std::runtime_error);
}

TEST(Collectives, RefuseSimulatedRanks) {
  SimulatedNetwork network(2, 1, {});
  EXPECT_THROW(from_first_rank(network.transport(0), [] { return 1; }), ContractBroken);
}

TEST(SharedWork, GivesTheResultsInTheOrderOfThePieces) {
  SingleProcess alone;
  const auto squares =
      share_work<std::uint64_t>(alone, 5, [](std::uint64_t number) { return number * number; });
  EXPECT_EQ(squares, (std::vector<std::uint64_t>{0, 1, 4, 9, 16}));
}

TEST(SharedWork, StopsAtTheLimitsOfTheAnalysis) {
  const std::function<std::uint64_t(std::uint64_t)> square = [](std::uint64_t n) { return n * n; };
  SingleProcess alone;
  Analysis unlimited(alone);
  EXPECT_EQ(unlimited.share_within_limits<std::uint64_t>(5, square),
            (std::vector<std::uint64_t>{0, 1, 4, 9, 16}));
  AnalysisOptions few;
  few.limits.nodes = 3;  // of nine
  Analysis limited(alone, few);
  EXPECT_TRUE(limited.share_within_limits<std::uint64_t>(5, square).empty());
  EXPECT_TRUE(limited.ended());
}

// One rank whose clock is a second ahead at each call, so that a reduction is due at each step.
class OneRank final : public SingleProcess {
 public:
  [[nodiscard]] double now() const override { return ++now_; }

 private:
  mutable double now_ = 0;
};

TEST(SharedWork, IgnoresTheSolutionLimitOfSearches) {
  OneRank rank;
  AnalysisOptions few;
  few.limits.solutions = 2;
  Analysis analysis(rank, few);
  examples::Queens queens(6);
  EXPECT_EQ(analysis.search(queens, {}).status, Status::solution_limit);
  const auto results =
      analysis.share_within_limits<std::uint64_t>(5, [](std::uint64_t number) { return number; });
  EXPECT_EQ(results, (std::vector<std::uint64_t>{0, 1, 2, 3, 4}));
}

TEST(Budget, SubtractsElapsedTimeAndKeepsTheOtherLimits) {
  Limits limits;
  limits.seconds = 1000;
  limits.nodes = 17;
  const Budget budget(limits);
  const auto left = budget.left();
  EXPECT_EQ(left.nodes, 17U);
  EXPECT_LE(left.seconds, 1000);
  EXPECT_GT(left.seconds, 0);
  EXPECT_FALSE(budget.spent());
  EXPECT_FALSE(budget.interrupt());
}

TEST(Budget, CountsNodesOverAllSearches) {
  Limits limits;
  limits.nodes = 17;
  Budget budget(limits);
  budget.count(12);
  EXPECT_EQ(budget.left().nodes, 5U);
  EXPECT_FALSE(budget.spent());
  budget.count(9);
  EXPECT_EQ(budget.left().nodes, 0U);
  EXPECT_TRUE(budget.spent());
  EXPECT_EQ(budget.stop_reason(), Status::node_limit);
}

TEST(Budget, IsSpentWhenTheTimeIsUp) {
  Limits limits;
  limits.seconds = 0;
  const Budget budget(limits);
  EXPECT_TRUE(budget.spent());
  EXPECT_TRUE(budget.stop()());
  EXPECT_EQ(budget.stop_reason(), Status::time_limit);
}

TEST(Budget, DistinguishesASignalFromTheTimeLimit) {
  Interrupt asked = Interrupt::none;
  const Budget budget({}, [&] { return asked; });
  EXPECT_FALSE(budget.spent());
  asked = Interrupt::stop;
  EXPECT_TRUE(budget.spent());
  EXPECT_EQ(budget.stop_reason(), Status::interrupted);
  EXPECT_EQ(budget.interrupt()(), Interrupt::stop);
}

TEST(Budget, PassesACheckpointRequestToTheNextSearchOnce) {
  Interrupt asked = Interrupt::checkpoint;
  const Budget budget({}, [&] { return std::exchange(asked, Interrupt::none); });
  EXPECT_FALSE(budget.spent());
  EXPECT_FALSE(budget.spent());
  const auto interrupt = budget.interrupt();
  EXPECT_EQ(interrupt(), Interrupt::checkpoint);
  EXPECT_EQ(interrupt(), Interrupt::none);
}

TEST(Analysis, ReleasesTheWatcherOfASearchAtItsEnd) {
  std::weak_ptr<int> watcher;
  AnalysisOptions analysis_options;
  analysis_options.watch = [&](Goal goal, const ShownObjective& shown) {
    EXPECT_EQ(goal, Goal::all);
    EXPECT_EQ(shown.unit, 3);
    const auto calls = std::make_shared<int>(0);
    watcher = calls;
    return [calls](const Progress&) { ++*calls; };
  };
  SingleProcess alone;
  Analysis analysis(alone, analysis_options);
  examples::Queens queens(6);
  EXPECT_EQ(analysis.search(queens, {}, {.unit = 3}).solutions.size(), 4U);
  EXPECT_TRUE(watcher.expired());
}

TEST(Analysis, EachSearchHasTheRemainingLimits) {
  AnalysisOptions analysis_options;
  analysis_options.limits.nodes = 1;
  SingleProcess alone;
  Analysis analysis(alone, analysis_options);
  examples::Queens queens(8);
  Options options;
  options.reduction_interval = 0;
  EXPECT_EQ(analysis.search(queens, options).status, Status::node_limit);
}

TEST(Analysis, ReportsOnlyIfRequested) {
  SingleProcess alone;
  Analysis(alone).say("nobody hears");
  std::string heard;
  AnalysisOptions analysis_options;
  analysis_options.say = [&](const std::string& line) { heard = line; };
  Analysis(alone, analysis_options).say("round 1");
  EXPECT_EQ(heard, "round 1");
}

TEST(Analysis, LimitsTheRateOfReports) {
  SingleProcess alone;
  int heard = 0;
  AnalysisOptions analysis_options;
  analysis_options.say = [&](const std::string&) { ++heard; };
  const auto say_twice = [&] {
    Analysis analysis(alone, analysis_options);
    for (int k = 0; k < 2; ++k) analysis.say_now_and_then([] { return "on the way"; });
  };
  analysis_options.say_every = std::chrono::hours(1);
  say_twice();
  EXPECT_EQ(heard, 0);
  analysis_options.say_every = {};
  say_twice();
  EXPECT_EQ(heard, 2);
}

}  // namespace
}  // namespace kusabi::engine
