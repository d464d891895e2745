// Text of tables: words, and widths of pages.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "shell.hpp"
#include "terminal.hpp"

namespace {

using namespace kusabi::test;
using testing::HasSubstr;
using testing::Not;
using Json = nlohmann::json;

std::string example(const std::string& name) {
  return quoted(std::string(KUSABI_SOURCE_DIR) + "/examples/" + name);
}

std::string without_colours(const std::string& text) {
  std::string plain;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '\033') {
      i = std::min(text.find_first_of("mK", i), text.size());
    } else if (text[i] != '\r') {
      plain += text[i];
    }
  }
  return plain;
}

// Displayed text: UTF-8 characters.
std::size_t width(const std::string& line) {
  return static_cast<std::size_t>(std::ranges::count_if(
      line, [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; }));
}

std::string last_line(std::string text) {
  while (!text.empty() && text.back() == '\n') text.pop_back();
  return text.substr(text.rfind('\n') + 1);
}

std::string in_one_line(const std::string& text) {
  std::istringstream in(text);
  std::string line;
  for (std::string word; in >> word;) line += (line.empty() ? "" : " ") + word;
  return line;
}

// Lines that can be folded; file names cannot.
std::size_t longest_line(const std::string& text) {
  std::istringstream lines(text);
  std::size_t maximum = 0;
  for (std::string line; std::getline(lines, line);) {
    if (in_one_line(line).find(' ') != std::string::npos) maximum = std::max(maximum, width(line));
  }
  return maximum;
}

class TableText : public Command {
 protected:
  // Standard output only; the result is in r.json.
  std::string answer(const std::string& call, int code = 0) const {
    const auto run =
        shell("(" + command + " " + call + " --output " + argument("r.json") + " 2>/dev/null)");
    EXPECT_EQ(run.exit_code, code) << run.output;
    return run.output;
  }
  [[nodiscard]] Json result() const { return Json::parse(content(in_folder("r.json"))); }
  [[nodiscard]] std::string page() const {
    const auto run = shell(command + " report " + argument("r.json") + " --output " +
                           argument("page.html") + " --quiet");
    EXPECT_EQ(run.exit_code, 0) << run.output;
    return content(in_folder("page.html"));
  }
};

// The first sentence of the last line of the table is that of the page.
TEST_F(TableText, AgreesWithTheReport) {
  for (const std::string& call :
       {"patterns " + truss + " --mu 0.65", "patterns " + truss + " --mu 0.3", "critical " + truss,
        "critical " + truss + " --mu-max 0.4", "rays " + example("plane-truss.toml") + " --mu 0.65",
        "limit " + example("gust.toml"), "limit " + example("gust.toml") + " --alpha 0.5",
        "limit " + example("gust.toml") + " --alpha 20"}) {
    const auto said = last_line(answer(call));
    const auto end = std::min(said.find(". "), said.size() - 1) + 1;
    EXPECT_GT(end, 20U) << call;
    EXPECT_THAT(page(), HasSubstr(">" + said.substr(0, end))) << call;
  }
}

TEST_F(TableText, BeginsWithItsHeading) {
  EXPECT_TRUE(answer("patterns " + truss + " --mu 0.65").starts_with("kusabi ")) << "a heading";
  EXPECT_THAT(answer("patterns " + truss + " --mu 0.65"), HasSubstr("space truss: in space, "));
}

// From the reactions in the file: the least mu r_n - |r_t| of candidates in contact, the least gap
// of the others, and the candidate with the largest |r_t| / r_n.
TEST_F(TableText, HasTheMarginOfTheInequalityNearestToFailing) {
  const auto said = answer("patterns " + truss + " --mu 0.65");
  const auto all = result()["result"]["patterns"];
  const auto best = *std::ranges::max_element(
      all, {}, [](const Json& pattern) { return pattern["margin"].get<double>(); });
  const auto contact = best["contact"].get<std::vector<std::string>>();
  double slack = 1e9;
  double gap = 1e9;
  double steepest = 0;
  std::string open;
  std::string slips;
  const auto names = result()["problem"]["contact"];
  for (std::size_t i = 0; i < names.size(); ++i) {
    const auto name = names[i]["node"].get<std::string>();
    const auto r = best["reaction"][i].get<std::vector<double>>();
    if (std::ranges::find(contact, name) == contact.end()) {
      const auto u = best["displacement"][i][0].get<double>();
      if (u < gap) open = name;
      gap = std::min(gap, u);
      continue;
    }
    const double tangential = std::hypot(r[1], r[2]);
    slack = std::min(slack, 0.65 * r[0] - tangential);
    if (tangential / r[0] > steepest) slips = name;
    steepest = std::max(steepest, tangential / r[0]);
  }
  EXPECT_NEAR(slack, best["margin"].get<double>(), 1e-6) << "the margin is a slack of friction";
  EXPECT_THAT(said, HasSubstr(fmt::format("mu r_n - |r_t| = {:.3g} kN", slack)));
  EXPECT_THAT(said,
              HasSubstr(fmt::format("{} is closest to touching, at a gap of {:.3g} m", open, gap)));
  EXPECT_THAT(said, HasSubstr(fmt::format("a friction coefficient of {}; with less, {} ",
                                          std::ceil(1e5 * steepest) / 1e5, slips)));
}

