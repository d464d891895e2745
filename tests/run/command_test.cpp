// The command as a user calls it, alone and under mpirun.
#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <sys/wait.h>

namespace {

using testing::HasSubstr;

const std::string command = KUSABI_COMMAND;
const std::string truss = std::string(KUSABI_SOURCE_DIR) + "/examples/space-truss.toml";

struct Run {
  int exit_code;
  std::string output;  // both streams
};

Run shell(const std::string& line) {
  FILE* pipe = popen((line + " 2>&1").c_str(), "r");
  std::string output;
  std::array<char, 4096> piece{};
  while (const auto count = std::fread(piece.data(), 1, piece.size(), pipe)) {
    output.append(piece.data(), count);
  }
  const int status = pclose(pipe);
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, output};
}

std::string ranks(int count) {
  // The settings of mpi_tests/CMakeLists.txt: root, more ranks than cores, no pinning.
  return fmt::format(
      "env OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 "
      "OMPI_MCA_rmaps_base_oversubscribe=1 OMPI_MCA_hwloc_base_binding_policy=none "
      "OMPI_MCA_mpi_yield_when_idle=0 OMPI_MCA_btl_vader_single_copy_mechanism=none "
      "ASAN_OPTIONS=detect_leaks=0 {} {} ",
      KUSABI_MPIEXEC, count);
}

