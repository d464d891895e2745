// Permitted values of options, and the call that the table makes from them.
#include "run/command/option_table.hpp"

#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace {

using namespace kusabi::run;

std::string taken(OptionTable& table, const std::string& name, const std::string& text) {
  for (auto& row : table.rows()) {
    if (row.name != name) continue;
    auto wrong = row.store(text);
    if (wrong.empty()) row.given = text;
    return wrong;
  }
  return "no such row";
}

TEST(OptionTable, AcceptsOnlyNumbersInTheirRange) {
  double positive = 0;
  int even = 0;
  std::uint64_t count = 7;
  std::optional<double> perhaps;
  OptionTable table;
  table.number("--positive", &positive, above(0), "");
  Range range = between(4, 64);
  range.even = true;
  table.number("--even", &even, range, "");
  table.number("--count", &count, at_least(0), "");
  table.number("--perhaps", &perhaps, at_least(0), "");
  EXPECT_EQ(taken(table, "--positive", "1e-300"), "");
  EXPECT_EQ(positive, 1e-300);
  EXPECT_EQ(taken(table, "--positive", "0"), "'0', expected a number above 0");
  EXPECT_EQ(taken(table, "--positive", "1e999"), "'1e999', expected a number above 0");
  EXPECT_EQ(taken(table, "--positive", "3 "), "'3 ', expected a number above 0");
  EXPECT_EQ(positive, 1e-300);
  EXPECT_EQ(taken(table, "--even", "64"), "");
  EXPECT_EQ(taken(table, "--even", "5"), "'5', expected an even number from 4 to 64");
  EXPECT_EQ(taken(table, "--even", "66"), "'66', expected an even number from 4 to 64");
  EXPECT_EQ(taken(table, "--count", "18446744073709551615"), "");
  EXPECT_EQ(count, std::numeric_limits<std::uint64_t>::max());
  EXPECT_EQ(taken(table, "--count", "-1"), "'-1', expected a whole number of 0 or more");
  EXPECT_EQ(taken(table, "--count", "2.5"), "'2.5', expected a whole number of 0 or more");
  EXPECT_EQ(taken(table, "--perhaps", "0"), "");
  EXPECT_EQ(perhaps, 0.0);
}

TEST(OptionTable, HasTheDefaultValuesOfOptions) {
  double no_limit = std::numeric_limits<double>::infinity();
  double required = 0;
  double usual = 1e-8;
  std::optional<double> none;
  OptionTable table;
  table.number("--no-limit", &no_limit, above(0), "");
  table.number("--required", &required, above(0), "").required();
  table.number("--usual", &usual, above(0), "").unit("m");
  table.number("--none", &none, above(0), "");
  EXPECT_EQ(table.find("--no-limit")->default_value, "");
  EXPECT_EQ(table.find("--required")->default_value, "");
  EXPECT_EQ(table.find("--usual")->default_value, "1e-08");
  EXPECT_EQ(table.find("--none")->default_value, "");
  EXPECT_EQ(table.find("--nothing"), nullptr);
}

TEST(OptionTable, ReadsADurationInSecondsOrWithItsUnits) {
  double interval = 600;
  double wait = 30;
  OptionTable table;
  table.duration("--interval", interval, above(0), "");
  table.duration("--wait", wait, at_least(0), "");
  EXPECT_EQ(table.find("--interval")->default_value, "600s");
  EXPECT_EQ(taken(table, "--interval", "1e-6"), "");
  EXPECT_EQ(interval, 1e-6);
  EXPECT_EQ(taken(table, "--interval", "1h30m"), "");
  EXPECT_EQ(interval, 5400);
  const std::string expected = "expected a number above 0, in seconds, or 90s, 1h30m";
  for (const std::string wrong : {"0", "-1", "90x", ""})
    EXPECT_EQ(taken(table, "--interval", wrong), "'" + wrong + "', " + expected);
  EXPECT_EQ(interval, 5400);
  EXPECT_EQ(taken(table, "--wait", "0"), "");
  EXPECT_EQ(wait, 0);
}

TEST(OptionTable, ReadsAChoiceByItsName) {
  enum class Way { here, there };
  Way way = Way::there;
  OptionTable table;
  table.choice("--way", way, {{"here", Way::here}, {"there", Way::there}}, "");
  EXPECT_EQ(table.find("--way")->default_value, "there");
  EXPECT_EQ(table.find("--way")->value, "here|there");
  EXPECT_EQ(taken(table, "--way", "her"), "'her', expected one of here, there");
  EXPECT_EQ(way, Way::there);
  EXPECT_EQ(taken(table, "--way", "here"), "");
  EXPECT_EQ(way, Way::here);
}