TEST_F(TableText, ReportsThatAFlatPatternHasNoMargin) {
  const auto file = quoted(std::string(KUSABI_SOURCE_DIR) + "/tests/cases/critical_flat_grid.toml");
  EXPECT_THAT(
      answer("patterns " + file + " --mu 3"),
      AllOf(
          HasSubstr(
              "\nYes, it can stick at friction coefficient 3, in one way. The only way is contact "
              "at "),
          HasSubstr(", without a margin: some inequality is an equality.")));
}

TEST_F(TableText, IsSortedByCriticalFrictionOnRequest) {
  const auto table = answer("patterns " + truss + " --mu 0.65 --sort critical");
  const auto patterns = result()["result"]["patterns"];
  answer("critical " + truss + " --method bisection --width 1e-4 --mu-max 0.65");
  std::map<Json, std::pair<double, double>> other;
  const auto brackets = result()["result"]["patterns"];
  for (const auto& each : brackets) other[each["contact"]] = {each["lower"], each["upper"]};
  ASSERT_EQ(patterns.size(), 27U);
  ASSERT_EQ(other.size(), patterns.size());
  std::vector<std::pair<double, std::size_t>> order;
  for (std::size_t i = 0; i < patterns.size(); ++i) {
    const double lower = patterns[i]["critical_friction"]["lower"];
    const double upper = patterns[i]["critical_friction"]["upper"];
    const auto [from, to] = other.at(patterns[i]["contact"]);
    EXPECT_LT(upper - lower, 1e-7);
    EXPECT_LT(from, upper);
    EXPECT_GT(to, lower);
    order.emplace_back(upper, i);
  }
  std::ranges::sort(order);
  std::size_t at = 0;
  for (const auto& [upper, i] : order) {
    const auto found = table.find(fmt::format("\n{:>5}  ", i + 1), at);
    ASSERT_NE(found, std::string::npos) << i + 1;
    EXPECT_EQ(table.substr(found + 18, 13), fmt::format("  {:>11}", fmt::format("{:.6g}", upper)));
    at = found;
  }
  // The same on two ranks.
  const auto alone = shell(command + " patterns " + truss + " --mu 0.65 --sort critical --output " +
                           argument("1.json"));
  const auto two = shell(ranks(2) + command + " patterns " + truss +
                         " --mu 0.65 --sort critical --output " + argument("2.json"));
  EXPECT_EQ(two.exit_code, 0) << two.output;
  EXPECT_EQ(Json::parse(content(in_folder("1.json")))["result"],
            Json::parse(content(in_folder("2.json")))["result"]);
}

TEST_F(TableText, GroupsPatternsThatDifferInFewCandidates) {
  const auto table = answer("patterns " + truss + " --mu 0.6 --group 1");
  const auto all = result()["result"];
  std::size_t members = 0;
  for (const auto& group : all["groups"]) {
    members += group["patterns"].size();
    const auto largest_margin = all["patterns"][group["largest_margin"].get<std::size_t>() - 1];
    for (const auto& number : group["patterns"]) {
      const auto& pattern = all["patterns"][number.get<std::size_t>() - 1];
      EXPECT_LE(pattern["margin"], largest_margin["margin"]);
      for (const auto& name : group["contact"])
        EXPECT_NE(std::ranges::find(pattern["contact"], name), pattern["contact"].end());
    }
    EXPECT_THAT(table,
                HasSubstr(fmt::format("  {:>8}  {:>10}  {:>7}  ", group["patterns"].size(),
                                      fmt::format("{:.3e}", largest_margin["margin"].get<double>()),
                                      group["largest_margin"].get<int>())));
  }
  EXPECT_EQ(members, all["patterns"].size());
  answer("patterns " + truss + " --mu 0.6");
  EXPECT_FALSE(result()["result"].contains("groups")) << "only if asked for";
}

