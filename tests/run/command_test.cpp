// The command as a user calls it, alone and under mpirun.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <fcntl.h>
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <mpi.h>
#include <nlohmann/json.hpp>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include "shell.hpp"

namespace {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;
using namespace kusabi::test;

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

// A knapsack with three rows and thirty things, weights from a linear congruence: some hundreds of
// nodes.
std::string knapsack() {
  unsigned state = 12345;
  const auto draw = [&](unsigned from, unsigned to) {
    state = state * 1103515245U + 12345U;
    return from + (state >> 16U) % (to - from + 1);
  };
  std::string objective;
  std::array<std::string, 3> rows;
  std::string binaries;
  std::array<unsigned, 3> sums{};
  for (int j = 0; j < 30; ++j) {
    objective += fmt::format(" + {} x{}", draw(20, 60), j);
    for (std::size_t i = 0; i < 3; ++i) {
      const unsigned weight = draw(20, 60);
      sums[i] += weight;
      rows[i] += fmt::format(" + {} x{}", weight, j);
    }
    binaries += fmt::format(" x{}", j);
  }
  std::string text = fmt::format("Maximize\n value: {}\nSubject To\n", objective);
  for (std::size_t i = 0; i < 3; ++i)
    text += fmt::format(" r{}: {} <= {}\n", i, rows[i], sums[i] / 2);
  return text + "Binary\n" + binaries + "\nEnd\n";
}

TEST_F(Command, SolvesAZeroOneProgramAlikeOnAnyNumberOfRanks) {
  std::ofstream(in_folder("k.lp")) << knapsack();
  const std::string call = command + " mip " + argument("k.lp") + " --quiet --output ";
  for (int count = 1; count <= 3; ++count) {
    const auto run =
        shell((count == 1 ? "" : ranks(count)) + call + argument(fmt::format("{}.json", count)));
    ASSERT_EQ(run.exit_code, 0) << run.output;
    EXPECT_EQ(without_statistics(in_folder(fmt::format("{}.json", count))),
              without_statistics(in_folder("1.json")));
  }
  const auto result = nlohmann::json::parse(content(in_folder("1.json")));
  EXPECT_EQ(result["result"]["answer"], "optimal");
  EXPECT_EQ(result["result"]["proved"], true);
  EXPECT_EQ(result["result"]["bound"], result["result"]["objective"]);
  EXPECT_GT(result["statistics"]["opened"], 20);
  // Another tree, another order, cuts: the same optimum.
  for (const std::string way : {"--branching look-ahead --no-dive",
                                "--order best-first --no-tighten", "--cuts disjunctive"}) {
    ASSERT_EQ(shell(call + argument("other.json") + " " + way).exit_code, 0) << way;
    const auto other = nlohmann::json::parse(content(in_folder("other.json")));
    EXPECT_EQ(other["result"]["objective"], result["result"]["objective"]) << way;
  }
}

TEST_F(Command, GoesOnWithAZeroOneProgramWhereItStopped) {
  std::ofstream(in_folder("k.lp")) << knapsack();
  const std::string call =
      command + " mip " + argument("k.lp") + " --branching look-ahead --no-dive --output ";
  ASSERT_EQ(shell(call + argument("whole.json")).exit_code, 0);
  const auto stopped =
      shell(call + argument("part.json") + " --node-limit 20 --checkpoint " + argument("state"));
  EXPECT_EQ(stopped.exit_code, 3);
  const auto part = nlohmann::json::parse(content(in_folder("part.json")));
  EXPECT_EQ(part["status"], "node-limit");
  ASSERT_EQ(shell(as_typed(call_to_go_on(stopped.output))).exit_code, 0);
  EXPECT_EQ(without_statistics(in_folder("part.json")),
            without_statistics(in_folder("whole.json")));
  // No point is better than the bound of the part, nor worse than its point.
  const auto whole = nlohmann::json::parse(content(in_folder("whole.json")));
  EXPECT_GE(part["result"]["bound"], whole["result"]["objective"]);
}

// Whatever was in the call, and on as many ranks: names that a shell would split, and options that
// change the tree.
TEST_F(Command, TellsACallThatGoesOnAsItIs) {
  fs::copy(truss_file, in_folder("a truss.toml"));
  const std::string call = fmt::format(
      " patterns {} --mu 1 --branching paper --tolerance 1e-9 --certificate {} --output {}",
      argument("a truss.toml"), argument("c.cert"), argument("all.json"));
  ASSERT_EQ(shell(command + call + " --quiet").exit_code, 0);
  const auto whole = without_statistics(in_folder("all.json"));
  const auto certificate = content(in_folder("c.cert"));
  fs::remove(in_folder("c.cert"));
  const auto stopped = shell(ranks(2) + command + call + " --node-limit 12 --checkpoint " +
                             argument("it's a state"));
  EXPECT_EQ(stopped.exit_code, 3);
  const auto on = call_to_go_on(stopped.output);
  EXPECT_TRUE(on.starts_with("mpirun -np 2 kusabi patterns ")) << on;
  EXPECT_THAT(on, testing::Not(HasSubstr("--node-limit")));
  const auto gone_on = shell(as_typed(on));
  ASSERT_EQ(gone_on.exit_code, 0) << gone_on.output;
  EXPECT_EQ(without_statistics(in_folder("all.json")), whole);
  EXPECT_EQ(fs::file_size(in_folder("c.cert")), certificate.size());
}

TEST_F(Command, SaysWhenAZeroOneProgramHasNoOptimum) {
  std::ofstream(in_folder("none.lp")) << "Minimize\n c: x\nSubject To\n r: 2 x + 2 y = 1\n"
                                         "Binary\n x y\nEnd\n";
  auto run = shell(command + " mip " + argument("none.lp"));
  EXPECT_EQ(run.exit_code, 0);
  EXPECT_THAT(run.output, HasSubstr("infeasible"));
  std::ofstream(in_folder("open.lp")) << "Maximize\n c: x + w\nSubject To\n r: w - x >= 0\n"
                                         "Binary\n x\nEnd\n";
  run = shell(command + " mip " + argument("open.lp"));
  EXPECT_EQ(run.exit_code, 0);
  EXPECT_THAT(run.output, HasSubstr("unbounded"));
  // Without a point, an objective without bound is of no use.
  std::ofstream(in_folder("both.lp"))
      << "Maximize\n c: x + w\nSubject To\n r: w - x >= 0\n s: 2 x + 2 y = 1\n"
         "Binary\n x y\nEnd\n";
  run = shell(command + " mip " + argument("both.lp"));
  EXPECT_EQ(run.exit_code, 0);
  EXPECT_THAT(run.output, HasSubstr("infeasible"));
}

TEST_F(Command, RefusesAZeroOneProgramThatIsNone) {
  std::ofstream(in_folder("bad.mps")) << "NAME X\nROWS\n N C\nCOLUMNS\n A B 1\nENDATA\n";
  const auto run = shell(command + " mip " + argument("bad.mps"));
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_THAT(run.output, HasSubstr("bad.mps:5: \"B\" is no row; expected a name of section ROWS"));
}

TEST_F(Command, GivesTheSameResultByteForByteOnAnyNumberOfRanks) {
  const std::string call = command + " patterns " + truss + " --mu 1.0 --quiet --output ";
  const auto serial = in_folder("serial.json");
  ASSERT_EQ(shell(call + quoted(serial) + " --serial").exit_code, 0);
  const auto expected = without_statistics(serial);
  for (int count = 1; count <= 4; ++count) {
    const auto file = in_folder(fmt::format("np{}.json", count));
    const auto run = shell(ranks(count) + call + quoted(file));
    ASSERT_EQ(run.exit_code, 0) << run.output;
    EXPECT_EQ(without_statistics(file), expected) << count << " ranks";
    const auto statistics = nlohmann::json::parse(content(file))["statistics"];
    EXPECT_EQ(statistics["ranks"].size(), static_cast<std::size_t>(count));
  }
}

TEST_F(Command, WritesTheResultInFull) {
  const auto file = in_folder("result.json");
  ASSERT_EQ(shell(command + " patterns " + truss + " --mu 0.55 --output " + quoted(file)).exit_code,
            0);
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
  EXPECT_EQ(files(), std::vector<std::string>{"result.json"});
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
  const auto run = shell(command + " patterns " + quoted(file) + " --mu 0.5");
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_THAT(run.output, HasSubstr(file + ":2:1: "));
  EXPECT_THAT(run.output, HasSubstr("dimensions"));
  EXPECT_EQ(std::count(run.output.begin(), run.output.end(), '\n'), 1) << run.output;
}

TEST_F(Command, AWrongFileIsReportedOnceByAllRanksTogether) {
  const auto run =
      shell(fmt::format("{} {} patterns {} --mu 1", ranks(3), command, argument("none.toml")));
  EXPECT_EQ(run.exit_code, 2);
  const auto first = run.output.find("none.toml: the file cannot be read");
  ASSERT_NE(first, std::string::npos);
  EXPECT_EQ(run.output.find("none.toml: the file cannot be read", first + 1), std::string::npos);
}

// W (4) and (5): what the obstacle pushes, the supports hold.
TEST_F(Command, WritesWhatAConfigurationDoesToTheWholeStructure) {
  const auto plane = quoted(std::string(KUSABI_SOURCE_DIR) + "/examples/plane-truss.toml");
  for (const std::string& call : {" patterns " + plane + " --mu 1", " critical " + plane,
                                  " rays " + plane + " --mu 1 --whole"}) {
    ASSERT_EQ(shell(command + call + " --quiet --output " + argument("all.json")).exit_code, 0);
    const auto json = nlohmann::json::parse(content(in_folder("all.json")));
    const auto& result = json["result"];
    const auto& configurations = result.contains("rays") ? result["rays"] : result["patterns"];
    ASSERT_FALSE(configurations.empty());
    for (const auto& each : configurations) {
      EXPECT_LE(each["imbalance"], 1e-12) << call;
      std::array<double, 2> sum{};
      double size = 0;
      const auto& frames = json["problem"]["contact"];
      for (std::size_t i = 0; i < frames.size(); ++i) {
        const auto& frame = frames[i];
        for (std::size_t axis = 0; axis < 2; ++axis) {
          const double n = frame["n"][axis];
          const double t = frame["t1"][axis];
          const double force =
              each["reaction"][i][0].get<double>() * n + each["reaction"][i][1].get<double>() * t;
          sum[axis] += force;
          size += std::abs(force);
          // The candidate's own displacement, in global axes.
          const double u = each["displacement"][i][0].get<double>() * n +
                           each["displacement"][i][1].get<double>() * t;
          const double whole = each["all_displacements"][frame["node"].get<std::string>()][axis];
          EXPECT_NEAR(u, whole, 1e-9 * (std::abs(u) + 1));
        }
      }
      EXPECT_EQ(each["support_reactions"].size(), 5U);
      for (const auto& support : each["support_reactions"]) {
        for (std::size_t axis = 0; axis < 2; ++axis) sum[axis] += support[axis].get<double>();
      }
      EXPECT_LE(std::abs(sum[0]) + std::abs(sum[1]), 1e-12 * size) << call;
    }
  }
}

// One line each, which says what is wrong and what was expected.
TEST_F(Command, RefusesWrongCalls) {
  const std::string good = "patterns " + truss + " --mu 0.5";
  const std::string above_0 = "expected a number above 0";
  const std::string all = "expected one of patterns, rays, critical, limit, sweep, mip, verify";
  const auto plane = quoted(std::string(KUSABI_SOURCE_DIR) + "/examples/plane-truss.toml");
  struct Wrong {
    std::string call;
    std::string message;
  };
  const std::vector<Wrong> wrong{
      {"paterns " + truss + " --mu 0.5", "no subcommand 'paterns'; did you mean patterns?"},
      {"none-of-these " + truss + " --mu 0.5", "no subcommand 'none-of-these'; " + all},
      {truss + " --mu 0.5", "a subcommand goes before "},
      {"help nothing", "no subcommand 'nothing'; " + all},
      {"grid --bays 2", "no subcommand 'grid'; did you mean example grid?"},
      {"bench", "kusabi bench is without its subcommand; expected one of scaling, schedules, uts"},
      {"example gird", "kusabi example has no subcommand 'gird'; did you mean grid?"},
      {"--quiet " + good, "no option --quiet; options of a subcommand go after it"},
      {"--completion tcsh", "--completion: 'tcsh', expected one of bash, zsh, fish"},
      {"patterns --facest 8", "patterns has no option --facest; did you mean --facets?"},
      {"patterns " + truss + " --frction 0.5", "did you mean --mu (friction coefficient)?"},
      {"limit " + truss + " --facets 8", "limit has no option --facets; it is one of patterns"},
      {good + " --output", "--output is without its value, the name of a file"},
      {good + " --mu 0.6", "--mu is there more than once"},
      {good + " more.toml", "'more.toml' is one word too many; patterns takes one file"},
      {good + " -- --mu", "'--mu' is one word too many; patterns takes one file"},
      {"patterns", "file is required"},
      {"patterns x.toml", "--mu is required"},
      {"patterns " + truss, "--mu is required"},
      {"patterns " + truss + " --mu 0", "--mu: '0', " + above_0},
      {"patterns " + truss + " --mu -1", "--mu: '-1', " + above_0},
      {"patterns " + truss + " --mu nan", "--mu: 'nan', " + above_0},
      {"patterns " + truss + " --mu inf", "--mu: 'inf', " + above_0},
      {"patterns " + truss + " --mu 1,5", "--mu: '1,5', " + above_0},
      {"patterns " + truss + " --mu 0:1:0.1", "for a range: kusabi sweep FILE --mu 0:1:0.1"},
      {"limit " + truss + " --alpha 0:60:5", "for a range: kusabi sweep FILE --alpha 0:60:5"},
      {"patterns " + truss + " --mu ''", "--mu: '', " + above_0},
      {"patterns none.toml --mu 0.5", "none.toml: the file cannot be read"},
      {"patterns " + quoted(folder_.string()) + " --mu 0.5", "cannot be read"},
      {good + " --nonsense", "patterns has no option --nonsense (try kusabi patterns --help)"},
      {good + " --tolerance 0", "--tolerance: '0', expected a number from 1e-12 to 0.001"},
      {good + " --tolerance 0.1", "--tolerance: '0.1', expected a number from 1e-12 to 0.001"},
      {good + " --output /nowhere/at/all.json", "--output /nowhere/at/all.json: cannot be written"},
      {good + " --trace /nowhere/at/all.json", "--trace /nowhere/at/all.json: cannot be written"},
      {good + " --output " + quoted(folder_.string()), "--output " + folder_.string() + ": "},
      {good + " --serial=false", "--serial takes no value"},
      {good + " --node-limit 0", "--node-limit: '0', expected a whole number above 0"},
      {good + " --node-limit 1.5", "--node-limit: '1.5', expected a whole number above 0"},
      {good + " --node-limit 99999999999999999999",
       "--node-limit: '99999999999999999999', expected"},
      {good + " --method simplex", "--method: 'simplex', expected one of cones, polyhedral"},
      {good + " --facets 8", "--facets requires --method"},
      {good + " --candidates --method cones", "expected --method polyhedral"},
      {good + " --order sideways", "expected one of depth-first, breadth-first"},
      {good + " --facets 8 --method cones", "expected --method polyhedral"},
      {good + " --probe 4 --method polyhedral", "expected --method cones"},
      {good + " --method polyhedral --facets 7",
       "--facets: '7', expected an even number from 4 to 64"},
      {"patterns " + plane + " --mu 0.5 --method polyhedral", "expected --method cones"},
      {good + " --time-limit -1", "--time-limit: '-1', " + above_0},
      {good + " --checkpoint /nowhere/at/all", "--checkpoint /nowhere/at/all: cannot be written"},
      {good + " --restart " + argument("none"), "--restart " + in_folder("none")},
      {good + " --restart " + truss, "--restart " + truss_file + ": is the problem file itself"},
      {"critical " + truss + " --method newton", "--mu-max is missing; expected"},
      {"critical " + truss + " --mu-max 0", "--mu-max: '0', " + above_0},
      {"critical " + truss + " --width 0", "--width: '0', " + above_0},
      {"critical " + truss + " --width 1e-20", "--width 1e-20: expected a number below --mu-max"},
      {"critical " + truss + " --method guess",
       "--method: 'guess', expected one of auto, descent, global, newton, bisection"},
      {"rays " + plane + " --mu 1 --method double-description --node-limit 9", "expected no limit"},
      {"rays " + truss + " --mu 1", "dimension is 3; expected 2"},
      {"limit " + truss + " --group-alpha wind", "--group-alpha 'wind': expected NAME=NUMBER"},
      {"limit " + truss + " --group-alpha wind=-1", "expected NAME=NUMBER, not negative"},
      {"limit " + truss + " --alpha 1 --cuts some",
       "--cuts: 'some', expected one of none, disjunctive, tighten, static, all"},
      {"limit " + truss + " --alpha 1 --samples 0",
       "--samples: '0', expected a whole number from 1 to 100000000"},
      {"mip none.lp --gap 0", "--gap: '0', " + above_0},
      {"verify", "certificate is required"},
      {"verify none.cert", "none.cert: the file cannot be read; expected a certificate"},
      {"example grid", "--bays is required"},
      {"example grid --bays two", "--bays: 'two', expected a whole number above 0"},
      {"bench uts --tree T9", "--tree: 'T9', expected one of T1-4, "},
  };
  for (const auto& [call, message] : wrong) {
    const auto run = shell(command + " " + call);
    EXPECT_EQ(run.exit_code, 2) << call;
    EXPECT_THAT(run.output, HasSubstr(message)) << call;
    EXPECT_EQ(std::count(run.output.begin(), run.output.end(), '\n'), 1) << run.output;
  }
}

TEST_F(Command, TakesLettersForWhatIsTypedMost) {
  const auto short_call =
      shell(command + " patterns " + truss + " --mu 0.65 -q -o " + argument("short.json"));
  EXPECT_EQ(short_call.exit_code, 0);
  EXPECT_EQ(short_call.output, "");
  shell(command + " patterns " + truss + " --mu 0.65 --quiet --output " + argument("long.json"));
  EXPECT_EQ(nlohmann::json::parse(content(in_folder("short.json")))["result"],
            nlohmann::json::parse(content(in_folder("long.json")))["result"]);
  EXPECT_THAT(shell(command + " patterns " + truss + " --mu 0.65 -o").output,
              HasSubstr("--output is without its value"));
  EXPECT_THAT(shell(command + " patterns --help").output, HasSubstr("  -o, --output FILE"));
}

TEST_F(Command, DoesNotOverwriteTheProblemWithTheResult) {
  fs::copy_file(truss_file, in_folder("truss.toml"));
  fs::create_symlink("truss.toml", in_folder("link"));
  const auto call = command + " patterns " + argument("truss.toml") + " --mu 0.5 --output ";
  for (const auto* other_name : {"truss.toml", "./truss.toml", "link"}) {
    const auto run = shell(call + argument(other_name));
    EXPECT_EQ(run.exit_code, 2) << other_name;
    EXPECT_THAT(run.output, HasSubstr(other_name + std::string(": is the problem file itself\n")));
    EXPECT_EQ(content(in_folder("truss.toml")), content(truss_file)) << other_name;
  }
  EXPECT_EQ(files(), (std::vector<std::string>{"link", "truss.toml"}));
}

TEST_F(Command, WritesToWhereALinkPoints) {
  std::ofstream(in_folder("old.json")) << "old";
  fs::create_symlink("old.json", in_folder("link"));
  const auto call = command + " patterns " + truss + " --mu 0.5 --quiet --output ";
  ASSERT_EQ(shell(call + argument("link")).exit_code, 0);
  EXPECT_TRUE(fs::is_symlink(in_folder("link")));
  EXPECT_EQ(nlohmann::json::parse(content(in_folder("old.json")))["command"], "patterns");
}

TEST_F(Command, WritesToAPipeWithoutReplacingIt) {
  const auto call = command + " patterns " + truss + " --mu 0.5 --quiet --output ";
  EXPECT_EQ(nlohmann::json::parse(shell(call + "/dev/stdout").output)["command"], "patterns");
  ASSERT_EQ(mkfifo(in_folder("pipe").c_str(), 0600), 0);
  const auto run =
      shell("{ cat " + argument("pipe") + " & " + call + argument("pipe") + "; wait; }");
  EXPECT_EQ(nlohmann::json::parse(run.output)["command"], "patterns");
  EXPECT_TRUE(fs::is_fifo(in_folder("pipe")));
}

TEST_F(Command, LeavesNoHalfWrittenFileBehindAfterAnError) {
  std::ofstream(in_folder("typo.toml")) << "name = 1\n";
  shell(command + " patterns " + argument("typo.toml") + " --mu 0.5 --output " +
        argument("result.json"));
  EXPECT_EQ(files(), std::vector<std::string>{"typo.toml"});
}

TEST_F(Command, DecidesAtAnyFrictionThatItTakes) {
  const auto file = in_folder("result.json");
  const auto run = shell(command + " patterns " + truss + " --mu 1e6 --output " + quoted(file));
  EXPECT_EQ(run.exit_code, 0) << run.output;
  const auto result = nlohmann::json::parse(content(file))["result"];
  EXPECT_EQ(result["undecided"], 0);
  EXPECT_EQ(result["marginal"], 0);
  EXPECT_GT(result["count"], 0);
  const auto beyond = shell(command + " patterns " + truss + " --mu 1e7");
  EXPECT_EQ(beyond.exit_code, 2);
  EXPECT_THAT(beyond.output, HasSubstr("the friction at b13 comes out as 1e+07; expected"));
}

// A node on a rod along its normal, beside one that it does not move (worked out by hand: r_t = r_n
// at c1, so it wedges from 1 on).
constexpr auto rod_along_normal = R"(name = "a rod along the normal"
dimension = 2
units = { length = "m", force = "kN" }
[nodes]
g1 = [0.0, -1.0]
g2 = [0.0, 1.0]
g3 = [2.0, 2.5]
c1 = [1.0, 0.0]
c2 = [1.0, 1.0]
[[members]]
EA = 1.0
between = [["g1","c1"],["g2","c2"],["c1","c2"],["g3","c2"]]
[[supports]]
nodes = ["g1","g2","g3"]
[[contact]]
nodes = ["c1"]
normal = [0.0, 1.0]
[[contact]]
nodes = ["c2"]
normal = [-1.0, 0.2]
)";