TEST(OptionTable, RepeatsTheCallFromTheGivenOptions) {
  std::string file;
  double mu = 0;
  bool tighten = true;
  kusabi::engine::Limits limits;
  OptionTable table;
  table.file("file", file, Role::input, "");
  table.number("--mu", &mu, above(0), "");
  table.flag("--no-tighten", tighten, "", false);
  table.search_limits(limits);
  table.quiet();
  EXPECT_EQ(taken(table, "file", "it's a truss.toml"), "");
  EXPECT_EQ(taken(table, "--mu", "0.50"), "");
  EXPECT_EQ(taken(table, "--no-tighten", ""), "");
  EXPECT_EQ(taken(table, "--node-limit", "9"), "");
  EXPECT_FALSE(tighten);
  const auto at_nodes = [](const OptionRow& row) {
    return row.stops == kusabi::engine::Status::node_limit;
  };
  EXPECT_EQ(table.call(at_nodes), R"( 'it'\''s a truss.toml' --mu 0.50 --no-tighten)");
}

TEST(OptionTable, ReadsPointsOfARangeAsDecimals) {
  std::vector<double> points;
  OptionTable table;
  table.points("--mu", points, above(0), "");
  EXPECT_EQ(taken(table, "--mu", "0.1:0.4:0.1"), "");
  EXPECT_EQ(points, (std::vector<double>{0.1, 0.2, 0.3, 0.4}));
  EXPECT_EQ(taken(table, "--mu", "0.5,2"), "");
  EXPECT_EQ(points, (std::vector<double>{0.5, 2}));
  EXPECT_EQ(taken(table, "--mu", "0,2"), "'0,2', expected numbers above 0");
  EXPECT_EQ(taken(table, "--mu", "2,2"), "'2,2', expected numbers that increase");
  EXPECT_EQ(taken(table, "--mu", "1:2:1e-9"), "'1:2:1e-9', expected no more than 10000 points");
  for (const std::string wrong : {"2:1:1", "1:2:0", "1:2"}) {
    EXPECT_EQ(taken(table, "--mu", wrong),
              "'" + wrong + "', expected START:END:STEP with START not above END and STEP above 0");
  }
  EXPECT_EQ(points, (std::vector<double>{0.5, 2}));
}

TEST(OptionTable, ReadsHalfWidthsOfNamesWithSeparators) {
  std::vector<std::pair<std::string, double>> groups;
  OptionTable table;
  table.group_alpha(groups);
  EXPECT_EQ(taken(table, "--group-alpha", "wind=20, a=b,c=3"), "");
  EXPECT_EQ(groups, (std::vector<std::pair<std::string, double>>{{"wind", 20}, {"a=b,c", 3}}));
  for (const std::string wrong : {"wind", "wind=x", "wind=-1", "wind=2,snow"})
    EXPECT_TRUE(
        taken(table, "--group-alpha", wrong).starts_with("'" + wrong + "', expected NAME="));
}

TEST(OptionTable, HasTheOptionsOfTheAnswerWithTheirTypes) {
  enum class Way { here, there };
  Way way = Way::here;
  double width = 0.5;
  int count = 3;
  std::optional<double> nothing;
  std::vector<double> points;
  std::vector<std::pair<std::string, double>> groups;
  std::string name;
  std::string file;
  bool quick = false;
  kusabi::engine::Limits limits;
  OptionTable table;
  table.problem(file);
  table.choice("--way", way, {{"here", Way::here}, {"there", Way::there}}, "");
  table.number("--width", &width, above(0), "");
  table.number("--count", &count, above(0), "").needs("--way", "there");
  table.number("--no-thing", &nothing, above(0), "");
  table.points("--mu", points, above(0), "");
  table.group_alpha(groups);
  table.load_case(name);
  table.flag("--quick", quick, "");
  table.output();
  table.lines(quick, "");
  table.search_limits(limits);
  table.quiet_and_serial();
  const auto defaults = nlohmann::ordered_json::parse(
      R"({"way": "here", "width": 0.5, "count": null, "no_thing": null, "mu": null,
          "group_alpha": null, "case": null, "quick": false})");
  EXPECT_EQ(table.asked(), defaults);
  for (const auto& [option, text] :
       std::vector<std::pair<std::string, std::string>>{{"--way", "there"},
                                                        {"--width", "1e-3"},
                                                        {"--mu", "1:2:1"},
                                                        {"--group-alpha", "a=1"},
                                                        {"--case", "1"},
                                                        {"--quick", ""},
                                                        {"--node-limit", "7"},
                                                        {"--output", "f"}})
    EXPECT_EQ(taken(table, option, text), "");
  const auto given = nlohmann::ordered_json::parse(
      R"({"way": "there", "width": 0.001, "count": 3, "no_thing": null, "mu": [1.0, 2.0],
          "group_alpha": {"a": 1.0}, "case": "1", "quick": true})");
  EXPECT_EQ(table.asked(), given);
}

}  // namespace
