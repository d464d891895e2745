// kusabi patterns as a user calls it, alone and under mpirun.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <fstream>
#include <functional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "shell.hpp"

namespace kusabi::test {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

using PatternsCommand = Command;

TEST_F(PatternsCommand, ShowsTheTableOfPatterns) {
  const auto run = shell(fmt::format("{} patterns {} --mu 0.65", command, truss));
  EXPECT_EQ(run.exit_code, 0);
  EXPECT_THAT(run.output, HasSubstr("27 sign patterns of wedged configurations"));
  EXPECT_THAT(run.output, HasSubstr("b13 t13 b23"));
}

TEST_F(PatternsCommand, WritesTheSameBytesOnAnyNumberOfRanks) {
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

TEST_F(PatternsCommand, WritesTheResultInFull) {
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
  EXPECT_EQ(pattern["state"], "feasible");
  EXPECT_GT(pattern["margin"].get<double>(), 0);
  EXPECT_EQ(pattern["reaction"].size(), 10U);
  EXPECT_EQ(pattern["displacement"][9].size(), 3U);
  EXPECT_EQ(files(), std::vector<std::string>{"result.json"});
}

TEST_F(PatternsCommand, ReportsAnEmptyListWithExitCodeZero) {
  const auto run = shell(command + " patterns " + truss + " --mu 0.3");
  EXPECT_EQ(run.exit_code, 0);
  EXPECT_THAT(run.output, HasSubstr("0 sign patterns"));
}

TEST_F(PatternsCommand, DecidesAllNodesAtTheLargestFriction) {
  const auto file = in_folder("result.json");
  const auto run = shell(command + " patterns " + truss + " --mu 1e6 --output " + quoted(file));
  EXPECT_EQ(run.exit_code, 0) << run.output;
  const auto result = nlohmann::json::parse(content(file))["result"];
  EXPECT_EQ(result["undecided"], 0);
  EXPECT_EQ(result["marginal"], 0);
  EXPECT_GT(result["count"], 0);
  const auto beyond = shell(command + " patterns " + truss + " --mu 1e7");
  EXPECT_EQ(beyond.exit_code, 2);
  EXPECT_THAT(beyond.output, HasSubstr("the friction coefficient at b13 is 1e+07; expected"));
}

TEST_F(PatternsCommand, ListsAFlatConeOnceWithItsInactiveCandidates) {
  std::ofstream(in_folder("rod.toml")) << rod_along_normal;
  const auto run = shell(command + " patterns " + argument("rod.toml") + " --mu 1.1 --output " +
                         argument("result.json"));
  EXPECT_EQ(run.exit_code, 0) << run.output;
  EXPECT_THAT(run.output, HasSubstr("inactive: c2"));
  const auto result = nlohmann::json::parse(content(in_folder("result.json")))["result"];
  EXPECT_EQ(result["count"], 1);
  EXPECT_EQ(result["flat"], 1);
  ASSERT_EQ(result["patterns"].size(), 1U);
  const auto& pattern = result["patterns"][0];
  EXPECT_EQ(pattern["state"], "flat");
  EXPECT_EQ(pattern["contact"], std::vector<std::string>{"c1"});
  EXPECT_EQ(pattern["inactive"], std::vector<std::string>{"c2"});
  for (const std::string way :
       {"", " --method newton --mu-max 6", " --method bisection --mu-max 6"}) {
    const auto critical = shell(command + " critical " + argument("rod.toml") + way +
                                " --quiet --output " + argument("critical.json"));
    EXPECT_EQ(critical.exit_code, 0) << critical.output;
    const auto bracket =
        nlohmann::json::parse(content(in_folder("critical.json")))["result"]["critical_friction"];
    EXPECT_LE(bracket["lower"]["value"], 1.0) << way;
    EXPECT_GE(bracket["upper"]["value"], 1.0) << way;
    EXPECT_LE(bracket["upper"]["value"].get<double>() - bracket["lower"]["value"].get<double>(),
              2.1e-8)
        << way;
  }
}

TEST_F(PatternsCommand, BranchesByTheRuleOfThePaperOnRequest) {
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

// The numbers are those of the result file, in any order.
TEST_F(PatternsCommand, ListsPatternsInTheRequestedOrder) {
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
  EXPECT_THAT(run,
              HasSubstr(fmt::format("Pattern {} has the largest margin, ", margins[0].second)));
  EXPECT_THAT(patterns(" --sort contact --top 1"), HasSubstr("   27  "));
}

// Below the reported coefficient the configuration is not wedged; the pattern may still be
// feasible.
TEST_F(PatternsCommand, ReportsTheLeastFrictionOfTheLargestMargin) {
  const auto run =
      shell(command + " patterns " + truss + " --mu 0.65 --output " + argument("result.json"));
  const auto all = nlohmann::json::parse(content(in_folder("result.json")))["result"]["patterns"];
  const auto best = std::ranges::max_element(
      all, {}, [](const nlohmann::json& pattern) { return pattern["margin"].get<double>(); });
  double minimum = 0;
  for (const auto& reaction : (*best)["reaction"]) {
    const auto r = reaction.get<std::vector<double>>();
    if (r[0] > 0) minimum = std::max(minimum, std::hypot(r[1], r[2]) / r[0]);
  }
  EXPECT_LT(minimum, 0.65);
  EXPECT_THAT(run.output, HasSubstr(fmt::format("needs a friction coefficient of {};",
                                                std::ceil(1e5 * minimum) / 1e5)));
  EXPECT_THAT(shell(command + " patterns " + truss + " --mu 0.3").output,
              HasSubstr("It cannot stick at friction coefficient 0.3."));
}

// 233 candidates, all of which can be in contact at once: a tree takes long to find this pattern.
TEST_F(PatternsCommand, FindsOnePatternOfManyCandidatesWithoutASearch) {
  const auto file =
      quoted(std::string(KUSABI_SOURCE_DIR) + "/tests/cases/c_lc6_o2.toml");  // tan 3 deg = 0.0524
  const auto run = shell(command + " patterns " + file + " --mu 0.1 --pattern-limit 1 --output " +
                         argument("one.json"));
  EXPECT_EQ(run.exit_code, 3) << run.output;
  const auto json = nlohmann::json::parse(content(in_folder("one.json")));
  EXPECT_EQ(json["status"], "solution-limit");
  ASSERT_EQ(json["result"]["patterns"].size(), 1U);
  EXPECT_EQ(json["result"]["patterns"][0]["state"], "feasible");
}

TEST_F(PatternsCommand, DecidesTheExistenceOfAPattern) {
  const auto file = argument("long.toml");  // its critical coefficient is 0.54124
  shell(command + " example space-truss --rows 10 --depth 3 --output " + file);
  const auto ask = [&](const std::string& launcher, const std::string& mu) {
    const auto run = shell(launcher + command + " patterns " + file + " --exists --mu " + mu +
                           " --output " + argument("one.json"));
    EXPECT_EQ(run.exit_code, 0) << run.output;
    return run.output;
  };
  EXPECT_THAT(ask("", "0.545"),
              HasSubstr("Yes, it can stick at friction coefficient 0.545. One way is contact at "));
  const auto one = nlohmann::json::parse(content(in_folder("one.json")));
  EXPECT_EQ(one["status"], "solved");
  ASSERT_EQ(one["result"]["patterns"].size(), 1U);
  EXPECT_EQ(one["result"]["tree"]["opened"], 0);
  ask(ranks(2), "0.545");
  EXPECT_EQ(nlohmann::json::parse(content(in_folder("one.json")))["result"]["patterns"],
            one["result"]["patterns"]);
  EXPECT_THAT(ask("", "0.54"), HasSubstr("It cannot stick at friction coefficient 0.54."));
  const auto both = shell(command + " patterns " + file + " --exists --mu 1 --certificate " +
                          argument("certificate"));
  EXPECT_EQ(both.exit_code, 2) << both.output;
  EXPECT_THAT(both.output, HasSubstr("expected --certificate without --exists"));
  const auto sorted = shell(command + " patterns " + file + " --exists --mu 1 --sort critical");
  EXPECT_EQ(sorted.exit_code, 2) << sorted.output;
  EXPECT_THAT(sorted.output, HasSubstr("expected --sort critical without --exists"));
}

TEST_F(PatternsCommand, FindsTheSamePatternsByPolyhedralFriction) {
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
TEST_F(PatternsCommand, ListsTheCandidatesOfPolyhedralFriction) {
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

// Disconnected copies of the truss of examples/two-bars.toml.
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

TEST_F(PatternsCommand, SearchesDecoupledBlocksSeparately) {
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

// By hand (its first lines): B wedges from 5 on.
TEST_F(PatternsCommand, SaysNothingOfPatternsThatWereNotSearched) {
  const auto pieces =
      quoted(std::string(KUSABI_SOURCE_DIR) + "/tests/cases/two_pieces.toml") + " --mu ";
  const auto patterns = [&](const std::string& more) {
    return shell(command + " patterns " + pieces + more).output;
  };
  EXPECT_THAT(patterns("3"), HasSubstr("B: always inactive"));
  // The margin is 4, and its lower bound a rounding error below, which is printed rounded down.
  EXPECT_THAT(patterns("6"),
              AllOf(HasSubstr("\n1 sign pattern of wedged configurations at"),
                    HasSubstr("B: 1 sign pattern\n"),
                    HasSubstr("The only way is contact at A, with a margin of 3.99.")));
  for (const auto* const limit : {"--exists", "--node-limit 3"}) {
    EXPECT_THAT(patterns(std::string("6 ") + limit),
                AllOf(HasSubstr("\n1 sign pattern of wedged configurations is known at"),
                      HasSubstr("A: 1 sign pattern is known\n"),
                      HasSubstr("B: 0 sign patterns are known\n"),
                      HasSubstr("One way is contact at A, with a margin of 3.99.")))
        << limit;
  }
}

// The patterns of one bar alone have margins below 1e-14, which the list takes for zero.
TEST_F(PatternsCommand, ClaimsNoProofOfAListWithDegenerateNodes) {
  const auto file =
      quoted(std::string(KUSABI_SOURCE_DIR) + "/tests/cases/weakly_coupled_bars.toml");
  const auto call = command + " patterns " + file + " --mu 3 --output " + argument("result.json");
  const auto answer = [&] {
    return nlohmann::json::parse(content(in_folder("result.json")))["result"];
  };
  EXPECT_THAT(shell(call).output, HasSubstr("The list is computed in floating point, not proved in "
                                            "exact arithmetic: of 2 degenerate nodes, with a "
                                            "margin of zero, nothing is proved.\n"));
  EXPECT_EQ(answer()["standing"], "computed");
  // A pattern that is shown as an example does not depend on other nodes.
  shell(call + " --exists");
  EXPECT_EQ(answer()["standing"], "proved");
  EXPECT_THAT(shell(call + " --prove").output, HasSubstr("It can stick in 3 ways"));
  EXPECT_EQ(answer()["standing"], "proved");
}

// A block between walls that are parallel up to the last digit: a slide along them by 1e16 times
// the strain of the block is left out of the proofs, as `verify` says.
TEST_F(PatternsCommand, NamesTheDisplacementsThatProofsLeaveOut) {
  std::ofstream(in_folder("walls.toml")) << R"(
name = "block between walls"
dimension = 2
units = { length = "mm", force = "N" }
[[mesh]]
name = "b"
corners = [[0.0, 0.0], [0.9486832980505138, 0.31622776601683794], [0.6324555320336759, 1.2649110640673518], [-0.31622776601683794, 0.9486832980505138]]
divisions = [1, 1]
E = 1000.0
nu = 0.3
thickness = 1
plane = "strain"
[[contact]]
nodes = ["b.left"]
normal = [0.9486832980505138, 0.3162277660168379]
[[contact]]
nodes = ["b.right"]
normal = [-3, -1]
)";
  const std::string sentence =
      "\nThe proofs are for displacements up to 1e+06 times the strains only.\n";
  const auto walls = argument("walls.toml");
  EXPECT_THAT(
      shell(command + " patterns " + walls + " --mu 0.3 --prove").output,
      AllOf(HasSubstr("\nIt cannot stick at friction coefficient 0.3.\n"), HasSubstr(sentence)));
  EXPECT_THAT(shell(command + " critical " + walls).output, HasSubstr(sentence));
  EXPECT_THAT(shell(command + " patterns " + truss + " --mu 0.3 --prove").output,
              Not(HasSubstr(sentence)));
}

constexpr auto two_corners = R"(
name = "two corners"
dimension = 2
units = { length = "m", force = "kN" }
[nodes]
left = [0.0, 0.0]
topA = [1.0, 1.0]
A = [1.0, 0.0]
B = [2.0, 0.0]
topB = [2.0, 1.0]
right = [3.0, 0.0]
[[members]]
EA = 1.0
between = [["left", "A"], ["right", "B"]TIE]
[[members]]
EA = 3.0
between = [["topA", "A"], ["topB", "B"]]
[[supports]]
nodes = ["left", "right", "topA", "topB"]
[[contact]]
nodes = ["A"]
normal = [-1.0, 1.0]
[[contact]]
nodes = ["B"]
normal = NORMAL
[[loads]]
kind = "reference"
nodes = ["B"]
force = [0.0, 1.0]
)";

class Corners : public PatternsCommand {
 protected:
  /// Output for these corners. @param bar between them, or nothing  @param normal of B
  std::string said(const std::string& bar, const std::string& normal, const std::string& mu) {
    auto text = std::string(two_corners);
    text.replace(text.find("TIE"), 3, bar);
    text.replace(text.find("NORMAL"), 6, normal);
    std::ofstream(in_folder("corners.toml")) << text;
    return shell(command + " patterns " + argument("corners.toml") + " --mu " + mu).output;
  }
  const std::string bar_ = R"(, ["A", "B"])";
};

TEST_F(Corners, NameTheReactionOfACandidateWithoutFriction) {
  EXPECT_THAT(said(bar_, "[-1.0, 1.0]\nfriction_factor = 0", "8"),
              AllOf(HasSubstr("B is closest to separation, with r_n = 0.5 kN."),
                    HasSubstr("needs 4 times the friction given in the file; with "
                              "less, A slips first")));
}

// The load opens the candidate B and A holds any of it, or closes B against a gap. Without the bar
// between them, A and B are two blocks; B, on a vertical wall, cannot wedge.
TEST_F(Corners, NameTheLoadsThatPatternsHold) {
  EXPECT_THAT(said(bar_, "[1.0, 1.0]", "4"), HasSubstr("Number 1 holds the reference load at any "
                                                       "factor from -1.4142 on."));
  EXPECT_THAT(said(bar_, "[1.0, 1.0]", "3"),
              HasSubstr("None is known to have a margin, so the loads that they hold are not "
                        "computed."));
  EXPECT_THAT(said("", "[1.0, 1.0]", "4"),
              HasSubstr("number 2 holds the part of the reference load on its block up to a factor "
                        "of "));
  EXPECT_THAT(said("", "[0.0, 1.0]", "4"),
              HasSubstr("The reference load acts on none of the patterns."));
}

// By hand (docs/problem-files.md): these two bars wedge if and only if mu is at least 2.
TEST_F(PatternsCommand, MultipliesTheFrictionOfEachCandidate) {
  const auto file = in_folder("bars.toml");
  std::ofstream(file) << content(std::string(KUSABI_SOURCE_DIR) + "/examples/two-bars.toml")
                      << "friction_factor = 4\n";
  const auto patterns = [&](const std::string& mu) {
    return shell(command + " patterns " + quoted(file) + " --mu " + mu).output;
  };
  EXPECT_THAT(patterns("0.49"), HasSubstr("\n0 sign patterns"));
  EXPECT_THAT(patterns("0.51"), HasSubstr("\n1 sign pattern of wedged configurations at 0.51 times "
                                          "the friction given in the file"));
}

}  // namespace
}  // namespace kusabi::test