TEST_F(TableText, ShowsALongListInGroupsOnATerminal) {
  const auto long_call = command + " patterns " + truss + " --mu 0.8";
  answer("patterns " + truss + " --mu 0.8");
  const auto patterns = result()["result"]["patterns"];
  ASSERT_GT(patterns.size(), 40U);
  const auto head = std::string("that with the largest margin is in contact at");
  const auto shown = without_colours(on_terminal(long_call + " 2>/dev/null", 200));
  EXPECT_THAT(in_one_line(shown), HasSubstr(head));
  EXPECT_THAT(in_one_line(shown), HasSubstr(fmt::format("{} patterns in ", patterns.size())));
  EXPECT_THAT(in_one_line(shown), HasSubstr("--group 0 lists all"));
  // The sizes of all groups add up to the list; the group with the largest margin comes first.
  std::istringstream lines(shown.substr(shown.find(head)));
  std::string line;
  std::getline(lines, line);
  std::size_t members = 0;
  std::size_t groups = 0;
  for (std::size_t size = 0; std::getline(lines, line) && line.starts_with("  ");) {
    std::istringstream columns(line);
    double margin = 0;
    std::size_t number = 0;
    columns >> size >> margin >> number;
    EXPECT_NEAR(margin, patterns.at(number - 1)["margin"].get<double>(), 1e-3 * margin);
    members += size;
    ++groups;
  }
  EXPECT_EQ(members, patterns.size());
  EXPECT_THAT(shown, HasSubstr(fmt::format("in {} groups", groups)));
  EXPECT_LE(groups, 20U);
  // Explicit options are obeyed; a file has one line per pattern.
  for (const auto* const how : {" --group 0", " --group 1", " --top 5", " --sort margin"})
    EXPECT_THAT(on_terminal(long_call + how + " 2>/dev/null", 200), Not(HasSubstr(head))) << how;
  EXPECT_THAT(shell(long_call).output, Not(HasSubstr(head)));
  EXPECT_THAT(on_terminal(command + " patterns " + truss + " --mu 0.65 2>/dev/null", 200),
              Not(HasSubstr(head)))
      << "27 are no long list";
}

TEST_F(TableText, NamesTheMostUtilisedMembersOfACollapseFirst) {
  const auto table = answer("limit " + example("gust.toml") + " --alpha 0.5");
  const auto json = result();
  EXPECT_THAT(table,
              HasSubstr("\n    -x at b1 b2: 0.15 kN each\n    -gust (at a1 a2 a3): 0.5 times\n"));
  const auto said = last_line(table);
  for (const auto& each : json["result"]["collapse_mode"]["yielding"]) {
    EXPECT_THAT(said, HasSubstr(fmt::format("{}-{}", each["member"][0].get<std::string>(),
                                            each["member"][1].get<std::string>())));
  }
  auto used = json["result"]["utilisation"].get<std::vector<double>>();
  std::ranges::sort(used, std::greater());
  std::size_t at = table.rfind("utilisation of other members:");
  ASSERT_NE(at, std::string::npos);
  int named = 0;
  for (const double each : used) {
    if (each >= 0.9995 || named == 5) continue;
    at = table.find(fmt::format(" {:.1f} %", 100 * each), at);
    ASSERT_NE(at, std::string::npos) << each;
    ++named;
  }
}

TEST_F(TableText, FoldsListsAndSentencesForTheTerminal) {
  for (const std::string& call :
       {"patterns " + truss + " --mu 0.65 --sort critical", "critical " + truss,
        "rays " + example("plane-truss.toml") + " --mu 0.65",
        "limit " + example("gust.toml") + " --alpha 0.5",
        "patterns " + example("morse-taper.toml") + " --mu 0.1 --top 5"}) {
    const auto unfolded = answer(call);
    for (const unsigned short columns : {std::uint16_t{80}, std::uint16_t{40}}) {
      // Progress, which a slow machine would show, overwrites one line.
      const auto shown =
          without_colours(on_terminal(command + " " + call + " 2>/dev/null", columns));
      EXPECT_LE(longest_line(shown), columns) << call << "\n" << shown;
      EXPECT_THAT(in_one_line(shown), HasSubstr(last_line(unfolded))) << columns;
    }
    EXPECT_GT(width(last_line(unfolded)), 40U) << "a line of a file is not folded";
  }
}