TEST_F(Command, ListsAFlatConeOnceWithItsCandidatesAtRest) {
  std::ofstream(in_folder("rod.toml")) << rod_along_normal;
  const auto run = shell(command + " patterns " + argument("rod.toml") + " --mu 1.1 --output " +
                         argument("result.json"));
  EXPECT_EQ(run.exit_code, 0) << run.output;
  EXPECT_THAT(run.output, HasSubstr("at rest: c2"));
  const auto result = nlohmann::json::parse(content(in_folder("result.json")))["result"];
  EXPECT_EQ(result["count"], 1);
  EXPECT_EQ(result["flat"], 1);
  ASSERT_EQ(result["patterns"].size(), 1U);
  const auto& pattern = result["patterns"][0];
  EXPECT_EQ(pattern["state"], "flat");
  EXPECT_EQ(pattern["contact"], std::vector<std::string>{"c1"});
  EXPECT_EQ(pattern["at_rest"], std::vector<std::string>{"c2"});
  for (const std::string way :
       {"", " --method newton --mu-max 6", " --method bisection --mu-max 6"}) {
    const auto critical = shell(command + " critical " + argument("rod.toml") + way +
                                " --quiet --output " + argument("critical.json"));
    EXPECT_EQ(critical.exit_code, 0) << critical.output;
    const auto bracket =
        nlohmann::json::parse(content(in_folder("critical.json")))["result"]["critical_friction"];
    EXPECT_LE(bracket["lower"], 1.0) << way;
    EXPECT_GE(bracket["upper"], 1.0) << way;
    EXPECT_LE(bracket["upper"].get<double>() - bracket["lower"].get<double>(), 2.1e-8) << way;
  }
}