// A folder of its own for each test, gone afterwards.
class Command : public testing::Test {
 protected:
  void SetUp() override {
    std::string name = (std::filesystem::temp_directory_path() / "kusabi-test-XXXXXX").string();
    ASSERT_NE(mkdtemp(name.data()), nullptr);
    folder_ = name;
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  [[nodiscard]] std::string in_folder(const std::string& name) const {
    return (folder_ / name).string();
  }

  std::filesystem::path folder_;
};

std::string content(const std::string& name) {
  std::ifstream file(name);
  EXPECT_TRUE(file) << name;
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

// The text of the file from "command" to "statistics", byte for byte.
std::string without_statistics(const std::string& file) {
  auto text = content(file);
  const auto cut = text.find("\"statistics\"");
  EXPECT_NE(cut, std::string::npos);
  return text.substr(0, cut);
}

TEST_F(Command, ShowsTheTableOfPatterns) {
  const auto run = shell(fmt::format("{} patterns {} --mu 0.65", command, truss));
  EXPECT_EQ(run.exit_code, 0);
  EXPECT_THAT(run.output, HasSubstr("27 sign patterns of wedged configurations"));
  EXPECT_THAT(run.output, HasSubstr("b13 t13 b23"));
}

TEST_F(Command, GivesTheSameResultByteForByteOnAnyNumberOfRanks) {
  const std::string call = command + " patterns " + truss + " --mu 1.0 --quiet --output ";
  const auto serial = in_folder("serial.json");
  ASSERT_EQ(shell(call + serial + " --serial").exit_code, 0);
  const auto expected = without_statistics(serial);
  for (int count = 1; count <= 4; ++count) {
    const auto file = in_folder(fmt::format("np{}.json", count));
    const auto run = shell(ranks(count) + call + file);
    ASSERT_EQ(run.exit_code, 0) << run.output;
    EXPECT_EQ(without_statistics(file), expected) << count << " ranks";
    const auto statistics = nlohmann::json::parse(content(file))["statistics"];
    EXPECT_EQ(statistics["ranks"].size(), static_cast<std::size_t>(count));
  }
}

TEST_F(Command, WritesTheResultInFull) {
  const auto file = in_folder("result.json");
  ASSERT_EQ(shell(command + " patterns " + truss + " --mu 0.55 --output " + file).exit_code, 0);
  const auto json = nlohmann::json::parse(content(file));
  EXPECT_EQ(json["command"], "patterns");
  EXPECT_EQ(json["status"], "solved");
  EXPECT_EQ(json["problem"]["m"], 10);
  EXPECT_EQ(json["problem"]["units"]["force"], "kN");
  const auto& result = json["result"];
  EXPECT_EQ(result["count"], 1);
  EXPECT_EQ(result["marginal"], 0);
  EXPECT_EQ(result["friction"], 0.55);
  const auto& pattern = result["patterns"][0];
  EXPECT_EQ(pattern["contact"], (std::vector<std::string>{"b53", "t53"}));
  EXPECT_EQ(pattern["separated"].size(), 8U);
  EXPECT_EQ(pattern["state"], "alive");
  EXPECT_GT(pattern["margin"].get<double>(), 0);
  EXPECT_EQ(pattern["reaction"].size(), 10U);
  EXPECT_EQ(pattern["displacement"][9].size(), 3U);
  EXPECT_FALSE(std::filesystem::exists(file + ".tmp"));
}

TEST_F(Command, AnswersNoneWithExitCodeZero) {
  const auto run = shell(command + " patterns " + truss + " --mu 0.3");
  EXPECT_EQ(run.exit_code, 0);
  EXPECT_THAT(run.output, HasSubstr("0 sign patterns"));
}

TEST_F(Command, SaysNothingWhenAskedToBeQuiet) {
  const auto run = shell(command + " patterns " + truss + " --mu 0.55 --quiet");
  EXPECT_EQ(run.exit_code, 0);
  EXPECT_EQ(run.output, "");
}

TEST_F(Command, AWrongFileGetsOneLineAndExitCodeTwo) {
  const auto file = in_folder("typo.toml");
  std::ofstream(file) << "name = \"x\"\ndimensions = 3\n";
  const auto run = shell(command + " patterns " + file + " --mu 0.5");
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_THAT(run.output, HasSubstr(file + ":2:1: "));
  EXPECT_THAT(run.output, HasSubstr("dimensions"));
  EXPECT_EQ(std::count(run.output.begin(), run.output.end(), '\n'), 1) << run.output;
}

TEST_F(Command, AWrongFileIsReportedOnceByAllRanksTogether) {
  const auto run =
      shell(fmt::format("{} {} patterns {} --mu 1", ranks(3), command, in_folder("none.toml")));
  EXPECT_EQ(run.exit_code, 2);
  const auto first = run.output.find("none.toml: the file cannot be read");
  ASSERT_NE(first, std::string::npos);
  EXPECT_EQ(run.output.find("none.toml: the file cannot be read", first + 1), std::string::npos);
}

TEST_F(Command, RefusesWrongCalls) {
  const std::string good = "patterns " + truss + " --mu 0.5";
  const std::vector<std::string> wrong{
      "",
      "patterns",
      "patterns x.toml",
      "patterns " + truss,
      "patterns " + truss + " --mu 0",
      "patterns " + truss + " --mu -1",
      "patterns " + truss + " --mu nan",
      "patterns " + truss + " --mu inf",
      "patterns " + truss + " --mu 1,5",
      "patterns " + folder_.string() + " --mu 0.5",
      "paterns " + truss + " --mu 0.5",
      good + " --nonsense",
      good + " --tolerance 0",
      good + " --output /nowhere/at/all.json",
      good + " --output " + folder_.string(),
  };
  for (const auto& call : wrong) {
    const auto run = shell(command + " " + call);
    EXPECT_EQ(run.exit_code, 2) << call;
    EXPECT_EQ(std::count(run.output.begin(), run.output.end(), '\n'), 1) << run.output;
  }
}

TEST_F(Command, DoesNotOverwriteTheProblemWithTheResult) {
  const auto file = in_folder("truss.toml");
  std::filesystem::copy_file(truss, file);
  EXPECT_EQ(shell(command + " patterns " + file + " --mu 0.5 --output " + file).exit_code, 2);
  EXPECT_EQ(content(file), content(truss));
}

TEST_F(Command, LeavesNoHalfWrittenFileBehindAfterAnError) {
  const auto file = in_folder("typo.toml");
  std::ofstream(file) << "name = 1\n";
  shell(command + " patterns " + file + " --mu 0.5 --output " + in_folder("result.json"));
  EXPECT_FALSE(std::filesystem::exists(in_folder("result.json")));
  EXPECT_FALSE(std::filesystem::exists(in_folder("result.json.tmp")));
}

TEST_F(Command, HelpsAndTellsItsVersion) {
  const auto help = shell(command + " patterns --help");
  EXPECT_EQ(help.exit_code, 0);
  EXPECT_THAT(help.output, HasSubstr("--mu"));
  EXPECT_EQ(shell(command + " --help").exit_code, 0);
  EXPECT_THAT(shell(command + " --version").output, HasSubstr("kusabi "));
}

TEST_F(Command, NeverCallsMpiWhenSerial) {
  // Inside an MPI job's environment whose daemon is long gone, MPI_Init would fail or hang.
  const auto run = shell("env OMPI_COMM_WORLD_SIZE=2 PMIX_RANK=1 timeout 20 " + command +
                         " patterns " + truss + " --mu 0.55 --serial");
  EXPECT_EQ(run.exit_code, 0) << run.output;
  EXPECT_THAT(run.output, HasSubstr("1 sign pattern "));
}

}  // namespace