TEST_F(TableText, HasTheWidthOfTheVariableColumnsOnTerminalsOnly) {
  const auto call = command + " patterns " + truss + " --mu 0.65";
  EXPECT_LE(longest_line(without_colours(on_terminal("COLUMNS=50 " + call, 80))), 50U);
  EXPECT_GT(longest_line(without_colours(on_terminal("COLUMNS=200 " + call, 80))), 100U);
  EXPECT_LE(longest_line(without_colours(on_terminal("COLUMNS=wide " + call, 80))), 80U);
  EXPECT_LE(longest_line(without_colours(on_terminal(call, 0))), 80U) << "it does not say";
  EXPECT_GT(longest_line(shell("COLUMNS=50 " + call).output), 100U);
}

TEST_F(TableText, HasColoursOnTerminalsOnly) {
  const auto call = command + " patterns " + truss + " --mu 0.65";
  EXPECT_THAT(on_terminal(call, 80), HasSubstr("\033[1mIt can stick in 27 ways"));
  EXPECT_THAT(on_terminal("NO_COLOR=1 " + call, 80), Not(HasSubstr("\033[1m")));
  EXPECT_THAT(on_terminal("TERM=dumb " + call, 80), Not(HasSubstr("\033[1m")));
  EXPECT_THAT(on_terminal(call + " > " + argument("table") + " 2>&1", 80), Not(HasSubstr("\033")));
  EXPECT_THAT(content(in_folder("table")), Not(HasSubstr("\033")));
  EXPECT_THAT(shell("TERM=xterm " + call).output, Not(HasSubstr("\033")));
  // A launcher gives each rank a terminal, independently of the terminal of the output.
  EXPECT_THAT(shell("TERM=xterm " + ranks(2) + call).output, Not(HasSubstr("\033")));
}

TEST_F(TableText, ShowsReservationsInYellow) {
  const auto call = command + " patterns " + truss + " --mu 0.65 --node-limit 20; true";
  const auto shown = on_terminal(call, 80);
  EXPECT_THAT(shown, HasSubstr("\033[33mStopped early (node-limit)"));
  EXPECT_THAT(shown, HasSubstr("are known"));
}

TEST_F(TableText, ShowsWarningsAndReservationsOnce) {
  const auto times = [](const std::string& text, const std::string& part) {
    int count = 0;
    for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++count;
    return count;
  };
  const auto file = std::string(KUSABI_SOURCE_DIR) + "/examples/peg-under-load.toml";
  const auto call = command + " critical " + quoted(file) + " --node-limit 1";
  const auto shown = on_terminal(call + "; true", 1000);
  const std::string warning = "ignores 3 loads of the file";
  EXPECT_EQ(times(shown, warning), 1) << shown;
  EXPECT_EQ(times(shown, "Stopped early"), 1) << shown;
  // A file of the table has its warnings.
  EXPECT_EQ(times(on_terminal(call + " > " + argument("table") + "; true", 1000), warning), 1);
  EXPECT_EQ(times(content(in_folder("table")), warning), 1);
}

// A line of the log is explained below its heading.
TEST_F(TableText, OfTheLogIsExplainedByTheHelp) {
  const std::string found = "     time   nodes   per s    open   found      idle    done      left";
  const std::string best =
      "     time   nodes   per s    open    objective        bound     gap      idle\n";
  for (const std::string name : {"patterns", "rays"})
    EXPECT_THAT(shell(command + " " + name + " --help").output, HasSubstr(found)) << name;
  for (const std::string name : {"critical", "limit", "mip"})
    EXPECT_THAT(shell(command + " " + name + " --help").output, HasSubstr(best)) << name;
  EXPECT_THAT(shell(command + " --manual patterns").output,
              HasSubstr("idle    ranks without work"));
  // The page explains the same line.
  const auto help = shell(command + " patterns --help").output;
  const auto line = help.substr(help.find('\n', help.find(found)) + 1);
  const auto page = content(std::string(KUSABI_SOURCE_DIR) + "/docs/result-files.md");
  EXPECT_THAT(page, HasSubstr(found + "\n    " + line.substr(0, line.find('\n')) + "\n"));
}

}  // namespace