TEST_F(Command, SplitsNodesAsThePaperDoesWhenAsked) {
  const auto opened = [&](const std::string& rule) {
    const auto file = in_folder(rule + ".json");
    const auto run = shell(command + " patterns " + truss + " --mu 0.65 --branching " + rule +
                           " --output " + quoted(file));
    EXPECT_THAT(run.output, HasSubstr("27 sign patterns"));
    const auto result = nlohmann::json::parse(content(file));
    EXPECT_EQ(result["options"]["branching"], rule);
    return result["result"]["tree"]["opened"].get<int>();
  };
  EXPECT_LT(opened("relative"), opened("paper"));
  opened("deepest");
}

TEST_F(Command, IsPartOfAPipe) {
  const auto through = shell(command + " example plane-truss --rows 5 | " + command +
                             " patterns - --mu 1 --output - 2>/dev/null");
  EXPECT_EQ(through.exit_code, 0);
  const auto piped = nlohmann::json::parse(through.output);
  ASSERT_EQ(shell(command + " example plane-truss --rows 5 --output " + argument("five.toml") +
                  " && " + command + " patterns " + argument("five.toml") +
                  " --mu 1 --quiet --output " + argument("result.json"))
                .exit_code,
            0);
  const auto filed = nlohmann::json::parse(content(in_folder("result.json")));
  EXPECT_EQ(piped["result"]["patterns"], filed["result"]["patterns"]);
  EXPECT_EQ(piped["problem"]["fingerprint"], filed["problem"]["fingerprint"]);
  EXPECT_FALSE(fs::exists("-"));
  const auto wrong = shell("echo 'name = ' | " + command + " patterns - --mu 1");
  EXPECT_EQ(wrong.exit_code, 2);
  EXPECT_THAT(wrong.output, HasSubstr("-:1:8: "));
  const auto twice = shell(command + " patterns " + truss + " --mu 1 --output - --trace -");
  EXPECT_EQ(twice.exit_code, 2);
}

// Standard output is what is open, with all that is there before and comes after.
TEST_F(Command, WritesToTheStandardOutputThatIsOpen) {
  const auto call = command + " patterns " + truss + " --mu 0.65 --output ";
  const auto file = in_folder("all");
  for (const auto* const name : {"-", "/dev/stdout --quiet"}) {
    const auto run =
        shell("{ echo before; " + call + name + "; echo after; } > " + argument("all"));
    EXPECT_EQ(run.exit_code, 0) << run.output;
    const auto text = content(file);
    ASSERT_TRUE(text.starts_with("before\n{") && text.ends_with("}\nafter\n")) << text;
    const auto json = text.substr(7, text.size() - 7 - 6);
    EXPECT_EQ(nlohmann::json::parse(json)["command"], "patterns");
  }
  EXPECT_EQ(std::distance(fs::directory_iterator(fs::path(file).parent_path()), {}), 1);
  const auto full = shell("{ " + call + "- > /dev/full; }");
  EXPECT_EQ(full.exit_code, 1);
  EXPECT_THAT(full.output, HasSubstr("standard output"));
}

// The numbers are those of the result file, whatever the order.
TEST_F(Command, ListsPatternsInTheOrderThatIsAskedFor) {
  const auto patterns = [&](const std::string& more) {
    return shell(command + " patterns " + truss + " --mu 0.65" + more).output;
  };
  const auto run = patterns(" --sort margin --top 2 --output " + argument("result.json"));
  const auto all = nlohmann::json::parse(content(in_folder("result.json")))["result"]["patterns"];
  EXPECT_EQ(all.size(), 27U);
  std::vector<std::pair<double, int>> margins;
  for (std::size_t i = 0; i < all.size(); ++i)
    margins.emplace_back(all[i]["margin"].get<double>(), static_cast<int>(i) + 1);
  std::ranges::sort(margins, std::greater());
  const auto row = [&](std::size_t rank) {
    return fmt::format("\n{:>5}  {:>10}  ", margins[rank].second,
                       fmt::format("{:.3e}", margins[rank].first));
  };
  EXPECT_THAT(run, AllOf(HasSubstr(row(0)), HasSubstr(row(1)), Not(HasSubstr(row(2))),
                         HasSubstr("  25 more\n")));
  EXPECT_LT(run.find(row(0)), run.find(row(1)));
  EXPECT_THAT(run, HasSubstr(fmt::format(", has number {} (", margins[0].second)));
  EXPECT_THAT(patterns(" --sort contact --top 1"), HasSubstr("   27  "));
}

// At less than what the sentence says the configuration is no longer one; the pattern may live on.
TEST_F(Command, SaysFromWhatFrictionOnTheSafestConfigurationHolds) {
  const auto run =
      shell(command + " patterns " + truss + " --mu 0.65 --output " + argument("result.json"));
  const auto all = nlohmann::json::parse(content(in_folder("result.json")))["result"]["patterns"];
  const auto best = std::ranges::max_element(
      all, {}, [](const nlohmann::json& pattern) { return pattern["margin"].get<double>(); });
  double least = 0;
  for (const auto& reaction : (*best)["reaction"]) {
    const auto r = reaction.get<std::vector<double>>();
    if (r[0] > 0) least = std::max(least, std::hypot(r[1], r[2]) / r[0]);
  }
  EXPECT_LT(least, 0.65);
  EXPECT_THAT(
      run.output,
      HasSubstr(fmt::format("Its configuration holds from friction coefficient {:.4g} on", least)));
  EXPECT_THAT(shell(command + " patterns " + truss + " --mu 0.3").output,
              HasSubstr("It cannot stick at friction coefficient 0.3."));
}

