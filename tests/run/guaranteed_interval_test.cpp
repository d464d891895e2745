// Load factors carried under every admissible load, by `kusabi limit` and its certificates: trusses
// with intervals known by hand or from another program.
#include <cmath>
#include <fstream>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "limit_calls.hpp"
#include "shell.hpp"
#include "tests/nodes/limit/two_bars.hpp"

namespace kusabi::test {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;
using Json = nlohmann::json;

class GuaranteedInterval : public LimitCalls {
 protected:
  Json result_of(const std::string& call, int exit_code = 0) const {
    return file_of(call, exit_code)["result"];
  }
  // Runs a call with and without a certificate, which must be accepted. @return the output of
  // verify
  std::string proved(const std::string& file, const std::string& call) const {
    const auto without = shell(command + " limit " + file + call);
    const auto with =
        shell(command + " limit " + file + call + " --certificate " + argument("cert"));
    EXPECT_EQ(with.exit_code, without.exit_code) << with.output;
    EXPECT_THAT(with.output, HasSubstr("wrote "));
    const auto of_file = shell(command + " verify " + argument("cert") + " --problem " + file);
    const auto of_itself = shell(command + " verify " + argument("cert"));
    EXPECT_EQ(of_file.exit_code, 0) << of_file.output;
    EXPECT_EQ(of_itself.exit_code, 0) << of_itself.output;
    return of_file.output;
  }
};

// @param interval with `minimum` and `maximum`
void expect_interval(const Json& interval, double lower, double upper, double near = 1e-6) {
  for (const auto& [end, factor] : {std::pair("minimum", lower), std::pair("maximum", upper)}) {
    const auto& bracket = interval[end];
    for (const char* const side : {"lower", "upper"}) {
      EXPECT_EQ(bracket[side]["standing"], "proved");
      EXPECT_NEAR(bracket[side]["value"].get<double>(), factor, near);
    }
    EXPECT_LE(bracket["lower"]["value"], bracket["upper"]["value"]);
  }
}

// By hand: the hanger carries -1 <= lambda - w <= 3, so [w - 1, w + 3] for an uplift of w.
TEST_F(GuaranteedInterval, OfAHangerUnderUpliftIsThatOfStatics) {
  const auto file = case_file("uplift.toml");
  const auto json = result_of(file + " --alpha 1.5");
  expect_interval(json, 0.5, 1.5);
  EXPECT_EQ(json["minimum_parameters"][0]["value"], 1.5);
  expect_interval(result_of(file + " --alpha 2.5"), 1.5, 0.5);
  expect_interval(result_of(file + " --alpha 0.5"), -0.5, 2.5);
  const auto run = shell(command + " limit " + file + " --alpha 1.5");
  EXPECT_THAT(run.output, Not(HasSubstr("at least 1.4999")));
  EXPECT_THAT(proved(file, " --alpha 1.5"), HasSubstr("every load factor from "));
  EXPECT_THAT(proved(file, " --alpha 2.5"),
              HasSubstr("there is no load factor that is carried under every admissible load"));
}

// If both ends are 1, no number of digits shows that the interval is not empty.
TEST_F(GuaranteedInterval, IsUndecidedIfItIsOnePoint) {
  const auto json = result_of(case_file("uplift.toml") + " --alpha 2", 3);
  EXPECT_NEAR(json["minimum"]["upper"]["value"].get<double>(), 1, 1e-6);
  EXPECT_NEAR(json["maximum"]["lower"]["value"].get<double>(), 1, 1e-6);
  EXPECT_GT(json["minimum"]["upper"]["value"], json["maximum"]["lower"]["value"]);
}

// By hand: with a wind of -1 the cable is slack below lambda = 1; 2 sqrt 2 - 1 in the other
// direction.
TEST_F(GuaranteedInterval, OfASlackCableIsThatOfStatics) {
  const auto file = case_file("cable_stay.toml");
  expect_interval(result_of(file + " --alpha 1"), 1, 2 * std::sqrt(2.0) - 1);
  proved(file, " --alpha 1");
}

// All vertices, by the simplex method in rational numbers (bench/hostile/trusses.py).
TEST_F(GuaranteedInterval, OfForcesThatMustBeZeroIsThatOfAllVertices) {
  const auto cables = case_file("unloaded_cables.toml");
  expect_interval(result_of(cables + " --alpha 0.065"), -0.1442679324541749, -0.09346384039900252);
  proved(cables, " --alpha 0.065");
  const auto strut = case_file("unloaded_strut.toml");
  expect_interval(result_of(strut + " --alpha 0.101"), -0.4910943865010687, 0.22534719099479553);
  proved(strut, " --alpha 0.101");
  const auto triangle = case_file("unloaded_triangle.toml");
  const std::string half_widths = " --alpha 0.031 --group-alpha a=0.033,b=0.044";
  expect_interval(result_of(triangle + half_widths), -1.5829354237880804, 2.9944798855665513);
  proved(triangle, half_widths);
}

// All eight vertices, by another program (HiGHS in SciPy).
TEST_F(GuaranteedInterval, OfABridgeIsThatOfAllVertices) {
  const auto file = example("truss-bridge.toml");
  for (const auto& [alpha, lower, upper] : {std::tuple("1", -2.6345770236779, 1.8827765994967),
                                            {"2", -2.4145770236779, 1.48},
                                            {"3", -2.1516106397987, 0.94},
                                            {"4", -1.7741106397987, 0.4}}) {
    expect_interval(result_of(file + " --alpha " + alpha), lower, upper);
  }
  EXPECT_THAT(
      proved(file, " --alpha 1"),
      AllOf(HasSubstr("PROVED: the worst-case load factor for alpha = 1 is between 1.88277"),
            HasSubstr("every load factor from -2.63457")));
}

// (29) as printed, with an M that is too small: 1.4317; the true value is 1.11629.
TEST_F(GuaranteedInterval, IsNotProvedByThePrintedProgram) {
  const auto call = case_file("bigm_sentence.toml") + " --alpha 0.317 --cuts none --big-m 1e-6";
  const auto run = shell(command + " limit " + call);
  EXPECT_EQ(run.exit_code, 3);
  EXPECT_THAT(run.output, Not(HasSubstr("It carries at least 1.43")));
  const auto json = result_of(call, 3);
  EXPECT_EQ(json["maximum"]["lower"]["standing"], "computed");
  EXPECT_NEAR(
      result_of(case_file("bigm_sentence.toml") + " --alpha 0.317")["maximum"]["upper"]["value"]
          .get<double>(),
      1.11629, 1e-5);
}

// By hand: wind w and snow s on two bars at right angles; the case with the lower known bound
// governs.
TEST_F(GuaranteedInterval, ReportsTheHalfWidthOfEachGroup) {
  const auto file = case_file("groups.toml");
  const auto wind = proved(file, " --group-alpha wind=5,snow=1");
  EXPECT_THAT(wind, HasSubstr("\"snow\" within +- 1, \"wind\" within +- 5"));
  EXPECT_THAT(wind, HasSubstr("between 8.042"));
  const auto snow = proved(file, " --group-alpha wind=1,snow=5");
  EXPECT_THAT(snow, HasSubstr("\"snow\" within +- 5, \"wind\" within +- 1"));
  EXPECT_THAT(snow, HasSubstr("between 7.642"));
}

TEST_F(GuaranteedInterval, UsesGroupsInSweepsAndExports) {
  const auto file = case_file("groups.toml");
  const auto swept = shell(command + " sweep " + file +
                           " --alpha 0,1 --group-alpha wind=5 --output " + argument("out.json"));
  EXPECT_EQ(swept.exit_code, 0) << swept.output;
  const auto points = Json::parse(content(in_folder("out.json")))["result"]["points"];
  ASSERT_EQ(points.size(), 2U);
  EXPECT_NEAR(points[0]["maximum"]["upper"]["value"].get<double>(), 10 * std::sqrt(2.0) - 5, 1e-6);
  EXPECT_NEAR(points[1]["maximum"]["upper"]["value"].get<double>(), 8.042135624, 1e-6);
  EXPECT_EQ(points[1]["minimum"]["upper"]["standing"], "proved");
  const auto exported = shell(command + " export mps " + file +
                              " --group-alpha wind=5,snow=1 --output " + argument("p.mps"));
  EXPECT_EQ(exported.exit_code, 0) << exported.output;
  const auto solved = shell(command + " mip " + argument("p.mps"));
  EXPECT_THAT(solved.output, HasSubstr("8.0421356"));
  for (const char* call : {" sweep ", " export mps "}) {
    const auto wrong = shell(command + call + file + " --alpha 1 --group-alpha widn=5" +
                             (std::string(call) == " sweep " ? "" : " --output x.mps"));
    EXPECT_EQ(wrong.exit_code, 2);
    EXPECT_THAT(wrong.output, HasSubstr("did you mean \"wind\"?"));
  }
}

// HiGHS in SciPy at both vertices; a derived M cannot be too small.
TEST_F(GuaranteedInterval, HasAPointByDisjunctiveCutsWithADerivedM) {
  const auto json = result_of(case_file("disjunctive_no_point.toml") +
                              " --group-alpha g0=19.4 --cuts disjunctive");
  EXPECT_NEAR(json["maximum"]["upper"]["value"].get<double>(), 1.515444077, 1e-8);
  EXPECT_EQ(json["maximum"]["upper"]["standing"], "proved");
  EXPECT_NEAR(json["zero_one"]["upper"].get<double>(), 1.515444077, 1e-6);
}

TEST_F(GuaranteedInterval, OfNoUncertaintyIsThatOfTheNominalLoad) {
  const auto file = case_file("lambda_zero_not_carried.toml");
  const auto json = result_of(file + " --alpha 0");
  expect_interval(json, 3 - std::sqrt(2.0), 3 + std::sqrt(2.0));
  EXPECT_THAT(proved(file, ""), HasSubstr("for alpha = 0 is between 4.41421"));
  expect_interval(result_of(case_file("groups.toml") + " --alpha 0 --group-alpha wind=5"),
                  -(10 * std::sqrt(2.0) - 5), 10 * std::sqrt(2.0) - 5);
}

// Two bars, two load cases. By hand: [-2 + 0.5, 3 - 0.5] with the tip pulled, and [-2 - 2 + 0.25, 3
// - 2 - 0.25] with the tip pushed.
class IntervalOfLoadCases : public GuaranteedInterval {
 protected:
  void write(const std::string& push) const {
    std::ofstream(in_folder("cases.toml")) << limit::two_bars(R"([[loads]]
kind = "dead"
case = "pull"
nodes = ["tip"]
force = [[-0.5, 0.5], -1]
[[loads]]
kind = "dead"
case = "push"
nodes = ["tip"]
force = )" + push + R"(
[[uncertainty]]
case = "push"
nodes = ["tip"]
axes = ["x"]
alpha = 0.25
)");
  }
  [[nodiscard]] std::string file() const { return argument("cases.toml"); }
};

TEST_F(IntervalOfLoadCases, IsProvedForAllCasesTogether) {
  write("[2, 0]");
  const auto json = result_of(file());
  expect_interval(json, -1.5, 0.75, 1e-8);
  expect_interval(json["cases"][1], -3.75, 0.75);
  const auto said = proved(file(), "");
  EXPECT_THAT(said, AllOf(HasSubstr("load case \"pull\""), HasSubstr("load case \"push\""),
                          HasSubstr("in these 2 load cases is between 0.7499")));
  const auto one = proved(file(), " --case pull");
  EXPECT_THAT(one, HasSubstr("not part of the certificate: load case \"push\""));
}

TEST_F(IntervalOfLoadCases, IsProvedIfOneCaseIsCarriedAtNoFactor) {
  write("[0, 9]");
  EXPECT_THAT(proved(file(), ""), HasSubstr("carried at no load factor"));
}

// A load that is not carried at any factor: the nominal one, and an admissible one.
TEST_F(GuaranteedInterval, IsEmptyIfALoadIsCarriedAtNoFactor) {
  const auto gap = example("static-gap.toml");
  const auto json = result_of(gap + " --alpha 3");
  EXPECT_EQ(json["carried_at_none"], "proved");
  EXPECT_THAT(proved(gap, " --alpha 3"), HasSubstr("carried at no load factor"));
  std::ofstream(in_folder("heavy.toml"))
      << limit::two_bars("[[loads]]\nkind = \"dead\"\nnodes = [\"tip\"]\nforce = [0, 90]\n");
  EXPECT_THAT(proved(argument("heavy.toml"), ""), HasSubstr("carried at no load factor"));
  EXPECT_THAT(proved(argument("heavy.toml"), " --alpha 1"), HasSubstr("carried at no load factor"));
}

// Every number of a certificate is replaced, one at a time: nothing false may be proved.
TEST_F(GuaranteedInterval, OfAForgedCertificateIsRefused) {
  const auto file = case_file("uplift.toml");
  proved(file, " --alpha 1.5");
  const auto text = content(in_folder("cert"));
  const auto forged = [&](const std::string& what, const std::string& with) {
    auto changed = text;
    const auto at = changed.find(what);
    EXPECT_NE(at, std::string::npos) << what;
    changed.replace(at, what.size(), with);
    std::ofstream(in_folder("forged")) << sealed(changed);
    return shell(command + " verify " + argument("forged") + " --problem " + file);
  };
  EXPECT_EQ(forged("theorem 1 least", "theorem 1 largest").exit_code, 2);
  EXPECT_EQ(forged("theorem 1 largest", "theorem 1 least").exit_code, 2);
  EXPECT_EQ(forged("theorem 1 largest", "theorem 1 none").exit_code, 2);
  EXPECT_EQ(forged("column 0x1.8p+0", "column 0x1.8p-1").exit_code, 1);
  EXPECT_EQ(forged("\ncase\n", "\ncase a\n").exit_code, 1);
}

}  // namespace
}  // namespace kusabi::test
