// `kusabi limit` on trusses that earlier versions got wrong, with the correct values; early stops.
#include <cmath>
#include <fstream>
#include <map>
#include <string>

#include <nlohmann/json.hpp>

#include "limit_calls.hpp"
#include "shell.hpp"
#include "tests/nodes/limit/two_bars.hpp"

namespace kusabi::test {
namespace {

using testing::ContainsRegex;
using testing::HasSubstr;
using testing::Not;
using Json = nlohmann::json;

class LimitCommand : public LimitCalls {
 protected:
  Json result_of(const std::string& call, int exit_code = 0) const {
    return file_of(call, exit_code);
  }
};

void expect_proved(const Json& json, double factor, double near) {
  EXPECT_EQ(json["status"], "solved");
  const auto& ends = json["result"]["maximum"];
  for (const auto* const end : {"lower", "upper"}) {
    EXPECT_EQ(ends[end]["standing"], "proved");
    EXPECT_NEAR(ends[end]["value"].get<double>(), factor, near);
  }
  EXPECT_LE(ends["lower"]["value"].get<double>(), ends["upper"]["value"].get<double>());
}

// Equilibrium determines the force of a hanging cable: a proof must not require slack there. By
// hand: both bars yield, sqrt(2) - alpha.
TEST_F(LimitCommand, ProvesATrussWithAnUnstressedCable) {
  expect_proved(result_of(case_file("tie.toml") + " --alpha 0.1"), std::sqrt(2.0) - 0.1, 1e-8);
}

// By hand: only the post n0-n2 supports n2 vertically, and n1-n5 yields first: 0.6 of its 0.0307.
TEST_F(LimitCommand, ProvesATrussWithAChainOfUnstressedBars) {
  const auto json = result_of(case_file("idle_chain.toml") + " --alpha 0.1");
  expect_proved(json, 0.6 * 0.0307, 1e-8);
}

TEST_F(LimitCommand, NamesTheUncertainLoadsOfTheWorstCase) {
  const auto call = example("gust.toml") + " --alpha 0.5";
  EXPECT_THAT(
      shell(command + " limit " + call).output,
      AllOf(HasSubstr("\n    -x at b1 b2: 0.15 kN each\n    -gust (at a1 a2 a3): 0.5 times\n"
                      "    +where the load stands (at a3 b3): 0.5 times\n"),
            HasSubstr("worst case of 4 uncertain loads, alpha = 0.5\n"),
            HasSubstr("for every dead load within ± 0.5 times its uncertain part.")));
  EXPECT_THAT(shell(command + " limit " + example("static-gap.toml") + " --alpha 0.35").output,
              HasSubstr(", alpha = 0.35 kN\n"));
  const auto json = result_of(call);
  EXPECT_EQ(json["problem"]["m"], 4);
  const auto& parameters = json["result"]["critical_parameters"];
  ASSERT_EQ(parameters.size(), 4U);
  std::map<std::string, double> value;
  for (const auto& each : parameters) value[each["name"]] = each["value"];
  EXPECT_EQ(
      value,
      (std::map<std::string, double>{
          {"gust", -0.5}, {"where the load stands", 0.5}, {"x at b1", -0.5}, {"x at b2", -0.5}}));
  // f_D + T zeta at the top of the mast.
  for (const auto& each : json["result"]["critical_load"]) {
    if (each["node"] == "a3") {
      EXPECT_EQ(each["force"], Json::parse("[-0.75, -1.0]"));
    }
  }
}

// A yield force of 8e12 stands for "unlimited": the result equals that of the paper's truss
// (tests/reference/limit.json).
TEST_F(LimitCommand, ProvesATrussWithMembersThatNeverYield) {
  const auto never = result_of(case_file("rigid_8e12.toml") + " --alpha 40");
  const auto usual = result_of(example("paper/limit-3x3.toml") + " --alpha 40");
  expect_proved(never, usual["result"]["maximum"]["upper"]["value"].get<double>(), 1e-6);
  expect_proved(never, 37.0120, 1e-4);
}

// By hand: with s = sin 45°, the bars carry up to 2 s of vertical force, so that 3 - 2 s <= lambda
// <= 3 + 2 s.
TEST_F(LimitCommand, ReportsTheCarriedFactorsIfZeroIsNotCarried) {
  const auto run = shell(command + " limit " + case_file("lambda_zero_not_carried.toml"));
  EXPECT_EQ(run.exit_code, 0);
  EXPECT_THAT(run.output, HasSubstr("nominal load factor 4.414213562"));
  EXPECT_THAT(run.output,
              ContainsRegex("the dead load is carried at load factors from 1\\.58578643[0-9]* to "
                            "4\\.4142135[0-9]*, not at zero"));
  const auto json = result_of(case_file("lambda_zero_not_carried.toml"));
  const auto& interval = json["result"]["nominal_interval"];
  EXPECT_NEAR(interval[0].get<double>(), 3 - std::sqrt(2.0), 1e-9);
  EXPECT_NEAR(interval[1].get<double>(), 3 + std::sqrt(2.0), 1e-9);
}

// A truss whose coordinates or loads have rounding errors instead of zeros, with the factor of the
// truss without them: the bridge of the examples (tests/reference), three bars by hand, and a post
// of strength 10 under a gust of 1 along it.
TEST_F(LimitCommand, ProvesTheFactorsOfTrussesWithRoundingErrorsInTheirDirections) {
  const auto expect_nominal = [&](const std::string& file, double factor) {
    const auto result = result_of(case_file(file))["result"];
    EXPECT_NEAR(result["nominal"].get<double>(), factor, 1e-8);
    EXPECT_FALSE(result.contains("nominal_bounds"));  // they are the answer
    for (const auto* const end : {"lower", "upper"}) {
      EXPECT_EQ(result["maximum"][end]["standing"], "proved");
      EXPECT_NEAR(result["maximum"][end]["value"].get<double>(), factor, 1e-8);
    }
  };
  expect_nominal("bridge_noise_1e_16.toml", 2.260276599);
  expect_nominal("tiny_cosine_space.toml", 20.0 / 3 * std::sqrt(0.2));
  expect_proved(result_of(case_file("rotated_gust.toml") + " --alpha 1"), 9, 1e-8);
}

// By hand: one bar of strength 1 on each side, and a reference load of 3.
TEST_F(LimitCommand, RoundsProvedBoundsToTheSafeSide) {
  for (const char* const alpha : {"", " --alpha 0"}) {
    const auto run = shell(command + " limit " + case_file("twothirds.toml") + alpha);
    EXPECT_EQ(run.exit_code, 0);
    EXPECT_THAT(run.output, ContainsRegex("factor 0\\.66666666[0-6]+ \\.\\.\\. 0\\.6666666666+7, "
                                          "proved"));
    EXPECT_THAT(run.output, Not(HasSubstr("0.6666666667 are carried")));
  }
}

TEST_F(LimitCommand, ProvesTheNominalFactorInItsCertificate) {
  const auto file = case_file("bridge_noise_1e_16.toml");
  const auto run = shell(command + " limit " + file + " --certificate " + argument("cert"));
  EXPECT_THAT(run.output, HasSubstr("It carries 2.2602 times the reference load, but no more "
                                    "than 2.2603 times."));
  const auto verified = shell(command + " verify " + argument("cert") + " --problem " + file);
  EXPECT_EQ(verified.exit_code, 0) << verified.output;
  EXPECT_THAT(verified.output, HasSubstr("for alpha = 0"));
}

// Each case carries some factors, but no factor is carried in both.
TEST_F(LimitCommand, SaysThatNoFactorIsCarriedInAllCases) {
  const auto run = shell(command + " limit " + case_file("two_cases_words.toml") +
                         " --alpha 0 --group-alpha 'one 2=0'");
  EXPECT_EQ(run.exit_code, 0);
  EXPECT_THAT(run.output,
              HasSubstr("There is no load factor that it carries under its dead load, in all of 2 "
                        "load cases."));
}

// The interval is not printed if it contains zero.
TEST_F(LimitCommand, OmitsTheIntervalIfZeroIsCarried) {
  const auto run = shell(command + " limit " + example("paper/limit-3x3.toml") + " --alpha 40");
  EXPECT_THAT(run.output, Not(HasSubstr("not at zero")));
}

TEST_F(LimitCommand, WritesACertificateByEveryMethod) {
  for (const char* cuts : {"none", "disjunctive", "tighten", "static", "all"}) {
    const auto file = argument(std::string("cert-") + cuts);
    const auto truss_of = example("static-gap.toml");
    const auto run = shell(command + " limit " + truss_of + " --alpha 0.35 --cuts " + cuts +
                           " --certificate " + file);
    EXPECT_EQ(run.exit_code, 0) << run.output;
    EXPECT_THAT(run.output, HasSubstr("wrote "));
    const auto proved = shell(command + " verify " + file + " --problem " + truss_of);
    EXPECT_EQ(proved.exit_code, 0) << proved.output;
    EXPECT_THAT(proved.output, HasSubstr("PROVED"));
  }
}

TEST_F(LimitCommand, RefusesOptionsOfAWorstCaseWithoutAlpha) {
  for (const char* option : {"--cuts all", "--samples 3", "--curve"}) {
    const auto run = shell(command + " limit " + example("static-gap.toml") + ' ' + option);
    EXPECT_EQ(run.exit_code, 2);
    EXPECT_THAT(run.output, HasSubstr("expected --alpha, or alpha in the groups of the file"));
  }
}

// Two bars, two load cases.
class LoadCases : public LimitCommand {
 protected:
  void SetUp() override {
    LimitCommand::SetUp();
    std::ofstream(in_folder("cases.toml")) << limit::two_bars(R"([[loads]]
kind = "dead"
case = "pull"
nodes = ["tip"]
force = [[-0.5, 0.5], -1]
[[loads]]
kind = "dead"
case = "push"
nodes = ["tip"]
force = [2, 0]
[[uncertainty]]
case = "push"
nodes = ["tip"]
axes = ["x"]
alpha = 0.25
)");
  }
  [[nodiscard]] std::string file() const { return argument("cases.toml"); }
};

// By hand: 3 - 0.5 with the tip pulled down, since 5 + 1 is more, and 3 - 2 - 0.25.
TEST_F(LoadCases, HaveAResultForEachCase) {
  const auto json = result_of(file());
  expect_proved(json, 0.75, 1e-8);
  const auto& result = json["result"];
  EXPECT_EQ(result["case"], "push");
  EXPECT_EQ(result["alpha"], 0.25);
  ASSERT_EQ(result["cases"].size(), 2U);
  EXPECT_EQ(result["cases"][0]["name"], "pull");
  EXPECT_NEAR(result["cases"][0]["nominal"].get<double>(), 3, 1e-9);
  EXPECT_NEAR(result["cases"][0]["maximum"]["lower"]["value"].get<double>(), 2.5, 1e-8);
  EXPECT_EQ(result["cases"][1]["state"], "solved");
  EXPECT_NEAR(result["cases"][1]["nominal"].get<double>(), 1, 1e-9);
  const auto run = shell(command + " limit " + file());
  EXPECT_THAT(run.output, HasSubstr("the least factor is that of push\n"));
  EXPECT_THAT(run.output, HasSubstr("1 uncertain load acts along the reference load"));
  auto alone = json;
  shell(ranks(2) + command + " limit " + file() + " --output " + argument("out.json"));
  auto together = Json::parse(content(in_folder("out.json")));
  EXPECT_TRUE(alone.erase("statistics") && together.erase("statistics"));
  EXPECT_EQ(alone, together);
}

// By hand: -2 to 3 without a dead load; 3.5 to 5 with the tip pushed by 5.5.
TEST_F(LoadCases, WithoutUncertaintyAreCarriedTogetherAtNoFactorIfTheirIntervalsAreDisjoint) {
  std::ofstream(in_folder("disjoint.toml")) << limit::two_bars(R"([[loads]]
kind = "dead"
case = "none"
nodes = ["tip"]
force = [0, 0]
[[loads]]
kind = "dead"
case = "push"
nodes = ["tip"]
force = [-5.5, 0]
)");
  const auto run = shell(command + " limit " + argument("disjoint.toml"));
  EXPECT_THAT(run.output,
              HasSubstr("There is no load factor that it carries in all of 2 load cases"));
  EXPECT_THAT(
      run.output,
      HasSubstr("in all cases: there is no factor that is carried under the dead load, proved"));
}

// Minimum of (5) over all vertices of the uncertain loads, by another program (HiGHS in SciPy).
TEST_F(LimitCommand, AnswersBothCasesOfTheSteelMast) {
  const auto json = result_of(example("steel-mast.toml"));
  EXPECT_EQ(json["status"], "solved");
  EXPECT_EQ(json["result"]["case"], "wind");
  const auto& cases = json["result"]["cases"];
  ASSERT_EQ(cases.size(), 2U);
  EXPECT_NEAR(cases[0]["nominal"].get<double>(), 12.44, 1e-8);
  EXPECT_NEAR(cases[0]["maximum"]["lower"]["value"].get<double>(), 10.19, 1e-6);
  EXPECT_NEAR(cases[0]["maximum"]["upper"]["value"].get<double>(), 10.19, 1e-6);
  EXPECT_NEAR(cases[1]["nominal"].get<double>(), 14.74, 1e-8);
  EXPECT_NEAR(cases[1]["maximum"]["lower"]["value"].get<double>(), 13.44, 1e-6);
}

TEST_F(LoadCases, CanBeSelectedByName) {
  const auto json = result_of(file() + " --case pull");
  expect_proved(json, 2.5, 1e-8);
  EXPECT_FALSE(json["result"].contains("cases"));
  EXPECT_EQ(json["options"]["case"], "pull");
  const auto refusal = [&](const std::string& call) {
    const auto run = shell(command + call);
    EXPECT_EQ(run.exit_code, 2) << run.output;
    return run.output;
  };
  EXPECT_THAT(refusal(" limit " + file() + " --case pul"), HasSubstr("one of \"pull\", \"push\""));
  EXPECT_THAT(refusal(" limit " + example("gust.toml") + " --case pull"),
              HasSubstr("there is no load case \"pull\"; expected no --case"));
  EXPECT_THAT(refusal(" limit " + file() + " --alpha 1"), HasSubstr("expected no --alpha"));
  EXPECT_THAT(refusal(" sweep " + file() + " --alpha 1"), HasSubstr("expected --case with one of"));
  EXPECT_THAT(refusal(" sweep " + file() + " --alpha 1 --case pull"),
              HasSubstr("its own half-width"));
  EXPECT_THAT(refusal(" export mps " + file()), HasSubstr("expected --case with one of"));
}

TEST_F(LoadCases, CertificateOfOneIsProvedForThatCaseOnly) {
  const auto run =
      shell(command + " limit " + file() + " --case push --certificate " + argument("cert"));
  EXPECT_EQ(run.exit_code, 0) << run.output;
  const auto proved = shell(command + " verify " + argument("cert") + " --problem " + file());
  EXPECT_EQ(proved.exit_code, 0) << proved.output;
  EXPECT_THAT(proved.output, HasSubstr("\nload case \"push\"\n"));
  EXPECT_THAT(proved.output, HasSubstr("PROVED: the worst-case load factor for alpha = 0.25"));
  auto text = content(in_folder("cases.toml"));
  text.replace(text.find("0.25"), 4, "0.26");
  std::ofstream(in_folder("cases.toml")) << text;
  const auto other = shell(command + " verify " + argument("cert") + " --problem " + file());
  EXPECT_EQ(other.exit_code, 1) << other.output;
  EXPECT_THAT(other.output,
              HasSubstr("case \"push\": the recorded half-width of an uncertain load"));
  EXPECT_THAT(other.output, HasSubstr("NOT PROVED"));
}

TEST_F(LimitCommand, WritesACertificateWithTheCutsOfThePaper) {
  const auto run = shell(command + " limit " + example("paper/limit-4x4.toml") +
                         " --alpha 40 --cuts disjunctive --certificate " + argument("cert"));
  EXPECT_EQ(run.exit_code, 0) << run.output;
  const auto proved = shell(command + " verify " + argument("cert"));
  EXPECT_THAT(proved.output, HasSubstr("PROVED: the worst-case load factor for alpha = 40"));
}

// Method of the paper alone: neither static cuts nor proofs, as the output states.
TEST_F(LimitCommand, UsesNoStaticCutsIfMIsGiven) {
  for (const std::string cuts : {"none", "disjunctive"}) {
    const auto call = example("static-gap.toml") + " --alpha 0.45 --big-m 20 --cuts " + cuts;
    const auto run = shell(command + " limit " + call);
    EXPECT_EQ(run.exit_code, 3) << run.output;
    EXPECT_THAT(run.output, HasSubstr("bounds of the 0-1 program (29) with M = 20, valid if"));
    EXPECT_THAT(run.output, HasSubstr("The bounds of (29) hold only if its M is large enough."));
    EXPECT_THAT(run.output, Not(HasSubstr("static evidence:")));
    const auto json = result_of(call, 3);
    EXPECT_EQ(json["status"], "open");
    const auto& result = json["result"];
    EXPECT_TRUE(result["if_big_m"]);
    EXPECT_EQ(result["maximum"]["lower"]["standing"], "computed");
    for (const auto& [name, count] : result["programs"].items()) EXPECT_EQ(count, 0) << name;
    EXPECT_EQ(result["zero_one"]["cut_programs"] > 0, cuts == "disjunctive");
    EXPECT_GT(json["statistics"]["zero_one"]["nodes"], 0);
    // All 2^7 vertices give 2.007 (examples/static-gap.toml).
    EXPECT_NEAR(result["maximum"]["upper"]["value"].get<double>(), 2.007, 1e-3);
  }
}

TEST_F(LimitCommand, ProvesTheMethodOfThePaperIfACertificateIsRequested) {
  for (const std::string cuts : {"none", "disjunctive"}) {
    const auto truss_of = example("static-gap.toml");
    const auto json = result_of(truss_of + " --alpha 0.45 --big-m 20 --cuts " + cuts +
                                " --certificate " + argument("cert"));
    EXPECT_EQ(json["status"], "solved");
    EXPECT_FALSE(json["result"]["if_big_m"]);
    EXPECT_GT(json["result"]["programs"]["cuts"], 0);
    const auto& by_itself = json["result"]["zero_one"];
    EXPECT_NEAR(by_itself["upper"].get<double>(), json["result"]["maximum"]["upper"]["value"],
                1e-6);
    const auto proved = shell(command + " verify " + argument("cert") + " --problem " + truss_of);
    EXPECT_THAT(proved.output, HasSubstr("PROVED"));
  }
}

TEST_F(LimitCommand, ReportsThatAStoppedTreeHasNoCertificate) {
  const auto run =
      shell(command + " limit " + example("paper/limit-3x3.toml") +
            " --alpha 40 --cuts none --big-m 5 --node-limit 30 --certificate " + argument("cert"));
  EXPECT_EQ(run.exit_code, 3) << run.output;
  EXPECT_THAT(run.output, HasSubstr("No certificate was written ("));
  EXPECT_THAT(run.output, HasSubstr("stopped before both bounds were proved"));
  EXPECT_THAT(run.output, Not(HasSubstr("wrote ")));
  EXPECT_EQ(shell("test -e " + argument("cert")).exit_code, 1);
}

TEST_F(LimitCommand, RefutesAnMThatIsTooSmall) {
  const auto run =
      shell(command + " limit " + example("static-gap.toml") +
            " --alpha 0.35 --cuts none --big-m 0.05 --certificate " + argument("cert"));
  EXPECT_EQ(run.exit_code, 0) << run.output;
  EXPECT_THAT(run.output, HasSubstr("its M is too small"));
  // The load of the best point of (29) has a smaller factor than the lower bound.
  const auto printed = shell(command + " limit " + case_file("uplift.toml") +
                             " --alpha 1.5 --cuts none --big-m 0.5");
  EXPECT_THAT(printed.output, HasSubstr("its M is too small"));
}

// (29) is finite for every M; one program (5) shows that the load of its optimum is not carried.
TEST_F(LimitCommand, ReportsThatNoMIsLargeEnoughIfALoadIsNotCarried) {
  const auto run =
      shell(command + " limit " + example("static-gap.toml") + " --alpha 3 --cuts none --big-m 20");
  EXPECT_EQ(run.exit_code, 0) << run.output;
  EXPECT_THAT(
      run.output,
      HasSubstr("some admissible dead load is carried at no load factor of either sign, proved"));
  EXPECT_THAT(run.output, HasSubstr("no M is large enough"));
  EXPECT_THAT(run.output, Not(HasSubstr("--certificate FILE")));
}

TEST_F(LimitCommand, StartsFromTheSameSampleOnTwoRanks) {
  Json alone;
  for (const std::string& launch : {std::string(), ranks(2)}) {
    const auto run = shell(launch + command + " limit " + example("static-gap.toml") +
                           " --alpha 0.45 --cuts disjunctive --big-m 20 --samples 40 --output " +
                           argument("out.json"));
    EXPECT_EQ(run.exit_code, 3) << run.output;
    auto json = Json::parse(content(in_folder("out.json")));
    json.erase("statistics");
    EXPECT_EQ(json["result"]["zero_one"]["start"], json["result"]["samples"]["least"]);
    if (alone.is_null()) alone = json;
    EXPECT_EQ(json, alone);
  }
}

// The evidence needs more slack than the first attempt leaves: it once ended at minus infinity.
TEST_F(LimitCommand, ProvesTheGridOfSixteenBays) {
  shell(command + " example grid --bays 16 --output " + argument("grid.toml"));
  expect_proved(result_of(argument("grid.toml") + " --alpha 40"), -10.2734733, 1e-6);
}

// Ranks share the columns of the splitting. No factor is carried under every load, which the least
// factor of one load proves.
TEST_F(LimitCommand, HasTheSameCertificateOnTwoRanks) {
  shell(command + " example grid --bays 12 --output " + argument("grid.toml"));
  std::string alone;
  for (const std::string& launch : {std::string(), ranks(2)}) {
    const auto run = shell(launch + command + " limit " + argument("grid.toml") +
                           " --alpha 40 --certificate " + argument("cert"));
    EXPECT_EQ(run.exit_code, 0) << run.output;
    const auto certificate = content(in_folder("cert"));
    if (alone.empty()) alone = certificate;
    EXPECT_TRUE(certificate == alone) << launch;
  }
  const auto verified =
      shell(command + " verify " + argument("cert") + " --problem " + argument("grid.toml"));
  EXPECT_EQ(verified.exit_code, 0);
  EXPECT_THAT(verified.output, HasSubstr("least factors: a bound from below"));
  EXPECT_THAT(verified.output,
              HasSubstr("there is no load factor that is carried under every admissible load"));
}

TEST_F(LimitCommand, RefusesAnInvalidWidth) {
  for (const char* alpha : {"nan", "-1", "inf", "1e400", "x"}) {
    const auto run =
        shell(command + " limit " + example("paper/limit-3x3.toml") + " --alpha " + alpha);
    EXPECT_EQ(run.exit_code, 2) << alpha;
    EXPECT_THAT(run.output, HasSubstr("--alpha"));
  }
}

// The nominal load does not depend on alpha.
TEST_F(LimitCommand, TheNominalFactorDoesNotDependOnAlpha) {
  const auto nominal = [&](const std::string& alpha) {
    return result_of(case_file("tie.toml") + alpha)["result"]["nominal"].get<double>();
  };
  EXPECT_EQ(nominal(" --alpha 0.1"), nominal(""));
  EXPECT_EQ(nominal(" --alpha 1e3"), nominal(""));
}

TEST_F(LimitCommand, ReportsNoProofOfAStoppedSearch) {
  shell(command + " example grid --bays 14 --output " + argument("grid.toml"));
  const auto run = shell(command + " limit " + argument("grid.toml") +
                         " --alpha 40 --time-limit 0.2 --certificate " + argument("cert"));
  EXPECT_EQ(run.exit_code, 3) << run.output;
  EXPECT_THAT(run.output, HasSubstr("Stopped early (time-limit)"));
  EXPECT_THAT(run.output, Not(HasSubstr("proved\n  critical")));
}

}  // namespace
}  // namespace kusabi::test