TEST_F(Command, FindsTheCriticalFrictionOnAnyNumberOfRanks) {
  const auto run_on = [&](const std::string& launcher, const std::string& way) {
    const auto file = in_folder("result.json");
    const auto run =
        shell(launcher + command + " critical " + truss + way + " --output " + quoted(file));
    EXPECT_EQ(run.exit_code, 0) << run.output;
    return without_statistics(file);
  };
  for (const std::string way :
       {"", " --method newton --mu-max 0.65", " --method bisection --mu-max 0.65 --width 1e-4"}) {
    const auto alone = run_on("", way);
    EXPECT_EQ(run_on(ranks(2), way), alone) << way;
    EXPECT_EQ(run_on(ranks(3), way), alone) << way;
    EXPECT_NE(alone.find("\"lower\": 0.4702"), std::string::npos) << way;
  }
}

TEST_F(Command, ProvesBothEndsOfTheCriticalFriction) {
  const auto run = shell(command + " critical " + truss + " --certificate " + argument("cert"));
  EXPECT_EQ(run.exit_code, 0) << run.output;
  EXPECT_THAT(run.output, HasSubstr("between 0.47027964 and 0.47027965"));
  EXPECT_THAT(shell(command + " verify " + argument("cert.lower")).output,
              HasSubstr("PROVED: the list of 0 patterns is complete: it cannot stick\n"));
  EXPECT_THAT(shell(command + " verify " + argument("cert.upper")).output,
              HasSubstr("PROVED: it can stick, by 1 pattern; nothing is said of other patterns\n"));
  const auto listed =
      shell(command + " critical " + truss + " --list --certificate " + argument("listed"));
  EXPECT_EQ(listed.exit_code, 0) << listed.output;
  EXPECT_THAT(shell(command + " verify " + argument("listed.upper") + " --problem " + truss).output,
              HasSubstr("PROVED: the list of 1 pattern is"));
}

TEST_F(Command, NothingThatWedgesIsAnAnswer) {
  const auto run = shell(command + " critical " + truss + " --mu-max 0.4");
  EXPECT_EQ(run.exit_code, 0);
  EXPECT_THAT(run.output, HasSubstr("It cannot stick up to friction coefficient 0.4."));
}

TEST_F(Command, ACriticalFrictionThatWasStoppedSaysWhatIsProved) {
  const auto run = shell(command + " critical " + truss + " --node-limit 20");
  EXPECT_EQ(run.exit_code, 3);
  EXPECT_THAT(run.output, HasSubstr("Stopped early (node-limit)"));
}

// 233 candidates of which all can be in contact at once: no tree comes upon that soon.
TEST_F(Command, OfManyCandidatesOnePatternIsFoundWithoutASearch) {
  const auto file =
      quoted(std::string(KUSABI_SOURCE_DIR) + "/tests/cases/c_lc6_o2.toml");  // tan 3 deg = 0.0524
  const auto run = shell(command + " patterns " + file + " --mu 0.1 --pattern-limit 1 --output " +
                         argument("one.json"));
  EXPECT_EQ(run.exit_code, 3) << run.output;
  const auto json = nlohmann::json::parse(content(in_folder("one.json")));
  EXPECT_EQ(json["status"], "solution-limit");
  ASSERT_EQ(json["result"]["patterns"].size(), 1U);
  EXPECT_EQ(json["result"]["patterns"][0]["state"], "alive");
}

TEST_F(Command, FindsTheSamePatternsByPolyhedralFriction) {
  const auto patterns = [&](const std::string& method) {
    const auto file = in_folder("result.json");
    const auto run = shell(command + " patterns " + truss + " --mu 0.65 " + method + " --output " +
                           quoted(file));
    EXPECT_EQ(run.exit_code, 0) << run.output;
    const auto result = nlohmann::json::parse(content(file))["result"];
    std::set<nlohmann::json> contact;
    for (const auto& pattern : result["patterns"]) contact.insert(pattern["contact"]);
    EXPECT_GE(result["tree"]["candidates"], method.empty() ? 0 : 27);
    return contact;
  };
  EXPECT_EQ(patterns("--method polyhedral --facets 8"), patterns(""));
}

// Algorithm 5.8.
TEST_F(Command, ListsTheCandidatesOfPolyhedralFriction) {
  const auto file = in_folder("result.json");
  const auto run =
      shell(ranks(2) + command + " patterns " + truss +
            " --mu 0.65 --method polyhedral --facets 8 --candidates --order breadth-first" +
            " --output " + quoted(file));
  EXPECT_EQ(run.exit_code, 0) << run.output;
  EXPECT_THAT(run.output, HasSubstr("polyhedral t*  t* of (23)"));
  const auto result = nlohmann::json::parse(content(file))["result"];
  const auto& candidates = result["candidates"];
  EXPECT_EQ(candidates.size(), result["tree"]["candidates"]);
  std::set<nlohmann::json> kept;
  for (const auto& candidate : candidates) {
    EXPECT_EQ(candidate["discarded"], candidate["margin_upper"] < 0);
    if (candidate["discarded"] == false) kept.insert(candidate["contact"]);
  }
  std::set<nlohmann::json> patterns;
  for (const auto& pattern : result["patterns"]) patterns.insert(pattern["contact"]);
  EXPECT_EQ(kept, patterns);
  EXPECT_GT(kept.size(), 20U);
}

TEST_F(Command, StopsAtALimitAndGoesOnFromItsCheckpoint) {
  const std::string call = command + " patterns " + truss + " --mu 1.0 --output ";
  const auto whole = in_folder("whole.json");
  ASSERT_EQ(shell(call + quoted(whole)).exit_code, 0);

  const auto part = in_folder("part.json");
  const auto stopped =
      shell(ranks(2) + call + quoted(part) + " --node-limit 300 --checkpoint " + argument("state"));
  EXPECT_EQ(stopped.exit_code, 3) << stopped.output;
  EXPECT_THAT(stopped.output, HasSubstr("Stopped early (node-limit)"));
  EXPECT_THAT(stopped.output, HasSubstr("--restart"));
  const auto json = nlohmann::json::parse(content(part));
  EXPECT_EQ(json["status"], "node-limit");
  EXPECT_GT(json["result"]["tree"]["open"], 0);
  EXPECT_LT(json["result"]["count"], 251);

  // Started again as if new, it does not overwrite what the night has brought.
  const auto anew = shell(call + quoted(part) + " --checkpoint " + argument("state"));
  EXPECT_EQ(anew.exit_code, 2);
  EXPECT_THAT(anew.output, HasSubstr("exists already; expected --restart " + in_folder("state")));
  // It is the checkpoint of another tree.
  const auto other =
      shell(command + " patterns " + truss + " --mu 0.9 --restart " + argument("state"));
  EXPECT_EQ(other.exit_code, 2);
  EXPECT_THAT(other.output, HasSubstr("another problem"));

  const auto rest = in_folder("rest.json");
  const auto resumed = shell(ranks(3) + call + quoted(rest) + " --restart " + argument("state"));
  EXPECT_EQ(resumed.exit_code, 0) << resumed.output;
  EXPECT_EQ(without_statistics(rest), without_statistics(whole));
}

// The truss of examples/two-bars.toml so many times over, one not knowing of the other.
std::string many_wedges(int count) {
  std::string nodes;
  std::string bars[2];
  std::string supports;
  std::string tips;
  for (int i = 0; i < count; ++i) {
    nodes += fmt::format("left{0} = [0.0, {1}.0]\ntop{0} = [1.0, {2}.0]\ntip{0} = [1.0, {1}.0]\n",
                         i, 10 * i, 10 * i + 1);
    bars[0] += fmt::format("['left{0}', 'tip{0}'],", i);
    bars[1] += fmt::format("['top{0}', 'tip{0}'],", i);
    supports += fmt::format("'left{0}', 'top{0}',", i);
    tips += fmt::format("'tip{0}',", i);
  }
  return fmt::format(
      "name = 'many'\ndimension = 2\nunits = {{length = 'm', force = 'kN'}}\n[nodes]\n{}"
      "[[members]]\nEA = 1.0\nbetween = [{}]\n[[members]]\nEA = 3.0\nbetween = [{}]\n"
      "[[supports]]\nnodes = [{}]\n[[contact]]\nnormal = [-1.0, 1.0]\nnodes = [{}]\n",
      nodes, bars[0], bars[1], supports, tips);
}

TEST_F(Command, SearchesAStructureThatComesApartPieceByPiece) {
  constexpr int pieces = 14;
  std::ofstream(in_folder("many.toml")) << many_wedges(pieces);
  const auto run = shell(command + " patterns " + argument("many.toml") + " --mu 3 --output " +
                         argument("result.json"));
  EXPECT_EQ(run.exit_code, 0) << run.output;
  const auto result = nlohmann::json::parse(content(in_folder("result.json")))["result"];
  EXPECT_EQ(result["count"], 1);  // all of them at once
  EXPECT_EQ(result["blocks"].size(), std::size_t{pieces});
  EXPECT_EQ(result["patterns"].size(), std::size_t{pieces});
  EXPECT_LE(result["tree"]["opened"], 3 * pieces + 1);
  EXPECT_EQ(result["patterns"][3]["block"], 4);
  EXPECT_EQ(result["patterns"][3]["contact"], std::vector<std::string>{"tip3"});
}

