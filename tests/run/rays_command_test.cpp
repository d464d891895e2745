// kusabi rays as a user calls it, alone and under mpirun.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <fstream>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "shell.hpp"
#include "support/thorough.hpp"

namespace kusabi::test {
namespace {

using testing::HasSubstr;

using RaysCommand = Command;

const std::string plane_truss =
    quoted(std::string(KUSABI_SOURCE_DIR) + "/examples/plane-truss.toml");

TEST_F(RaysCommand, RefusesTooManyCandidates) {
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

TEST_F(RaysCommand, ShowsTheTableOfRays) {
  const auto run = shell(command + " rays " + plane_truss + " --mu 0.65");
  EXPECT_EQ(run.exit_code, 0);
  EXPECT_THAT(run.output, HasSubstr("16 extremal rays in 1 maximal cone at friction"));
  EXPECT_THAT(run.output, HasSubstr("      1      16  r1…5 | -\n"));
}

TEST_F(RaysCommand, FindsTheSameRaysByBothMethodsOnAnyNumberOfRanks) {
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

// The first is large enough for steps to be shared; for the second the tree is faster, as its trial
// shows, so both methods end there.
TEST_F(RaysCommand, ChoosesTheSameMethodOnAnyNumberOfRanks) {
  const auto file = in_folder("truss.toml");
  const std::vector<std::pair<std::string, std::string>> trusses{
      {"--paper --rows 19", "double-description"}, {"--brace all --rows 13", "tree"}};
  for (const auto& [size, method] : trusses) {
    ASSERT_EQ(shell(command + " example plane-truss " + size + " > " + quoted(file)).exit_code, 0);
    const std::string call = command + " rays " + quoted(file) + " --mu 0.65 --quiet --output ";
    const auto alone = in_folder("alone.json");
    ASSERT_EQ(shell(call + quoted(alone)).exit_code, 0);
    EXPECT_EQ(nlohmann::json::parse(content(alone))["statistics"]["method"], method);
    for (int count = 2; count <= (test::thorough ? 3 : 2); ++count) {
      const auto parallel = in_folder("parallel.json");
      const auto run = shell(ranks(count) + call + quoted(parallel));
      ASSERT_EQ(run.exit_code, 0) << run.output;
      EXPECT_EQ(without_statistics(parallel), without_statistics(alone));
    }
  }
}

TEST_F(RaysCommand, WritesTheRaysOfEachConeAndTheStateOfEachNode) {
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

TEST_F(RaysCommand, WritesRaysAsCsvAndTheirGraphForGraphviz) {
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

TEST_F(RaysCommand, OmitsAGraphOfTooManyRays) {
  const auto file = in_folder("many.toml");
  ASSERT_EQ(shell(command + " example plane-truss --rows 7 --output " + quoted(file)).exit_code, 0);
  const auto run = shell(command + " rays " + quoted(file) + " --mu 1 --dot " +
                         argument("rays.dot") + " --output " + argument("rays.json"));
  EXPECT_EQ(run.exit_code, 0);
  const auto count =
      nlohmann::json::parse(content(in_folder("rays.json")))["result"]["rays"].size();
  ASSERT_GT(count, 200U);
  EXPECT_THAT(run.output,
              HasSubstr(fmt::format("--dot: {} rays exceed the limit of a graph", count)));
  EXPECT_LT(content(in_folder("rays.dot")).size(), 200U);
}

// By hand (docs/problem-files.md): r_t = 2 r_n, one ray from mu = 2 on.
TEST_F(RaysCommand, FindsTheRayOfTheTwoBarsAtEachCandidatesOwnFriction) {
  const auto file = in_folder("bars.toml");
  std::ofstream(file) << content(std::string(KUSABI_SOURCE_DIR) + "/examples/two-bars.toml")
                      << "friction_factor = 4\n";
  const auto rays = [&](const std::string& mu) {
    return shell(command + " rays " + quoted(file) + " --mu " + mu).output;
  };
  EXPECT_THAT(rays("0.49"), HasSubstr("\n0 extremal rays in 0 maximal cones"));
  EXPECT_THAT(rays("0.51"), HasSubstr("\n1 extremal ray in 1 maximal cone at 0.51 times the "
                                      "friction given in the file"));
  EXPECT_THAT(rays("0.51"), HasSubstr("x  r_n          1\n            r_t          2\n"));
}

TEST_F(RaysCommand, RefusesRaysInSpaceAndNamesAnotherSubcommand) {
  const auto run = shell(command + " rays " + truss + " --mu 0.65");
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_THAT(run.output, HasSubstr("dimension is 3; expected 2"));
  EXPECT_THAT(run.output, HasSubstr("kusabi patterns has no such limit\n"));
  const auto on_two = shell(ranks(2) + command + " rays " + truss + " --mu 0.65");
  EXPECT_EQ(on_two.exit_code, 2);
  EXPECT_THAT(on_two.output, HasSubstr("dimension is 3; expected 2"));
}

TEST_F(RaysCommand, ProvesTheMaximalConesOrThatThereIsNoRay) {
  const auto verdict_of = [&](const std::string& words) {
    const auto run =
        shell(command + " rays " + words + " --prove --output " + argument("rays.json"));
    EXPECT_EQ(run.exit_code, 0) << run.output;
    return std::pair(nlohmann::json::parse(content(in_folder("rays.json"))), run.output);
  };
  const auto [found, table] = verdict_of(plane_truss + " --mu 0.8");
  const auto& answer = found["result"];
  EXPECT_EQ(answer["proved_cones"], found["result"]["cones"].size());
  EXPECT_EQ(answer["standing"], "computed");  // of the rays in them
  EXPECT_THAT(table, HasSubstr(fmt::format("in {} maximal cones at friction coefficient 0.8, by",
                                           found["result"]["cones"].size())));
  EXPECT_THAT(table, HasSubstr("\nproved: the candidates in contact and separated of these cones, "
                               "and that there is no other cone; the numbers of the rays are "
                               "computed, not proved\n"));
  const auto page = shell(command + " report " + argument("rays.json"));
  EXPECT_THAT(page.output, HasSubstr("exact arithmetic proves these cones, and that there is no "
                                     "other."));
  const auto [none, sentence] = verdict_of(plane_truss + " --mu 0.45");
  EXPECT_EQ(none["result"]["standing"], "proved");
  EXPECT_EQ(none["result"]["grounds"], "exact-arithmetic");
  EXPECT_THAT(sentence, HasSubstr("It cannot stick at friction coefficient 0.45."));
}

TEST_F(RaysCommand, StopsTheTreeAtALimitWithAPartialAnswer) {
  const auto file = in_folder("rays.json");
  const auto call =
      command + " rays " + plane_truss + " --mu 1 --node-limit 1 --output " + quoted(file);
  const auto run = shell(call + " --method tree");
  EXPECT_EQ(run.exit_code, 3) << run.output;
  EXPECT_THAT(run.output, HasSubstr("Stopped early (node-limit): the list is not complete."));
  EXPECT_THAT(run.output, HasSubstr("\n0 extremal rays are known at friction coefficient 1, by"));
  const auto json = nlohmann::json::parse(content(file));
  EXPECT_EQ(json["status"], "node-limit");
  EXPECT_EQ(json["statistics"]["method"], "tree");
  EXPECT_TRUE(json["result"]["cones"].empty());
  const auto refused = shell(call + " --method double-description");
  EXPECT_EQ(refused.exit_code, 2);
  EXPECT_THAT(refused.output, HasSubstr("or another method"));
}

// The tip of the two bars moves along the surface, orthogonal to the third bar up to 1e-12:
// it is numerically undecided whether the displacement of the second candidate is zero.
TEST_F(RaysCommand, ReportsNumbersThatCannotBeDistinguishedFromZero) {
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
  EXPECT_EQ(run.exit_code, 3) << run.output;
  EXPECT_THAT(run.output, HasSubstr("cannot be distinguished from zero"));
}

}  // namespace
}  // namespace kusabi::test
