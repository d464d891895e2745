// `kusabi sweep`: compared with a call of `patterns` or `limit` at each point, on one rank and on
// two; its files read by other programs.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>
#include <string>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "shell.hpp"
#include "tests/nodes/limit/two_bars.hpp"

namespace kusabi::test {
namespace {

using testing::HasSubstr;
using Json = nlohmann::json;

std::string file_of(const std::string& name) {
  return quoted(std::string(KUSABI_SOURCE_DIR) + "/examples/" + name);
}

class SweepCommand : public Command {
 protected:
  Json document_of(const std::string& call, int exit_code = 0) const {
    const auto run = shell(command + ' ' + call + " --output " + argument("out.json"));
    EXPECT_EQ(run.exit_code, exit_code) << run.output;
    return Json::parse(content(in_folder("out.json")));
  }
  void expect_same_on_two_ranks(const std::string& call) const {
    auto alone = document_of(call);
    const auto run =
        shell(ranks(2) + command + ' ' + call + " --quiet --output " + argument("two.json"));
    EXPECT_EQ(run.exit_code, 0) << run.output;
    auto two = Json::parse(content(in_folder("two.json")));
    alone.erase("statistics");
    two.erase("statistics");
    EXPECT_EQ(alone.dump(), two.dump());
  }
  std::string refusal(const std::string& call) const {
    const auto run = shell(command + " sweep " + call + " --quiet");
    EXPECT_EQ(run.exit_code, 2) << run.output;
    EXPECT_EQ(std::ranges::count(run.output, '\n'), 1) << run.output;
    return run.output;
  }
};

TEST_F(SweepCommand, AgreesWithPatternsAtEachPoint) {
  for (const auto* name : {"paper/space-truss-fit.toml", "wedge-in-groove.toml"}) {
    const auto result = document_of("sweep " + file_of(name) + " --mu 0.3:0.9:0.2")["result"];
    ASSERT_EQ(result["points"].size(), 4U);
    for (const auto& point : result["points"]) {
      const double mu = point["mu"];
      const auto own = document_of(fmt::format("patterns {} --mu {}", file_of(name), mu))["result"];
      EXPECT_EQ(point["count"], own["count"]) << name << " " << mu;
      const auto on_it = [&](const Json& step) { return step["from"] <= mu && mu <= step["to"]; };
      const auto step = std::ranges::find_if(result["staircase"], on_it);
      ASSERT_NE(step, result["staircase"].end());
      EXPECT_EQ((*step)["count"], own["count"]);
    }
  }
}

TEST_F(SweepCommand, FindsTheCriticalCoefficientOfEveryPattern) {
  const auto file = file_of("plane-truss.toml");
  const auto swept = document_of("sweep " + file + " --mu-max 0.9")["result"];
  const auto critical =
      document_of("critical " + file + " --method bisection --mu-max 0.9")["result"];
  EXPECT_TRUE(swept["points"].empty());
  ASSERT_EQ(swept["patterns"].size(), critical["patterns"].size());
  EXPECT_GT(swept["patterns"].size(), 5U);
  for (std::size_t i = 0; i < swept["patterns"].size(); ++i) {
    for (const auto* key : {"contact", "separated", "lower", "upper"})
      EXPECT_EQ(swept["patterns"][i][key], critical["patterns"][i][key]) << i;
  }
}

TEST_F(SweepCommand, CountsTheSameOnTwoRanks) {
  expect_same_on_two_ranks("sweep " + file_of("peg-in-hole.toml") + " --mu 0.2,0.5,0.9");
}

TEST_F(SweepCommand, FindsTheSameWorstCasesOnTwoRanks) {
  expect_same_on_two_ranks("sweep " + file_of("static-gap.toml") + " --alpha 0.2,0.45");
}

// By hand: the bar carries 3, and the wind may take a quarter of 1.
TEST_F(SweepCommand, VariesTheLoadsWithoutAHalfWidthInTheFile) {
  const std::string wind = "[[uncertainty]]\nnodes = [\"tip\"]\naxes = [\"x\"]\nalpha = 0.25\n";
  const auto file = argument("open.toml");
  std::ofstream(in_folder("open.toml")) << limit::two_bars(wind) +
                                               "[[uncertainty]]\nname = \"crane\"\n" +
                                               "forces = [{ nodes = [\"tip\"], force = [1, 0] }]\n";
  const auto result = document_of("sweep " + file + " --alpha 0:1:0.5")["result"];
  ASSERT_EQ(result["points"].size(), 3U);
  for (const auto& point : result["points"]) {
    for (const auto* end : {"lower", "upper"}) {
      const auto& bound = point["maximum"][end];
      EXPECT_EQ(bound["standing"], "proved");
      EXPECT_NEAR(bound["value"].get<double>(), 2.75 - point["alpha"].get<double>(), 1e-8);
    }
  }
  EXPECT_TRUE(result["curve"].empty());
  const auto drawn =
      shell(command + " draw " + argument("out.json") + " --output " + argument("o.svg"));
  EXPECT_EQ(drawn.exit_code, 0) << drawn.output;

  auto displaced = content(in_folder("open.toml"));
  for (const std::string yield : {"yield = {", "yield = 5"})
    displaced.insert(displaced.find(yield), "EA = 1\n");
  displaced.insert(displaced.find("[[loads]]"), "displacement = [0.1, 0]\n");
  std::ofstream(in_folder("displaced.toml")) << displaced;
  EXPECT_THAT(shell(command + " sweep " + argument("displaced.toml") + " --alpha 1").output,
              HasSubstr("sweep --alpha ignores temperature and displaced supports"));

  std::ofstream(in_folder("closed.toml")) << limit::two_bars(wind);
  EXPECT_THAT(refusal(argument("closed.toml") + " --alpha 1"),
              HasSubstr("expected uncertain loads without alpha"));
}

TEST_F(SweepCommand, AgreesWithLimitAtEachPoint) {
  const auto file = file_of("paper/limit-3x3.toml");
  const auto result = document_of("sweep " + file + " --alpha 0:40:10")["result"];
  ASSERT_EQ(result["points"].size(), 5U);
  for (const auto& point : result["points"]) {
    const auto call = fmt::format("limit {} --alpha {}", file, point["alpha"].get<double>());
    const auto own = document_of(call)["result"];
    for (const auto* key : {"minimum", "maximum"}) EXPECT_EQ(point[key], own[key]);
  }
  const auto curve = document_of("limit " + file + " --alpha 40 --curve")["result"]["worst_curve"];
  ASSERT_EQ(result["curve"].size(), curve.size());
  ASSERT_EQ(curve.size(), 2U);
  for (std::size_t i = 0; i < curve.size(); ++i) {
    EXPECT_DOUBLE_EQ(result["curve"][i]["from"], 40 * curve[i]["from"].get<double>());
    EXPECT_EQ(result["curve"][i]["factor_to"], curve[i]["factor_to"]);
  }
}

TEST_F(SweepCommand, WritesACertificateOfEachHalfWidth) {
  const auto file = file_of("paper/limit-3x3.toml");
  const auto swept = " sweep " + file + " --certificate " + argument("proofs");
  EXPECT_EQ(shell(command + swept + " --alpha 0:40:12.5").exit_code, 0);
  for (const auto* alpha : {"0", "12.5", "25", "37.5"}) {
    const auto run = shell(fmt::format("{} verify {} --problem {}", command,
                                       argument(fmt::format("proofs/{}.cert", alpha)), file));
    EXPECT_EQ(run.exit_code, 0) << run.output;
    EXPECT_THAT(run.output, HasSubstr("PROVED"));
    EXPECT_THAT(run.output, HasSubstr(fmt::format("alpha = {} is between", alpha)));
  }
}

TEST_F(SweepCommand, WritesACertificateOfEachList) {
  const auto file = file_of("two-bars.toml");
  const auto swept = " sweep " + file + " --mu 1,3 --certificate " + argument("lists");
  const auto run = shell(command + swept);
  EXPECT_EQ(run.exit_code, 0) << run.output;
  EXPECT_THAT(run.output, HasSubstr("Exact arithmetic proves this"));
  EXPECT_THAT(run.output, HasSubstr("wrote " + in_folder("lists")));
  std::map<std::string, std::string> proved;
  for (const auto& entry : std::filesystem::directory_iterator(in_folder("lists"))) {
    const auto check =
        shell(fmt::format("{} verify {} --problem {}", command,
                          argument("lists/" + entry.path().filename().string()), file));
    EXPECT_EQ(check.exit_code, 0) << check.output;
    proved[entry.path().stem()] = check.output.substr(check.output.find("PROVED"));
  }
  ASSERT_EQ(proved.size(), 4U);  // both points, and both ends of the step at 2
  for (const auto& [coefficient, sentence] : proved)
    EXPECT_THAT(sentence,
                HasSubstr(std::stod(coefficient) < 2 ? "the list of 0 patterns is complete"
                                                     : "the list of 1 pattern is complete"));
  EXPECT_THAT(refusal(file + " --mu 1 --certificate lists --resume state"),
              HasSubstr("expected --certificate without --resume"));
}

TEST_F(SweepCommand, SaysWhatTheExactTestHasProved) {
  const auto call = command + " sweep " + file_of("two-bars.toml") + " --mu 1,3";
  EXPECT_THAT(shell(call).output, HasSubstr("there is 1 sign pattern (computed, not proved)."));
  const auto run = shell(call + " --prove --output " + argument("out.json"));
  EXPECT_EQ(run.exit_code, 0) << run.output;
  EXPECT_THAT(run.output, testing::Not(HasSubstr("computed")));
  EXPECT_THAT(run.output, HasSubstr("Exact arithmetic proves this"));
  const auto result = Json::parse(content(in_folder("out.json")))["result"];
  EXPECT_EQ(result["infeasible"]["standing"], "proved");
}

TEST_F(SweepCommand, GivesEachBoundOfALoadFactorItsOwnStandingInCsv) {
  const auto run = shell(command + " sweep " + file_of("gust.toml") + " --alpha 0:0.6:0.3 --csv " +
                         argument("c.csv"));
  EXPECT_EQ(run.exit_code, 0) << run.output;
  std::istringstream lines(content(in_folder("c.csv")));
  std::string line;
  std::getline(lines, line);
  EXPECT_EQ(line,
            "row,alpha,lower,lower_standing,upper,upper_standing,carried_from,"
            "carried_from_standing,state");
  while (std::getline(lines, line)) {
    EXPECT_EQ(std::ranges::count(line, ','), 8) << line;
    EXPECT_THAT(line,
                testing::ContainsRegex("^(point|breakpoint),[^,]*,[^,]+,proved,[^,]+,proved,"));
  }
  EXPECT_THAT(run.output, HasSubstr("each factor is within "));
}

TEST_F(SweepCommand, WritesPointsAndStepsAsCsvAndSvg) {
  const auto run = shell(command + " sweep " + file_of("two-bars.toml") + " --mu 1,2,3 --csv " +
                         argument("c.csv") + " --svg " + argument("c.svg"));
  EXPECT_EQ(run.exit_code, 3) << run.output;  // 2 is critical
  EXPECT_THAT(run.output, HasSubstr("within a bracket in which a pattern first sticks"));
  const auto csv = content(in_folder("c.csv"));
  EXPECT_THAT(csv, HasSubstr("row,mu,count,known,open\npoint,1,0,0,0\npoint,2,,0,1\npoint,3,1,1,0\n"
                             "from,0,0,0,0\n"));
  const auto svg = content(in_folder("c.svg"));
  EXPECT_THAT(svg, HasSubstr("<desc id=\"desc\">It cannot stick up to"));
  EXPECT_THAT(svg, HasSubstr("prefers-color-scheme: dark"));
  EXPECT_THAT(svg, testing::EndsWith("</svg>\n"));
}

TEST_F(SweepCommand, HasNoUnknownPointsIfStopped) {
  const auto document =
      document_of("sweep " + file_of("space-truss.toml") +
                      " --mu 0.5,0.8 --node-limit 3 --quiet --svg " + argument("c.svg"),
                  3);
  EXPECT_EQ(document["status"], "node-limit");
  EXPECT_TRUE(document["result"]["points"].empty());
}

TEST_F(SweepCommand, RefusesInvalidPoints) {
  const auto file = file_of("two-bars.toml");
  EXPECT_THAT(refusal(file), HasSubstr("expected --mu, --mu-max or --alpha"));
  EXPECT_THAT(refusal(file + " --mu 1 --alpha 1"), HasSubstr("expected --mu or --alpha"));
  EXPECT_THAT(refusal(file + " --mu 1,x"), HasSubstr("--mu: '1,x', expected START:END:STEP"));
  EXPECT_THAT(refusal(file + " --mu 1:2"), HasSubstr("--mu: '1:2', expected START:END:STEP"));
  EXPECT_THAT(refusal(file + " --mu 1:2:0"), HasSubstr("STEP above 0"));
  EXPECT_THAT(refusal(file + " --mu 2,1"), HasSubstr("expected numbers that increase"));
  EXPECT_THAT(refusal(file + " --mu 0,1"), HasSubstr("expected numbers above 0"));
  EXPECT_THAT(refusal(file + " --mu 1:2:1e-9"), HasSubstr("no more than 10000 points"));
  EXPECT_THAT(refusal(file + " --mu 1,2 --mu-max 1.5"), HasSubstr("the last point of --mu, 2"));
  EXPECT_THAT(refusal(file + " --mu 1 --width 2"), HasSubstr("--width 2: expected a number below"));
  EXPECT_THAT(refusal(file + " --alpha 1"), HasSubstr("two-bars.toml"));
}

}  // namespace
}  // namespace kusabi::test