// A search of a second or more.
constexpr auto make_long = " example space-truss --rows 15 --depth 2 --output ";
constexpr auto long_friction = " --mu 0.52 ";

TEST_F(Command, ASignalEndsItWithACheckpointToGoOnFrom) {
  shell(command + make_long + argument("long.toml"));
  const auto call = command + " patterns " + argument("long.toml") + " --cuts none" + long_friction;
  const auto whole = in_folder("whole.json");
  ASSERT_EQ(shell(ranks(2) + call + " --quiet --output " + quoted(whole)).exit_code, 0);
  for (const std::string signal : {"TERM", "INT"}) {
    const auto state = in_folder(signal);
    // Once there is a checkpoint the command heeds signals.
    const auto stopped = shell(fmt::format(
        "{{ {} --checkpoint {} --checkpoint-interval 0.02 >{} & p=$!;"
        "   while [ ! -e {} ] && kill -0 $p; do sleep 0.01; done; kill -{} $p; wait $p; }}",
        call, quoted(state), argument("table"), quoted(state), signal));
    EXPECT_EQ(stopped.exit_code, 3) << stopped.output;
    EXPECT_THAT(stopped.output, HasSubstr("Stopped early (interrupted)"));
    const auto file = in_folder(signal + ".json");
    const auto resumed = shell(fmt::format("{} {} --quiet --restart {} --output {}", ranks(2), call,
                                           quoted(state), quoted(file)));
    EXPECT_EQ(resumed.exit_code, 0) << resumed.output;
    EXPECT_EQ(without_statistics(file), without_statistics(whole));
  }
}

TEST_F(Command, SIGUSR1AsksForACheckpointAndTheSearchGoesOn) {
  shell(command + " example space-truss --rows 10 --depth 4 --output " + argument("long.toml"));
  const auto state = in_folder("state");
  // It heeds signals from just after it has said what it does.
  const auto run = shell(fmt::format(
      "{{ {} patterns {} --mu 0.55 --cuts none --checkpoint {} >{} 2>{} & p=$!;"
      "   while [ ! -s {} ] && kill -0 $p; do sleep 0.01; done; sleep 0.2; kill -USR1 $p;"
      "   while [ ! -e {} ] && kill -0 $p; do sleep 0.01; done; kill -TERM $p; wait $p; }}",
      command, argument("long.toml"), quoted(state), argument("table"), argument("log"),
      argument("log"), quoted(state)));
  EXPECT_EQ(run.exit_code, 3) << content(in_folder("log"));
  // The first asked for by SIGUSR1, the second at the end: it had gone on.
  EXPECT_THAT(files(),
              testing::IsSupersetOf({"state", "state.previous", "state.1.0", "state.2.0"}));
}

// ---- certificates -------------------------------------------------------------------------------

// The lines of a certificate that speak of nodes, each once, in an order of their own.
std::vector<std::string> node_lines(const std::string& name) {
  std::ifstream file(name);
  std::vector<std::string> lines;
  for (std::string line; std::getline(file, line);) {
    if (line.starts_with("dead") || line.starts_with("alive") || line.starts_with("marginal"))
      lines.push_back(line);
  }
  std::sort(lines.begin(), lines.end());
  lines.erase(std::unique(lines.begin(), lines.end()), lines.end());
  return lines;
}

// The whole of a certificate anew from the lines before its "end", with the right digest.
std::string sealed(const std::string& name) {
  return fmt::format(
      "{{ sed -i '/^end /,$d' {0} && echo \"end $(sed '1,/^nodes$/d' {0} | wc -l)\" >>{0} &&"
      "   echo \"digest $(sha1sum <{0} | cut -d' ' -f1)\" >>{0}; }}",
      name);
}

TEST_F(Command, ProvesItsListOfPatterns) {
  const auto run =
      shell(command + " patterns " + truss + " --mu 0.65 --certificate " + argument("cert"));
  ASSERT_EQ(run.exit_code, 0) << run.output;
  EXPECT_EQ(files(), std::vector<std::string>{"cert"});
  const auto proved = shell(command + " verify " + argument("cert"));
  EXPECT_EQ(proved.exit_code, 0);
  EXPECT_THAT(proved.output, HasSubstr(" nodes cover all 1024 sign patterns, each once"));
  EXPECT_THAT(proved.output, HasSubstr("PROVED: the list of 27 patterns is complete"));
  const auto quiet = shell(command + " verify --quiet " + argument("cert"));
  EXPECT_EQ(quiet.exit_code, 0);
  EXPECT_EQ(quiet.output, "");
  // Its digest is no secret of the program's.
  EXPECT_EQ(shell(fmt::format("test \"digest $(head -n -1 {0} | sha1sum | cut -d' ' -f1)\" = "
                              "\"$(tail -n 1 {0})\"",
                              argument("cert")))
                .exit_code,
            0);
}

TEST_F(Command, ProvesAllButWhatIsMarginal) {
  std::ofstream(in_folder("rod.toml")) << rod_along_normal;
  shell(command + " patterns " + argument("rod.toml") + " --mu 1.1 --certificate " +
        argument("cert"));
  const auto run = shell(command + " verify " + argument("cert"));
  EXPECT_EQ(run.exit_code, 3) << run.output;
  EXPECT_THAT(run.output, testing::ContainsRegex("PROVED but for [0-9]* marginal node"));
}

TEST_F(Command, TheCertificateAndTheVerdictAreTheSameOnAnyNumberOfRanks) {
  const auto search = command + " patterns " + truss + " --mu 1.0 --quiet --certificate ";
  const auto alone = in_folder("alone");
  ASSERT_EQ(shell(search + quoted(alone) + " --serial").exit_code, 0);
  const auto expected = shell(command + " verify " + quoted(alone));
  ASSERT_EQ(expected.exit_code, 0) << expected.output;
  for (int count = 1; count <= 3; ++count) {
    const auto file = in_folder(fmt::format("np{}", count));
    const auto searched = shell(ranks(count) + search + quoted(file));
    ASSERT_EQ(searched.exit_code, 0) << searched.output;
    EXPECT_EQ(node_lines(file), node_lines(alone)) << count << " ranks";
    const auto run = shell(ranks(count) + command + " verify " + quoted(file));
    EXPECT_EQ(run.exit_code, 0) << run.output;
    EXPECT_EQ(run.output, expected.output) << count << " ranks";
  }
  EXPECT_EQ(files(), (std::vector<std::string>{"alone", "np1", "np2", "np3"}));
}

TEST_F(Command, RefusesASpoiltCertificateOnAnyNumberOfRanks) {
  const auto cert = argument("cert");
  shell(command + " patterns " + truss + " --mu 0.65 --certificate " + cert);
  const auto verdict = [&](const std::string& launch, const std::string& change) {
    return shell(fmt::format("cp {0} {1} && {2} && {3} && {4} {5} verify {1}", cert,
                             argument("spoilt"), change, sealed(argument("spoilt")), launch,
                             command));
  };
  for (const auto& launch : {std::string{}, ranks(3)}) {
    const auto missing = verdict(launch, "sed -i '0,/^alive/{/^alive/d}' " + argument("spoilt"));
    EXPECT_EQ(missing.exit_code, 1);
    EXPECT_THAT(missing.output, HasSubstr("refused: no node covers contact {"));
    EXPECT_THAT(missing.output, HasSubstr("\nNOT PROVED\n"));
    const auto steeper =
        verdict(launch, "sed -i '/^friction/s/0x1.4/0x1.f/g' " + argument("spoilt"));
    EXPECT_EQ(steeper.exit_code, 1);
    EXPECT_THAT(steeper.output, HasSubstr("its multipliers do not rule out a reaction at"));
    EXPECT_THAT(steeper.output, HasSubstr("refused: dead contact {"));
  }
}

TEST_F(Command, SaysThatACertificateWasAltered) {
  const auto cert = argument("cert");
  shell(command + " patterns " + truss + " --mu 0.65 --certificate " + cert);
  shell("sed -i '0,/^alive/s/^alive/dead/' " + cert);
  for (const auto& launch : {std::string{}, ranks(2)}) {
    const auto run = shell(launch + command + " verify " + cert);
    EXPECT_EQ(run.exit_code, 2);
    EXPECT_THAT(run.output, HasSubstr(in_folder("cert") + ": was altered: digest '"));
  }
}

TEST_F(Command, RefusesWrongCallsAboutCertificates) {
  const std::string good = "patterns " + truss + " --mu 0.5 ";
  // A part that a checkpoint can go on with.
  std::ofstream(in_folder("state")) << "kusabi-checkpoint";
  std::ofstream(in_folder("cert.part.1.0"))
      << "part of the tree 0 of the checkpoint " << in_folder("state") << '\n';
  ASSERT_EQ(mkfifo(in_folder("pipe").c_str(), 0600), 0);
  const std::vector<std::string> wrong{
      "verify",
      "verify " + argument("none"),
      "verify " + quoted(folder_.string()),
      "verify " + truss,
      good + "--certificate /nowhere/at/all",
      good + "--certificate " + quoted(folder_.string()),
      good + "--certificate " + argument("pipe"),
      good + "--certificate " + truss,
      good + "--certificate " + argument("cert"),
      good + "--certificate " + argument("same") + " --output " + argument("same"),
  };
  for (const auto& call : wrong) {
    const auto run = shell(command + " " + call);
    EXPECT_EQ(run.exit_code, 2) << call;
    EXPECT_EQ(std::count(run.output.begin(), run.output.end(), '\n'), 1) << run.output;
  }
  EXPECT_EQ(files(), (std::vector<std::string>{"cert.part.1.0", "pipe", "state"}));
}

