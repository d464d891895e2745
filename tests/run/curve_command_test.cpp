// Curves of `kusabi limit`: compared with one run per point, and read as files by other programs.
#include <algorithm>
#include <cmath>
#include <fstream>
#include <limits>
#include <sstream>
#include <string>
#include <tuple>
#include <vector>

#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include "shell.hpp"

namespace kusabi::test {
namespace {

using testing::HasSubstr;
using Json = nlohmann::json;
using Names = std::vector<std::string>;

std::string path_of_example(const std::string& name) {
  return std::string(KUSABI_SOURCE_DIR) + "/examples/" + name;
}

const std::string three = quoted(path_of_example("paper/limit-3x3.toml"));
const std::string gap = quoted(path_of_example("static-gap.toml"));

class CurveCommand : public Command {
 protected:
  Json result_of(const std::string& call) const {
    const auto run = shell(command + " limit " + call + " --output " + argument("out.json"));
    EXPECT_EQ(run.exit_code, 0) << run.output;
    return Json::parse(content(in_folder("out.json")))["result"];
  }
  void write(const std::string& name, const std::string& text) const {
    std::ofstream(in_folder(name)) << text;
  }
  /// Message for a call with the load file `text`.
  std::string refusal(const std::string& text, const std::string& more = "") const {
    write("load", text);
    const auto run =
        shell(command + " limit " + three + " --quiet --curve-load " + argument("load") + more);
    EXPECT_EQ(run.exit_code, 2) << run.output;
    EXPECT_EQ(std::ranges::count(run.output, '\n'), 1) << run.output;
    return run.output;
  }
};

double value_of(const Json& pieces, double beta) {
  for (const auto& piece : pieces) {
    const double from = piece["from"];
    const double to = piece["to"];
    if (beta > to) continue;
    const double share = (beta - from) / (to - from);
    return (1 - share) * piece["factor_from"].get<double>() +
           share * piece["factor_to"].get<double>();
  }
  return -std::numeric_limits<double>::infinity();
}

// Some of these are decided by the tree of signs.
TEST_F(CurveCommand, WorstCaseIsThatOfARunAtEachPlace) {
  const auto curves = result_of(gap + " --alpha 0.45 --curve --curve-to 1.5");
  const auto& pieces = curves["worst_curve"];
  EXPECT_GE(pieces.size(), 4U);
  for (int step = 0; step <= 16; ++step) {
    const double beta = 1.5 * step / 16;
    const auto place = result_of(fmt::format("{} --alpha {}", gap, beta * 0.45))["maximum"];
    if (beta > curves["worst_curve_end"]["carried_at"]) {
      EXPECT_TRUE(place["upper"].is_null()) << beta;
      continue;
    }
    double error = 0;
    for (const auto& piece : pieces) error = std::max(error, piece["error"].get<double>());
    EXPECT_LT(error, 1e-7);
    EXPECT_GE(value_of(pieces, beta), place["lower"]["value"].get<double>() - error) << beta;
    EXPECT_LE(value_of(pieces, beta), place["upper"]["value"].get<double>() + error) << beta;
  }
}

// The load is written among the dead loads of another problem file.
TEST_F(CurveCommand, GivenLoadHasTheFactorOfARunAtEachPlace) {
  const auto group = [](double beta) {
    return fmt::format("nodes = [\"1,3\", \"3,2\"]\nforce = [{}, {}]\n", beta * 30.0, beta * -90.0);
  };
  write("load.toml", "[[loads]]\n" + group(1));
  const auto curves = result_of(three + " --curve-to 9 --curve-load " + argument("load.toml"));
  EXPECT_FALSE(curves.contains("curve"));
  const auto& pieces = curves["load_curve"];
  EXPECT_GE(pieces.size(), 2U);
  for (int step = 0; step <= 18; ++step) {
    const double beta = 0.5 * step;
    write("loaded.toml", content(path_of_example("paper/limit-3x3.toml")) +
                             "\n[[loads]]\nkind = \"dead\"\n" + group(beta));
    const auto place = result_of(argument("loaded.toml"))["nominal"];
    if (curves.contains("load_curve_end") && beta > curves["load_curve_end"]["carried_at"]) {
      EXPECT_TRUE(place.is_null()) << beta;
    } else {
      EXPECT_NEAR(value_of(pieces, beta), place.get<double>(), 1e-7) << beta;
    }
  }
}

// (A) to (D) of Figure 5 of the limit paper: the critical load for 20 kN, doubled.
TEST_F(CurveCommand, FollowsTheCriticalLoadOfAnEarlierResult) {
  shell(command + " limit " + three + " --alpha 20 --output " + argument("twenty.json"));
  const auto followed =
      result_of(three + " --curve-to 2 --curve-load " + argument("twenty.json"))["load_curve"];
  ASSERT_EQ(followed.size(), 1U);
  EXPECT_EQ(followed[0]["along_reference_load"], true);
  EXPECT_NEAR(followed[0]["factor_from"], 48.3662, 0.5e-4);
  EXPECT_NEAR(value_of(followed, 1), 44.3662, 0.5e-4);
  const auto same = result_of(three + " --alpha 20 --curve --curve-to 2")["curve"];
  EXPECT_NEAR(value_of(followed, 2), value_of(same, 2), 1e-9);
}

// Figure 10: no random load is worse than the worst case, and some are near the nominal one.
TEST_F(CurveCommand, RandomLoadsLieAboveTheWorstCase) {
  const auto found =
      result_of(quoted(path_of_example("paper/limit-4x4.toml")) + " --alpha 40 --samples 300");
  EXPECT_NEAR(found["nominal"].get<double>(), 14.2650, 0.5e-4);
  EXPECT_NEAR(found["maximum"]["lower"]["value"].get<double>(), 7.7296, 0.5e-4);
  EXPECT_EQ(found["samples"]["factors"].size(), 300U);
  EXPECT_GT(found["samples"]["least"], found["maximum"]["upper"]["value"]);
}

std::vector<std::string> cells_of(const std::string& line) {
  std::vector<std::string> cells(1);
  bool inside = false;
  for (const char c : line) {
    if (c == '"') {
      inside = !inside;
    } else if (c == ',' && !inside) {
      cells.emplace_back();
    } else {
      cells.back() += c;
    }
  }
  return cells;
}

TEST_F(CurveCommand, WritesEveryBreakpointAsCsv) {
  write("load.toml", "[[loads]]\nnodes = [\"f\"]\nforce = [0, 5]\n");
  const auto found = result_of(gap + " --alpha 0.45 --curve --curve-to 4 --curve-load " +
                               argument("load.toml") + " --curve-csv " + argument("curves.csv"));
  std::istringstream lines(content(in_folder("curves.csv")));
  std::string line;
  std::getline(lines, line);
  EXPECT_EQ(line, "curve,beta,load,factor,error,along_reference_load,tension,compression");
  for (const auto& [name, key, load] :
       {std::tuple("critical", "curve", 0.45), std::tuple("worst", "worst_curve", 0.45),
        std::tuple("load", "load_curve", 5.0)}) {
    const auto next = [&, curve = std::string(name), shared = load] {
      std::getline(lines, line);
      auto cells = cells_of(line);
      EXPECT_EQ(cells.size(), 8U) << line;
      cells.resize(8);
      EXPECT_EQ(cells[0], curve);
      EXPECT_EQ(std::stod(cells[2]), std::stod(cells[1]) * shared);
      return cells;
    };
    for (const auto& piece : found[key]) {
      const auto cells = next();
      EXPECT_EQ(std::stod(cells[1]), piece["from"].get<double>());
      EXPECT_EQ(std::stod(cells[3]), piece["factor_from"].get<double>());
      EXPECT_EQ(cells[4].empty(), std::string(key) != "worst_curve");
      EXPECT_EQ(cells[5], piece["along_reference_load"].get<bool>() ? "1" : "0");
      EXPECT_EQ(cells[6], fmt::format("{}", fmt::join(piece["tension"].get<Names>(), " ")));
      for (const auto& member : piece["yielding"].get<Names>()) {
        EXPECT_THAT(cells[6] + ' ' + cells[7], HasSubstr(member));
      }
    }
    const auto last = next();
    EXPECT_EQ(std::stod(last[3]), found[key].back()["factor_to"].get<double>());
    ASSERT_TRUE(found.contains(std::string(key) + "_end")) << key;
    const auto beyond = next();
    EXPECT_EQ(beyond[3], "");
    EXPECT_EQ(std::stod(beyond[1]),
              found[std::string(key) + "_end"]["not_carried_at"].get<double>());
  }
  EXPECT_FALSE(std::getline(lines, line)) << line;
}

TEST_F(CurveCommand, WritesTheSameOnOneAndTwoRanks) {
  write("load.toml", "[[loads]]\nnodes = [\"f\"]\nforce = [0, 5]\n");
  const auto options = " limit " + gap +
                       " --quiet --alpha 0.45 --curve --curve-to 2 --curve-load " +
                       argument("load.toml") + " --curve-csv " + argument("curves.csv") +
                       " --output " + argument("out.json");
  std::vector<std::string> tables;
  std::vector<Json> results;
  for (const std::string& launch : {std::string(), ranks(2)}) {
    const auto run = shell(launch + command + options);
    ASSERT_EQ(run.exit_code, 0) << run.output;
    tables.push_back(content(in_folder("curves.csv")));
    results.push_back(Json::parse(content(in_folder("out.json")))["result"]);
  }
  EXPECT_EQ(tables[0], tables[1]);
  EXPECT_EQ(results[0].dump(), results[1].dump());
}

TEST_F(CurveCommand, RefusesAnInvalidLoad) {
  const std::string group = "[[loads]]\nnodes = [\"1,3\"]\n";
  EXPECT_THAT(
      refusal("[[loads]]\nnodes = [\"1,33\"]\nforce = [1, 0]\n"),
      HasSubstr(R"(load:2:10: node "1,33" does not exist; expected a node of the problem file; )"
                R"(did you mean "1,3"?)"));
  EXPECT_THAT(refusal(group), HasSubstr("load:1:1: "));
  EXPECT_THAT(refusal(group + "force = [1, 0, 0]\n"), HasSubstr("load:3:9: "));
  EXPECT_THAT(refusal(group + "force = [inf, 0]\n"), HasSubstr("load:3:10: "));
  EXPECT_THAT(refusal(group + "force = [1, 0]\nkind = \"dead\"\n"), HasSubstr("load:4:1: "));
  EXPECT_THAT(refusal(""), HasSubstr("load:1:1: the file is empty"));
  EXPECT_THAT(refusal("[[loads]]\nnodes = [\"0,0\"]\nforce = [1, 0]\n"),
              HasSubstr("zero at all free displacements; expected"));
  EXPECT_THAT(refusal("{\"result\": {}}"), HasSubstr("not a result file with a critical_part"));
  EXPECT_THAT(refusal("{"), HasSubstr("not a result file with a critical_part"));
  EXPECT_THAT(refusal(R"({"result": {"critical_part": [{"node": "z", "force": [1, 0]}]}})"),
              HasSubstr("expected a result with the same nodes"));
  EXPECT_THAT(refusal(group + "force = [1, 0]\n", " --curve-csv " + argument("load")),
              HasSubstr("--curve-load"));
  EXPECT_THAT(refusal(group + "force = [1, 0]\n", " --curve-to 0"), HasSubstr("--curve-to"));
}

TEST_F(CurveCommand, RefusesOptionsOfCurvesWithoutACurve) {
  for (const std::string option : {"--curve-csv x.csv", "--curve-to 2"}) {
    const auto run = shell("cd " + quoted(folder_.string()) + " && " + command + " limit " + three +
                           " --alpha 40 " + option);
    EXPECT_EQ(run.exit_code, 2);
    EXPECT_THAT(run.output, HasSubstr("requires --curve or --curve-load"));
  }
  EXPECT_TRUE(files().empty());
}

}  // namespace
}  // namespace kusabi::test
