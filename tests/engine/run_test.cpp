// Programs of one call (engine/run.hpp): options of the command line, exit codes, and resumed runs.
#include "engine/run.hpp"

#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "engine/node_record.hpp"
#include "queens.hpp"

namespace kusabi::engine {
namespace {

using examples::Queens;
using testing::ElementsAre;
using testing::HasSubstr;

constexpr ProblemKind with_bound{.has_objective = true, .bounded = true};
constexpr ProblemKind plain{};

// Arguments of main, with the name of the program before them.
std::vector<const char*> arguments(const std::vector<std::string>& words) {
  std::vector<const char*> all{"/somewhere/program"};
  for (const auto& word : words) all.push_back(word.c_str());
  return all;
}

CommandLine line(const std::vector<std::string>& words, ProblemKind kind,
                 const Options& options = {}) {
  const auto all = arguments(words);
  return read_command_line(static_cast<int>(all.size()), all.data(), kind, options);
}

std::string refusal(const std::vector<std::string>& words, ProblemKind kind) {
  try {
    line(words, kind);
  } catch (const std::invalid_argument& wrong) {
    return wrong.what();
  }
  return "accepted";
}

TEST(CommandLineOfASearch, AcceptsOptionsAtAnyPosition) {
  const auto read = line({"7", "--order", "best", "file", "--node-limit=5", "--quiet"}, with_bound);
  EXPECT_THAT(read.words, ElementsAre("7", "file"));
  EXPECT_EQ(read.options.order, Order::best_first);
  EXPECT_EQ(read.options.limits.nodes, 5U);
  EXPECT_TRUE(read.quiet);
}

TEST(CommandLineOfASearch, TakesPrecedenceOverOptionsOfTheProgram) {
  Options own;
  own.limits.seconds = 3;
  own.limits.solutions = 4;
  const auto read = line({"--time-limit", "2.5"}, plain, own);
  EXPECT_EQ(read.options.limits.seconds, 2.5);
  EXPECT_EQ(read.options.limits.solutions, 4U);
}

TEST(CommandLineOfASearch, SearchesTheBestSolutionOfAProblemWithAnObjective) {
  EXPECT_EQ(line({}, with_bound).options.goal, Goal::best);
  EXPECT_EQ(line({"--goal", "all"}, with_bound).options.goal, Goal::all);
  EXPECT_EQ(line({}, plain).options.goal, Goal::all);
}

TEST(CommandLineOfASearch, NamesARefusedOption) {
  EXPECT_THAT(refusal({"--goal", "best"}, plain), HasSubstr("--goal: best not in {all,first}"));
  EXPECT_THAT(refusal({"--order", "best"}, plain), HasSubstr("--order"));
  EXPECT_THAT(refusal({"--nodes", "3"}, with_bound), HasSubstr("--nodes"));
  EXPECT_THAT(refusal({"--time-limit", "-1"}, with_bound), HasSubstr("--time-limit"));
  EXPECT_THAT(refusal({"--node-limit", "few"}, with_bound), HasSubstr("--node-limit"));
}

TEST(CommandLineOfASearch, HelpHasOnlyOptionsThatApplyToTheProblem) {
  EXPECT_THAT(line({"--help"}, with_bound).help, HasSubstr("--gap"));
  EXPECT_THAT(line({"--help"}, plain).help, testing::Not(HasSubstr("--gap")));
}

class Run : public testing::Test {
 protected:
  Run()
      : folder_(testing::TempDir() + "run_test_" +
                testing::UnitTest::GetInstance()->current_test_info()->name()) {
    std::filesystem::remove_all(folder_);
    std::filesystem::create_directories(folder_);
  }
  ~Run() override { std::filesystem::remove_all(folder_); }

  // Exit code of a program for N queens.
  int queens(int size, std::vector<std::string> words) {
    words.insert(words.begin(), std::to_string(size));
    words.emplace_back("--quiet");
    auto all = arguments(words);
    Queens problem(size);
    return run(static_cast<int>(all.size()), const_cast<char**>(all.data()), problem,
               [this](const auto& outcome) {
                 placements_ = outcome.solutions.size();
                 opened_ = outcome.opened();
               });
  }

  std::string state() const { return folder_ + "/state"; }

  std::string folder_;
  std::size_t placements_ = 0;
  std::uint64_t opened_ = 0;
};

TEST_F(Run, ReturnsTheExitCodeOfItsStatus) {
  EXPECT_EQ(queens(8, {}), 0);
  EXPECT_EQ(placements_, 92U);
  EXPECT_EQ(queens(8, {"--node-limit", "100"}), 3);
  EXPECT_EQ(queens(8, {"--nodes", "100"}), 2);
  EXPECT_EQ(queens(8, {"--help"}), 0);
}

TEST_F(Run, TheSameCallResumes) {
  queens(9, {});
  const auto whole = opened_;
  EXPECT_EQ(queens(9, {"--resume", state(), "--node-limit", "1000"}), 3);
  EXPECT_LT(opened_, whole);
  EXPECT_EQ(queens(9, {"--resume", state()}), 0);
  EXPECT_EQ(placements_, 352U);
  EXPECT_EQ(opened_, whole);
  EXPECT_FALSE(std::filesystem::exists(state()));
}

TEST_F(Run, ARecordStatesThatItIsIncomplete) {
  const auto record = folder_ + "/record";
  const auto last_line = [&] {
    std::ifstream file(record);
    std::string line;
    std::string last;
    while (std::getline(file, line)) last = line;
    return last;
  };
  EXPECT_EQ(queens(8, {"--record", record, "--node-limit", "100"}), 3);
  EXPECT_EQ(last_line(), incomplete_record);
  EXPECT_EQ(queens(8, {"--record", record}), 0);
  EXPECT_NE(last_line(), incomplete_record);
  EXPECT_EQ(queens(8, {"--record", record, "--resume", state()}), 2);  // only a part is searched
}

TEST_F(Run, TheStateOfAnotherProblemIsRefused) {
  EXPECT_EQ(queens(9, {"--resume", state(), "--node-limit", "1000"}), 3);
  EXPECT_EQ(queens(8, {"--resume", state()}), 1);
  EXPECT_EQ(queens(9, {"--resume", state()}), 0);
}

}  // namespace
}  // namespace kusabi::engine