TEST_F(Command, ACertificateIsNotKeptFromItsPlaceByPartsOfTheDead) {
  std::ofstream(in_folder("cert.part.1.0")) << "part of the tree 0\nmarginal 1 0 0\n";
  std::ofstream(in_folder("cert.part.3.1"))
      << "part of the tree 0 of the checkpoint " << in_folder("gone") << '\n';
  const auto run =
      shell(command + " patterns " + truss + " --mu 0.5 --quiet --certificate " + argument("cert"));
  EXPECT_EQ(run.exit_code, 0) << run.output;
  EXPECT_EQ(files(), std::vector<std::string>{"cert"});
}

TEST_F(Command, ACertificateThatIsBeingWrittenIsNotTouched) {
  std::ofstream(in_folder("cert.part.1.0")) << "part of the tree 0\n";
  const int part = open(in_folder("cert.part.1.0").c_str(), O_WRONLY | O_CLOEXEC);
  ASSERT_EQ(flock(part, LOCK_EX), 0);
  const auto run =
      shell(command + " patterns " + truss + " --mu 0.5 --quiet --certificate " + argument("cert"));
  close(part);
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_THAT(run.output, HasSubstr("is being written by another search"));
  EXPECT_EQ(files(), std::vector<std::string>{"cert.part.1.0"});
}

TEST_F(Command, ACertificateGoesOnFromACheckpoint) {
  const std::string call = command + " patterns " + truss + " --mu 1.0 --quiet";
  const auto with = " --certificate " + argument("cert");
  const auto stopped =
      shell(ranks(2) + call + with + " --node-limit 300 --checkpoint " + argument("state"));
  EXPECT_EQ(stopped.exit_code, 3) << stopped.output;
  EXPECT_THAT(stopped.output, HasSubstr("what is proved so far is in " + in_folder("cert.part.*")));
  EXPECT_THAT(files(), testing::IsSupersetOf({"cert.part.1.0", "cert.part.1.1"}));
  // Not as if nothing had been, not under another name, and not of another tree.
  const auto anew = shell(call + with);
  EXPECT_EQ(anew.exit_code, 2);
  EXPECT_THAT(anew.output, HasSubstr("is in the way, a part of a search that did not end; "
                                     "expected --restart " +
                                     in_folder("state")));
  const auto rest = " --restart " + argument("state");
  const auto other = shell(call + rest + " --certificate " + argument("other"));
  EXPECT_EQ(other.exit_code, 2);
  EXPECT_THAT(other.output, HasSubstr("expected the name that it began with"));
  // What was being written when a run was killed.
  std::ofstream(in_folder("cert.part.1.0"), std::ios::app) << "dead 1 2 0x1.8";
  const auto again = shell(ranks(3) + call + with + rest);
  EXPECT_EQ(again.exit_code, 0) << again.output;
  EXPECT_THAT(files(), testing::Each(testing::Not(HasSubstr(".part."))));
  const auto whole = in_folder("whole");
  ASSERT_EQ(shell(call + " --certificate " + quoted(whole)).exit_code, 0);
  EXPECT_EQ(node_lines(in_folder("cert")), node_lines(whole));
  EXPECT_EQ(shell(command + " verify " + argument("cert")).exit_code, 0);
}

TEST_F(Command, ACertificateNeedsACheckpointToGoOnFrom) {
  const auto run = shell(command + " patterns " + truss +
                         " --mu 1.0 --quiet --node-limit 300 --certificate " + argument("cert"));
  EXPECT_EQ(run.exit_code, 3);
  EXPECT_THAT(run.output, HasSubstr("no certificate"));
  EXPECT_TRUE(files().empty());
}

TEST_F(Command, ACertificateOutlivesAKilledSearch) {
  shell(command + make_long + argument("long.toml"));
  const auto call = command + " patterns " + argument("long.toml") + " --cuts none" +
                    long_friction + " --certificate " + argument("cert");
  const auto state = argument("state");
  shell(
      fmt::format("{{ {} --checkpoint {} --checkpoint-interval 0.02 >{} 2>&1 & p=$!;"
                  "   while [ ! -e {} ] && kill -0 $p; do sleep 0.01; done; sleep 0.05;"
                  "   kill -KILL $p; wait $p; }}",
                  call, state, argument("log"), state));
  const auto resumed = shell(ranks(2) + call + " --quiet --restart " + state);
  ASSERT_EQ(resumed.exit_code, 0) << resumed.output;
  const auto run = shell(ranks(2) + command + " verify " + argument("cert"));
  EXPECT_EQ(run.exit_code, 0) << run.output;
  EXPECT_THAT(run.output, HasSubstr("cover all 2^30 sign patterns, each once"));
}

TEST_F(Command, SaysThatTheDiskIsFullForTheCertificate) {
  // A file may have 4096 bytes, and who writes more is told and not killed.
  const auto run = shell("trap '' XFSZ; ulimit -f 8; " + command + " patterns " + truss +
                         " --mu 1.0 --certificate " + argument("cert"));
  EXPECT_EQ(run.exit_code, 1) << run.output;
  EXPECT_THAT(run.output, HasSubstr("251 sign patterns"));
  EXPECT_THAT(run.output, HasSubstr("cert: a part could not be written in full"));
}

TEST_F(Command, WritesATraceOfAllRanksAndTheSameResult) {
  const std::string call = command + " patterns " + truss + " --mu 1.0 --quiet --output ";
  const auto plain = in_folder("plain.json");
  ASSERT_EQ(shell(call + quoted(plain)).exit_code, 0);
  const auto file = in_folder("result.json");
  const auto trace = in_folder("trace.json");
  for (int count = 1; count <= 2; ++count) {
    const auto run = shell(ranks(count) + call + quoted(file) + " --trace " + quoted(trace));
    ASSERT_EQ(run.exit_code, 0) << run.output;
    EXPECT_EQ(without_statistics(file), without_statistics(plain));
    const auto events = nlohmann::json::parse(content(trace))["traceEvents"];
    std::vector<double> work_ends(static_cast<std::size_t>(count), 0);
    for (const auto& event : events) {
      ASSERT_LT(event["pid"], count);
      if (event["ph"] != "X" || event["tid"] != 0) continue;
      auto& end = work_ends[event["pid"].get<std::size_t>()];
      // Times are written to the nanosecond; their sums are rounded.
      constexpr double rounding = 1e-3;
      EXPECT_GE(event["ts"].get<double>(), end - rounding);
      EXPECT_GE(event["dur"].get<double>(), 0);
      end = event["ts"].get<double>() + event["dur"].get<double>();
    }
    for (const double end : work_ends) EXPECT_GT(end, 0);
  }
  EXPECT_EQ(files(), (std::vector<std::string>{"plain.json", "result.json", "trace.json"}));
}

TEST_F(Command, WritesExamplesThatItCanSolve) {
  const auto file = in_folder("truss.toml");
  const auto call = command + " example space-truss ";
  EXPECT_EQ(shell(call + "--output " + quoted(file)).exit_code, 0);
  EXPECT_EQ(shell(call).output, content(file));
  const auto solved = shell(command + " patterns " + quoted(file) + " --mu 0.65");
  EXPECT_THAT(solved.output, HasSubstr("27 sign patterns"));

  const auto small = shell(call + "--rows 3 --depth 2 --bays 1 --output " + quoted(file));
  EXPECT_EQ(small.exit_code, 0) << small.output;
  EXPECT_THAT(shell(command + " patterns " + quoted(file) + " --mu 1").output,
              HasSubstr("6 contact candidates"));

  const auto wrong = shell(ranks(2) + call + "--rows 3 --bays 4");
  EXPECT_EQ(wrong.exit_code, 2);
  EXPECT_THAT(wrong.output, HasSubstr("expected no more bays than rows"));
}

// By hand (docs/problem-files.md): these two bars wedge if and only if mu is at least 2.
TEST_F(Command, MultipliesTheFrictionOfEachCandidate) {
  const auto file = in_folder("bars.toml");
  std::ofstream(file) << content(std::string(KUSABI_SOURCE_DIR) + "/examples/two-bars.toml")
                      << "friction_factor = 4\n";
  const auto patterns = [&](const std::string& mu) {
    return shell(command + " patterns " + quoted(file) + " --mu " + mu).output;
  };
  EXPECT_THAT(patterns("0.49"), HasSubstr("\n0 sign patterns"));
  EXPECT_THAT(patterns("0.51"), HasSubstr("\n1 sign pattern of wedged configurations at friction "
                                          "coefficient 0.51 times that of each candidate"));
}

TEST_F(Command, HelpsAndTellsItsVersion) {
  const auto help = shell(command + " patterns --help");
  EXPECT_EQ(help.exit_code, 0);
  EXPECT_THAT(help.output, HasSubstr("--mu"));
  EXPECT_EQ(shell(command + " --help").exit_code, 0);
  EXPECT_THAT(shell(command + " --version").output, HasSubstr("kusabi "));
  // The manual has what help has.
  const auto manual = shell(command + " --manual");
  EXPECT_EQ(manual.exit_code, 0);
  EXPECT_TRUE(manual.output.starts_with(".TH KUSABI 1")) << manual.output;
  EXPECT_THAT(manual.output, HasSubstr("\\fB\\-\\-checkpoint\\-interval\\fR"));
}

TEST_F(Command, TheProtocolHoldsUnderThousandsOfSchedules) {
  const auto run = shell(command + " bench schedules --seeds 3000");
  EXPECT_EQ(run.exit_code, 0) << run.output;
  EXPECT_THAT(run.output, HasSubstr("3000 schedules, 0 failed"));
}

TEST_F(Command, ShowsHowFarTheSearchScales) {
  // A quarter of a million nodes in virtual time: 64 ranks with four thousand each.
  const auto run = shell(command + " bench scaling --nodes 262144 --node-us 100 --most-ranks 64");
  EXPECT_EQ(run.exit_code, 0) << run.output;
  const auto last = run.output.rfind("\n", run.output.size() - 2) + 1;
  int ranks = 0;
  double efficiency = 0;
  ASSERT_EQ(std::sscanf(run.output.c_str() + last, "%d %lf", &ranks, &efficiency), 2);
  EXPECT_EQ(ranks, 64);
  EXPECT_GE(efficiency, 0.9);
}

TEST_F(Command, NeverCallsMpiWhenSerial) {
  // Under a launcher, with Open MPI told to use a component that does not exist: whoever calls
  // MPI_Init fails.
  const auto call = "env OMPI_COMM_WORLD_SIZE=1 OMPI_MCA_pml=none_such timeout 60 " + command +
                    " patterns " + truss + " --mu 0.55";
#ifndef OPEN_MPI
  GTEST_SKIP() << "it is not built with Open MPI";
#endif
  EXPECT_NE(shell(call).exit_code, 0);
  const auto run = shell(call + " --serial");
  EXPECT_EQ(run.exit_code, 0) << run.output;
  EXPECT_THAT(run.output, HasSubstr("1 sign pattern "));
}

TEST_F(Command, RefusesToDoTheSerialSearchOnEveryRank) {
  const auto run = shell("env OMPI_COMM_WORLD_SIZE=2 OMPI_MCA_pml=none_such timeout 60 " + command +
                         " patterns " + truss + " --mu 0.55 --serial");
  EXPECT_EQ(run.exit_code, 2) << run.output;
  EXPECT_THAT(run.output, HasSubstr("--serial under mpirun"));
}

const std::string plane_truss =
    quoted(std::string(KUSABI_SOURCE_DIR) + "/examples/plane-truss.toml");

TEST_F(Command, RefusesRaysOfMoreCandidatesThanItCanTellApart) {
  const auto file = in_folder("tall.toml");
  ASSERT_EQ(shell(command + " example plane-truss --rows 65 --output " + quoted(file)).exit_code,
            0);
  for (const auto& launch : {std::string{}, ranks(2)}) {
    const auto run = shell(launch + command + " rays " + quoted(file) + " --mu 0.65");
    EXPECT_EQ(run.exit_code, 2) << run.output;
    EXPECT_THAT(run.output, HasSubstr(file + ": 65 contact candidates; expected at most 64"));
    EXPECT_THAT(run.output, testing::Not(HasSubstr("double description")));
  }
}

// The rays and the cones of a result, byte for byte.
std::string rays_and_cones(const std::string& file) {
  const auto text = content(file);
  const auto from = text.find("\"rays\": [");
  const auto to = text.find("\"health\"");
  EXPECT_NE(from, std::string::npos);
  EXPECT_NE(to, std::string::npos);
  return text.substr(from, to - from);
}

TEST_F(Command, ShowsTheTableOfRays) {
  const auto run = shell(command + " rays " + plane_truss + " --mu 0.65");
  EXPECT_EQ(run.exit_code, 0);
  EXPECT_THAT(run.output, HasSubstr("16 extremal rays in 1 maximal cone at friction"));
  EXPECT_THAT(run.output, HasSubstr("      1      16  r1…5 | -\n"));
}

TEST_F(Command, FindsTheSameRaysByBothMethodsOnAnyNumberOfRanks) {
  const auto file = in_folder("truss.toml");
  ASSERT_EQ(shell(command + " example plane-truss --rows 8 --output " + quoted(file)).exit_code, 0);
  const std::string call = command + " rays " + quoted(file) + " --mu 0.8 --quiet --output ";
  const auto whole = in_folder("whole.json");
  ASSERT_EQ(shell(call + quoted(whole) + " --method double-description").exit_code, 0);
  const auto serial = in_folder("serial.json");
  ASSERT_EQ(shell(call + quoted(serial) + " --method tree --serial").exit_code, 0);
  EXPECT_EQ(rays_and_cones(serial), rays_and_cones(whole));
  for (int count = 2; count <= 3; ++count) {
    for (const std::string method : {"tree", "double-description"}) {
      const auto parallel = in_folder("parallel.json");
      const auto run = shell(ranks(count) + call + quoted(parallel) + " --method " + method);
      ASSERT_EQ(run.exit_code, 0) << run.output;
      EXPECT_EQ(without_statistics(parallel),
                without_statistics(method == "tree" ? serial : whole));
    }
  }
  const auto result = nlohmann::json::parse(content(whole))["result"];
  EXPECT_EQ(result["count"], 776U);  // tests/reference/plane-truss.json
  EXPECT_EQ(result["rays"].size(), 776U);
  EXPECT_EQ(result["cones"].size(), 82U);
  std::size_t number = 0;
  for (const auto& ray : result["rays"]) EXPECT_EQ(ray["number"], ++number);
}

// The first is large enough for steps to be shared; of the second the tree is faster, as its trial
// shows, so both ways come to an end there.
TEST_F(Command, FindsTheSameRaysTheSameWayOnAnyNumberOfRanks) {
  const auto file = in_folder("truss.toml");
  const std::vector<std::pair<std::string, std::string>> trusses{
      {"--paper --rows 19", "double-description"}, {"--brace all --rows 13", "tree"}};
  for (const auto& [size, method] : trusses) {
    ASSERT_EQ(shell(command + " example plane-truss " + size + " > " + quoted(file)).exit_code, 0);
    const std::string call = command + " rays " + quoted(file) + " --mu 0.65 --quiet --output ";
    const auto alone = in_folder("alone.json");
    ASSERT_EQ(shell(call + quoted(alone)).exit_code, 0);
    EXPECT_EQ(nlohmann::json::parse(content(alone))["options"]["method"], method);
    for (int count = 2; count <= 3; ++count) {
      const auto parallel = in_folder("parallel.json");
      const auto run = shell(ranks(count) + call + quoted(parallel));
      ASSERT_EQ(run.exit_code, 0) << run.output;
      EXPECT_EQ(without_statistics(parallel), without_statistics(alone));
    }
  }
}

TEST_F(Command, GivesTheRaysOfEachConeAndWhatEachNodeDoes) {
  const auto file = in_folder("rays.json");
  ASSERT_EQ(
      shell(command + " rays " + plane_truss + " --mu 0.7 --output " + quoted(file)).exit_code, 0);
  const auto json = nlohmann::json::parse(content(file));
  EXPECT_EQ(json["status"], "solved");
  const auto& result = json["result"];
  for (const auto& cone : result["cones"]) {
    std::set<std::string> touched;
    std::set<std::string> left;
    for (const std::size_t number : cone["rays"]) {
      const auto& ray = result["rays"][number - 1];
      for (std::size_t i = 0; i < 5; ++i) {
        const std::string node = json["problem"]["contact"][i]["node"];
        const double normal = ray["reaction"][i][0];
        const double tangential = ray["reaction"][i][1];
        const double gap = ray["displacement"][i][0];
        const std::string state = ray["state"][i];
        if (normal > 0) touched.insert(node);
        if (gap > 0) left.insert(node);
        EXPECT_EQ(state == "separates", gap > 0);
        EXPECT_EQ(state == "sticks", normal > 0 && std::abs(tangential) < 0.6999999 * normal);
        EXPECT_EQ(state == "slides +", normal > 0 && tangential > 0.6999999 * normal);
        EXPECT_EQ(state == "slides -", normal > 0 && tangential < -0.6999999 * normal);
      }
    }
    EXPECT_EQ(touched, cone["contact"].get<std::set<std::string>>());
    EXPECT_EQ(left, cone["separated"].get<std::set<std::string>>());
  }
}

TEST_F(Command, WritesRaysAsCsvAndTheirGraphForGraphviz) {
  const auto csv = in_folder("rays.csv");
  const auto dot = in_folder("rays.dot");
  const auto json = in_folder("rays.json");
  const auto run = shell(fmt::format("{} rays {} --mu 0.65 --csv {} --dot {} --output {}", command,
                                     plane_truss, quoted(csv), quoted(dot), quoted(json)));
  ASSERT_EQ(run.exit_code, 0) << run.output;
  const auto rays = nlohmann::json::parse(content(json))["result"]["rays"];
  std::ifstream lines(csv);
  std::string line;
  std::getline(lines, line);
  EXPECT_THAT(line, testing::StartsWith("ray,state,\"r_n r1\","));
  for (std::size_t number = 0; number < 16; ++number) {
    ASSERT_TRUE(std::getline(lines, line));
    int read = 0;
    double first = 0;
    ASSERT_EQ(std::sscanf(line.c_str(), "%d,\"%*[^\"]\",%lf", &read, &first), 2) << line;
    EXPECT_EQ(read, static_cast<int>(number) + 1);
    EXPECT_EQ(first, rays[number]["reaction"][0][0]);
    EXPECT_EQ(std::count(line.begin(), line.end(), ','), 21);
  }
  EXPECT_FALSE(std::getline(lines, line));
  // One cone, of all 16.
  const auto graph = content(dot);
  std::size_t edges = 0;
  for (auto at = graph.find(" -- "); at != std::string::npos; at = graph.find(" -- ", at + 1))
    ++edges;
  EXPECT_EQ(edges, 16U);
}

TEST_F(Command, DrawsNoGraphThatNobodyCouldRead) {
  const auto file = in_folder("many.toml");
  ASSERT_EQ(shell(command + " example plane-truss --rows 7 --output " + quoted(file)).exit_code, 0);
  const auto run = shell(command + " rays " + quoted(file) + " --mu 1 --dot " +
                         argument("rays.dot") + " --output " + argument("rays.json"));
  EXPECT_EQ(run.exit_code, 0);
  const auto count =
      nlohmann::json::parse(content(in_folder("rays.json")))["result"]["rays"].size();
  ASSERT_GT(count, 200U);
  EXPECT_THAT(run.output,
              HasSubstr(fmt::format("--dot: {} rays are more than a graph shows", count)));
  EXPECT_LT(content(in_folder("rays.dot")).size(), 200U);
}

// By hand (docs/problem-files.md): r_t = 2 r_n, one ray from mu = 2 on.
TEST_F(Command, FindsTheRayOfTheTwoBarsAtEachCandidatesOwnFriction) {
  const auto file = in_folder("bars.toml");
  std::ofstream(file) << content(std::string(KUSABI_SOURCE_DIR) + "/examples/two-bars.toml")
                      << "friction_factor = 4\n";
  const auto rays = [&](const std::string& mu) {
    return shell(command + " rays " + quoted(file) + " --mu " + mu).output;
  };
  EXPECT_THAT(rays("0.49"), HasSubstr("\n0 extremal rays in 0 maximal cones"));
  EXPECT_THAT(rays("0.51"), HasSubstr("\n1 extremal ray in 1 maximal cone at friction coefficient "
                                      "0.51 times that of each candidate"));
  EXPECT_THAT(rays("0.51"), HasSubstr("x  r_n          1\n            r_t          2\n"));
}

TEST_F(Command, RefusesRaysInSpaceAndSaysWhatToUse) {
  const auto run = shell(command + " rays " + truss + " --mu 0.65");
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_THAT(run.output, HasSubstr("dimension is 3; expected 2"));
  EXPECT_THAT(run.output, HasSubstr("use kusabi patterns instead\n"));
  const auto on_two = shell(ranks(2) + command + " rays " + truss + " --mu 0.65");
  EXPECT_EQ(on_two.exit_code, 2);
  EXPECT_THAT(on_two.output, HasSubstr("dimension is 3; expected 2"));
}

TEST_F(Command, StopsTheTreeOfRaysAtALimitWithAPartialAnswer) {
  const auto file = in_folder("rays.json");
  const auto call =
      command + " rays " + plane_truss + " --mu 1 --node-limit 1 --output " + quoted(file);
  const auto run = shell(call + " --method tree");
  EXPECT_EQ(run.exit_code, 3) << run.output;
  EXPECT_THAT(run.output, HasSubstr("Stopped early (node-limit): the list is not complete."));
  const auto json = nlohmann::json::parse(content(file));
  EXPECT_EQ(json["status"], "node-limit");
  EXPECT_EQ(json["options"]["method"], "tree");
  EXPECT_TRUE(json["result"]["cones"].empty());
  const auto refused = shell(call + " --method double-description");
  EXPECT_EQ(refused.exit_code, 2);
  EXPECT_THAT(refused.output, HasSubstr("or another method"));
}

// The tip of the two bars moves along the surface, which is across the third bar but for 1e-12:
// what the second candidate moves by is neither zero nor not.
TEST_F(Command, SaysWhenSmallNumbersCannotBeToldFromZero) {
  const auto file = in_folder("almost.toml");
  std::ofstream(file) << R"(
name = "almost idle"
dimension = 2
units = { length = "m", force = "kN" }
[nodes]
left = [0, 0]
top = [1, 1]
tip = [1, 0]
far = [2, -1.000000000004]
wall = [3, -1]
floor = [2, -2]
[[members]]
EA = 1
between = [["left", "tip"]]
[[members]]
EA = 3
between = [["top", "tip"]]
[[members]]
EA = 1
between = [["tip", "far"]]
[[members]]
EA = 1
between = [["far", "wall"], ["far", "floor"]]
[[supports]]
nodes = ["left", "top", "wall", "floor"]
[[contact]]
nodes = ["tip"]
normal = [-1, 1]
[[contact]]
nodes = ["far"]
normal = [1, 0]
)";
  const auto run = shell(command + " rays " + quoted(file) + " --mu 3");
  EXPECT_EQ(run.exit_code, 1) << run.output;
  EXPECT_THAT(run.output, HasSubstr("too close to zero to tell from it"));
}

TEST_F(Command, WritesPlaneTrussesOfAnyShape) {
  const auto file = in_folder("truss.toml");
  const auto run = shell(command +
                         " example plane-truss --rows 4 --bays 3 --width 6 --lean 20 "
                         "--brace all --output " +
                         quoted(file));
  ASSERT_EQ(run.exit_code, 0) << run.output;
  EXPECT_THAT(shell(command + " rays " + quoted(file) + " --mu 1").output,
              HasSubstr("16 nodes, 39 members, 4 contact candidates"));
  const auto refused = shell(command + " example plane-truss --lean 89");
  EXPECT_EQ(refused.exit_code, 2);
  EXPECT_THAT(refused.output, HasSubstr("expected 0 to 80 degrees"));
}

std::string example_file(const std::string& name) {
  return quoted(std::string(KUSABI_SOURCE_DIR) + "/examples/" + name);
}

TEST_F(Command, FindsTheSameWorstCaseOnOneAndTwoRanks) {
  // One that the root closes, with enough columns for ranks to share, and one for the tree; the
  // same of loads that act on several nodes at once.
  for (const std::string& call :
       {example_file("paper/limit-4x4.toml") + " --alpha 40",
        example_file("static-gap.toml") + " --alpha 0.45",
        example_file("gust.toml") + " --alpha 0.5",
        example_file("../tests/cases/correlated_gap.toml") + " --alpha 0.16368"}) {
    const auto options = " limit " + call + " --samples 40 --curve --output " +
                         argument("out.json") + " --certificate " + argument("cert");
    nlohmann::json alone;
    for (const std::string& launch : {std::string(), ranks(2)}) {
      const auto run = shell(launch + command + options);
      ASSERT_EQ(run.exit_code, 0) << run.output;
      auto json = nlohmann::json::parse(content(in_folder("out.json")));
      EXPECT_TRUE(json.erase("statistics"));
      EXPECT_GE(json["result"]["samples"]["least"], json["result"]["worst_case"]["lower"]);
      if (alone.is_null()) alone = json;
      EXPECT_EQ(json, alone);
      const auto proved = shell(launch + command + " verify " + argument("cert"));
      EXPECT_EQ(proved.exit_code, 0) << proved.output;
      EXPECT_THAT(proved.output, HasSubstr("PROVED: the least load factor"));
    }
  }
}

TEST_F(Command, StopsAWorstCaseAtALimitWithItsBracket) {
  const auto run =
      shell(command + " limit " + example_file("paper/limit-3x3.toml") +
            " --alpha 40 --cuts none --node-limit 50 --output " + argument("out.json"));
  EXPECT_EQ(run.exit_code, 3) << run.output;
  EXPECT_THAT(run.output, HasSubstr("Stopped early (node-limit)"));
  const auto json = nlohmann::json::parse(content(in_folder("out.json")));
  EXPECT_EQ(json["status"], "node-limit");
  const auto& bracket = json["result"]["worst_case"];
  EXPECT_LT(json["result"]["zero_one"]["lower"], 37.0120);  // tests/reference/limit.json
  EXPECT_NEAR(bracket["lower"], 37.0120, 1e-4);             // static cuts know it
  EXPECT_GE(bracket["upper"], 37.0120);
}

TEST_F(Command, RefusesACertificateThatClaimsTooMuch) {
  shell(command + " limit " + example_file("paper/limit-3x3.toml") +
        " --alpha 40 --quiet --certificate " + argument("cert"));
  auto text = content(in_folder("cert"));
  text.resize(text.rfind("digest "));
  // The same cuts and forces for half as strong members, and a load beyond its bounds.
  const auto spoilt = [&](const std::string& from, const std::string& to) {
    auto other = text;
    for (auto at = other.find(from); at != std::string::npos;
         at = other.find(from, at + to.size())) {
      other.replace(at, from.size(), to);
    }
    EXPECT_NE(other, text);
    std::ofstream(in_folder("other")) << other;
    const auto other_file = argument("other");
    shell("printf 'digest %s\\n' $(sha1sum < " + other_file + " | cut -d' ' -f1) >> " + other_file);
    return shell(command + " verify " + other_file);
  };
  const auto weak = spoilt("member 0x1.9p+9", "member 0x1.9p+8");
  EXPECT_EQ(weak.exit_code, 1) << weak.output;
  EXPECT_THAT(weak.output, HasSubstr("yields"));
  EXPECT_THAT(weak.output, HasSubstr("NOT PROVED"));
  const auto outside = spoilt("alpha 0x1.4p+5", "alpha 0x1.3p+5");
  EXPECT_EQ(outside.exit_code, 1) << outside.output;
  EXPECT_THAT(outside.output, HasSubstr("outside of its bounds"));
}

TEST_F(Command, SaysWhenALoadIsCarriedAtNoFactor) {
  const auto run =
      shell(command + " limit " + example_file("paper/limit-3x3.toml") + " --alpha 4000");
  EXPECT_EQ(run.exit_code, 0) << run.output;
  EXPECT_THAT(run.output, HasSubstr("some admissible dead load is carried at no load factor"));
}

TEST_F(Command, NamesTheSectionThatLimitAnalysisMisses) {
  const auto run = shell(command + " limit " + truss);
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_THAT(run.output, HasSubstr("a [[members]] group has no yield"));
  const auto other =
      shell(command + " patterns " + example_file("paper/limit-3x3.toml") + " --mu 0.5");
  EXPECT_EQ(other.exit_code, 2);
  EXPECT_THAT(other.output, HasSubstr("no contact candidates; expected at least one [[contact]]"));
}

TEST_F(Command, WritesGridsThatItReads) {
  shell(command + " example grid --bays 3 --output " + argument("grid.toml"));
  const auto run = shell(command + " limit " + argument("grid.toml") + " --alpha 20");
  EXPECT_EQ(run.exit_code, 0) << run.output;
  const auto wrong = shell(command + " example grid --bays 1");
  EXPECT_EQ(wrong.exit_code, 2);
  EXPECT_THAT(wrong.output, HasSubstr("a grid of 1 bays; expected 2 to 100"));
}

}  // namespace
