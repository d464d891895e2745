// kusabi limit --lose: factors after the loss of members, on one rank and on two, and wrong calls.
#include <algorithm>
#include <fstream>
#include <string>
#include <utility>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "limit_calls.hpp"

namespace kusabi::test {
namespace {

using testing::ContainsRegex;
using testing::HasSubstr;
using testing::Not;

// By hand: a load of 3 + lambda hangs on three vertical bars of strength 5, 4 and 2.
const char* const hanger = R"(name = "hanger"
dimension = 2
units = { length = "m", force = "kN" }
[nodes]
a = [0, 0]
b = [0, 1]
c = [0, 2]
d = [0, 3]
[[members]]
yield = 5
between = [["a", "b"]]
[[members]]
yield = 4
between = [["a", "c"]]
[[members]]
yield = 2
between = [["a", "d"]]
[[supports]]
nodes = ["b", "c", "d"]
[[supports]]
nodes = ["a"]
fixed = ["x"]
[[loads]]
kind = "reference"
nodes = ["a"]
force = [0, -1]
[[loads]]
kind = "dead"
nodes = ["a"]
force = [0, -3]
)";

// Without the line ends of a narrow page.
std::string on_one_line(std::string text) {
  std::ranges::replace(text, '\n', ' ');
  return text;
}

class LossCommand : public LimitCalls {
 protected:
  [[nodiscard]] std::string verified_after(const std::string& from, const std::string& to) const;
  // Output of verify for the certificate of a call.
  [[nodiscard]] std::string proved_of(const std::string& call, const std::string& path) const {
    const auto run =
        shell(command + " limit " + path + call + " --certificate " + argument("cert"));
    EXPECT_EQ(run.exit_code, 0) << run.output;
    const auto proof = shell(command + " verify " + argument("cert") + " --problem " + path);
    EXPECT_EQ(proof.exit_code, 0) << proof.output;
    return on_one_line(proof.output);
  }
  [[nodiscard]] std::string proved(const std::string& call, const std::string& file) const {
    return proved_of(call, argument(file));
  }
  void write_hanger() const { std::ofstream(in_folder("hanger.toml")) << hanger; }
};

TEST_F(LossCommand, FindsTheLossOfTheStrongestBarsOfAHanger) {
  write_hanger();
  const auto file = argument("hanger.toml");
  const auto one = file_of(file + " --lose 1");
  EXPECT_NEAR(one["result"]["nominal"], 8, 1e-9);
  const auto& factor = one["result"]["factor"];
  EXPECT_LE(factor["lower"]["value"], 3);
  EXPECT_GE(factor["upper"]["value"], 3);
  EXPECT_NEAR(factor["lower"]["value"], 3, 1e-6);
  EXPECT_EQ(one["result"]["lost"], nlohmann::json({"a-b"}));
  const auto& loss = one["result"]["member_loss"];
  EXPECT_EQ(loss["standing"], "proved");
  ASSERT_EQ(loss["single"].size(), 3U);
  EXPECT_NEAR(loss["single"][1]["factor"], 4, 1e-9);
  EXPECT_NEAR(loss["single"][2]["factor"], 6, 1e-9);
  const auto two = file_of(file + " --lose 2")["result"];
  EXPECT_NEAR(two["factor"]["upper"]["value"], -1, 1e-6);  // the dead load alone is too large then
  EXPECT_EQ(two["member_loss"]["standing"], "proved");
  const auto three = file_of(file + " --lose 3")["result"];
  EXPECT_TRUE(three["fatal"].is_null());  // the factor -3 leaves no load
  EXPECT_NEAR(three["factor"]["upper"]["value"], -3, 1e-6);
  const auto kept = file_of(file + " --lose 1 --keep a-b")["result"];
  EXPECT_NEAR(kept["factor"]["upper"]["value"], 4, 1e-6);
  EXPECT_EQ(kept["member_loss"]["eligible"], 2);
  EXPECT_THAT(proved(" --lose 2 --keep \"a-b a-c a-d\"", "hanger.toml"),
              HasSubstr("except a-b a-c a-d (kept) the load factor is at least 7.99"));
}

TEST_F(LossCommand, DecidesWhetherAFactorRemains) {
  write_hanger();
  const auto file = argument("hanger.toml");
  const auto yes = file_of(file + " --lose 1 --at-least 2.9");
  EXPECT_TRUE(yes["result"]["reached"]);
  EXPECT_THAT(yes["verdict"]["sentence"],
              HasSubstr("After the loss of any one member the limit load factor is at least 2.9"));
  const auto no = file_of(file + " --lose 1 --at-least 3.1");
  EXPECT_FALSE(no["result"]["reached"]);
  EXPECT_THAT(no["verdict"]["sentence"],
              HasSubstr("After the loss of a-b the limit load factor is at most"));
}

TEST_F(LossCommand, ReportsALossThatLeavesNoFactor) {
  const auto json = file_of(example("truss-bridge.toml") + " --lose 3");
  EXPECT_EQ(json["result"]["fatal"], "proved");
  EXPECT_THAT(json["verdict"]["sentence"], HasSubstr("does not carry its dead load at any"));
}

TEST_F(LossCommand, IsTheSameOnOneAndTwoRanks) {
  for (const std::string& call :
       {example("paper/limit-4x4.toml") + " --lose 2 --keep \"2,4 3,4\"",
        example("truss-bridge.toml") + " --lose 2", example("truss-bridge.toml") + " --lose 1"}) {
    nlohmann::json alone;
    for (const std::string& launch : {std::string(), ranks(2)}) {
      const auto run =
          shell(launch + command + " limit " + call + " --output " + argument("out.json"));
      auto json = nlohmann::json::parse(content(in_folder("out.json")));
      json.erase("statistics");
      if (alone.is_null()) alone = json;
      EXPECT_EQ(json, alone) << run.output;
    }
  }
}

TEST_F(LossCommand, RefusesIncompatibleOptions) {
  write_hanger();
  const auto refusal = [&](const std::string& options) {
    const auto run = shell(command + " limit " + argument("hanger.toml") + ' ' + options);
    EXPECT_EQ(run.exit_code, 2) << run.output;
    return run.output;
  };
  EXPECT_THAT(refusal("--lose 1 --keep e"), HasSubstr("--keep 'e': no such node or member"));
  EXPECT_THAT(refusal("--lose 1 --sudden 0.5"), HasSubstr("--sudden"));
  EXPECT_THAT(refusal("--lose 1 --curve"), HasSubstr("--curve: not available with --lose"));
  EXPECT_THAT(refusal("--at-least 1"), HasSubstr("--lose"));
  EXPECT_THAT(refusal("--alpha 1 --cuts static --big-m 4"), HasSubstr("--big-m: requires --cuts"));
}

// By hand: the strengths are divided by the factor, (4 + 2) / 1.5 - 3. If all members are kept, the
// bound is not that of the truss without loss.
TEST_F(LossCommand, DividesTheStrengthAfterASuddenLoss) {
  write_hanger();
  const auto json = file_of(argument("hanger.toml") + " --lose 1 --sudden 1.5");
  const auto& upper = json["result"]["factor"]["upper"];
  EXPECT_NEAR(upper["value"], 1, 1e-6);
  EXPECT_EQ(upper["standing"], "proved");
  EXPECT_EQ(json["result"]["sudden"], 1.5);
  const std::string any = "fter the sudden loss of any one member with dynamic factor 1.5 the";
  EXPECT_THAT(json["verdict"]["sentence"], HasSubstr(any));
  EXPECT_THAT(proved(" --lose 1 --sudden 1.5", "hanger.toml"),
              HasSubstr("after the sudden loss of a-b with dynamic factor 1.5 it is at most"));
  const auto call = " --lose 1 --keep \"a-b a-c a-d\" --sudden 2";
  EXPECT_THAT(file_of(argument("hanger.toml") + call)["verdict"]["sentence"],
              Not(HasSubstr("without any loss")));
  EXPECT_THAT(proved(call, "hanger.toml"), Not(HasSubstr("without any loss")));
}

// By hand: an uplift or a load of 0.5 more, 4 + 2 - 3 - 0.5.
TEST_F(LossCommand, CombinesLossesWithUncertainLoads) {
  std::ofstream(in_folder("hanger.toml"))
      << hanger << "[[uncertainty]]\nnodes = [\"a\"]\naxes = [\"y\"]\n";
  const auto json = file_of(argument("hanger.toml") + " --lose 1 --alpha 0.5");
  for (const auto& [end, bound] : json["result"]["factor"].items()) {
    EXPECT_NEAR(bound["value"], 2.5, 1e-6) << end;
    EXPECT_EQ(bound["standing"], "proved") << end;
  }
  EXPECT_EQ(json["result"]["lost"], nlohmann::json({"a-b"}));
  EXPECT_THAT(json["verdict"]["sentence"], HasSubstr("under every admissible load"));
  const auto table = shell(command + " limit " + argument("hanger.toml") + " --lose 2 --alpha 0.5");
  EXPECT_THAT(table.output, HasSubstr("members no lower factor was found"));
  EXPECT_THAT(table.output, HasSubstr("negative: an admissible dead load alone then"));
}

TEST_F(LossCommand, StatesDoNotUseForcesOfLostMembersWithinTheTolerance) {
  EXPECT_THAT(proved_of(" --lose 1", case_file("force_of_a_lost_member.toml")),
              HasSubstr("PROVED"));
}

// A certificate proves its own half-widths where the file leaves them open.
TEST_F(LossCommand, VerifyNamesTheLoadsThatItProves) {
  const auto write = [&](const std::string& file, const std::string& more) {
    std::ofstream(in_folder(file)) << hanger << "[[uncertainty]]\nnodes = [\"a\"]\naxes = [\"y\"]\n"
                                   << more;
  };
  write("open.toml", "");
  write("wide.toml", "alpha = 0.5\n");
  for (const std::string alpha : {"0.25", "0.5"})
    EXPECT_THAT(proved(" --lose 1 --alpha " + alpha, "open.toml"),
                HasSubstr("and under every admissible load (alpha = " + alpha + ") the load"));
  EXPECT_THAT(proved(" --lose 1", "wide.toml"), HasSubstr("admissible load (alpha = 0.5)"));
  EXPECT_THAT(proved(" --lose 1", "open.toml"), HasSubstr("under the dead load as given"));
  const auto other =
      shell(command + " verify " + argument("cert") + " --problem " + argument("wide.toml"));
  EXPECT_THAT(other.output, HasSubstr("under the dead load as given"));
  write_hanger();
  EXPECT_THAT(proved(" --lose 1", "hanger.toml"), Not(HasSubstr("as given")));
}

TEST_F(LossCommand, WritesACertificateThatVerifyProves) {
  for (const std::string& call :
       {example("truss-bridge.toml") + " --lose 2", example("truss-bridge.toml") + " --lose 3",
        example("truss-bridge.toml") + " --lose 1 --alpha 1",
        example("truss-bridge.toml") + " --lose 1 --sudden 1.2"}) {
    const auto run = shell(command + " limit " + call + " --certificate " + argument("cert"));
    EXPECT_EQ(run.exit_code, 0) << run.output;
    const auto verify = command + " verify " + argument("cert");
    for (const std::string& call_of :
         {verify, verify + " --problem " + example("truss-bridge.toml"), ranks(2) + verify}) {
      const auto verified = shell(call_of);
      EXPECT_EQ(verified.exit_code, 0) << verified.output;
      EXPECT_THAT(verified.output, HasSubstr("PROVED"));
    }
    const auto other = shell(verify + " --problem " + example("roof-truss.toml"));
    EXPECT_NE(other.exit_code, 0) << other.output;
  }
}

TEST_F(LossCommand, AddsColumnsToTheTableOfMembers) {
  write_hanger();
  file_of(argument("hanger.toml") + " --lose 1 --keep a-d --csv " + argument("members.csv"));
  const auto table = content(in_folder("members.csv"));
  EXPECT_THAT(table, HasSubstr("factor_after_loss,state_after_loss,worst_loss"));
  EXPECT_THAT(table, HasSubstr("collapses,lost"));
  EXPECT_THAT(table, HasSubstr("kept,"));
}

// By hand: bars of 5, 4 and 2 in tension; the strut a-e below holds 3, and 0.9 after buckling.
std::string hanger_with_strut(const std::string& residual) {
  std::string text = hanger;
  text.replace(text.find("d = [0, 3]"), 10, "d = [0, 3]\ne = [0, -1]");
  text.replace(text.find("[\"b\", \"c\", \"d\"]"), 15, "[\"b\", \"c\", \"d\", \"e\"]");
  text.replace(text.find("[[supports]]"), 12,
               "[[members]]\nyield = { tension = 1, compression = 3" + residual +
                   " }\nbetween = "
                   "[[\"a\", \"e\"]]\n[[supports]]");
  return text;
}

TEST_F(LossCommand, GivesBothFactorsOfStruts) {
  std::ofstream(in_folder("hanger.toml")) << hanger_with_strut(", residual = 0.3");
  const auto json = file_of(argument("hanger.toml"));
  EXPECT_NEAR(json["result"]["nominal"], 11, 1e-9);
  EXPECT_THAT(
      json["verdict"]["sentence"],
      testing::AllOf(HasSubstr("It carries 8.8999 times"),
                     HasSubstr("; even with all struts at full strength no factor above 11")));
  const auto& struts = json["result"]["struts"];
  EXPECT_NEAR(struts["nominal"], 8.9, 1e-9);
  EXPECT_EQ(struts["at_strength"], nlohmann::json({"a-e"}));
  const auto lost = file_of(argument("hanger.toml") + " --lose 1")["result"];
  EXPECT_NEAR(lost["factor"]["upper"]["value"], 6, 1e-6);  // without a-b
  EXPECT_NEAR(lost["struts"]["factor"]["lower"]["value"], 3.9, 1e-6);
  EXPECT_EQ(file_of(argument("hanger.toml") +
                    " --lose 1 --sudden 1.5")["result"]["struts"]["at_strength"],
            nlohmann::json({"a-e"}));
  EXPECT_EQ(lost["struts"]["member_loss"]["standing"], "proved");
}

// The claim at residual strength is refused for any other residual strength.
TEST_F(LossCommand, ProvesBothFactorsOfStruts) {
  for (const std::string share : {", residual = 0.3", ", residual = 0.301", ""})
    std::ofstream(in_folder("hanger" + std::to_string(share.size()) + ".toml"))
        << hanger_with_strut(share);
  const auto certificate = argument("cert");
  const auto run =
      shell(command + " limit " + argument("hanger16.toml") + " --certificate " + certificate);
  ASSERT_EQ(run.exit_code, 0) << run.output;
  const auto verify = command + " verify " + certificate;
  const auto of_file = verify + " --problem " + argument("hanger16.toml");
  for (const auto& [call, strength] :
       {std::pair(verify, "the residual strengths of the certificate"),
        std::pair(of_file, "their residual strength")}) {
    const auto proved = shell(call);
    EXPECT_EQ(proved.exit_code, 0) << proved.output;
    EXPECT_THAT(proved.output, HasSubstr(std::string("all struts at ") + strength + ", PROVED"));
    EXPECT_THAT(proved.output, HasSubstr("and 8.9"));
    const auto claim = on_one_line(proved.output.substr(proved.output.rfind("PROVED")));
    EXPECT_THAT(claim, testing::AllOf(HasSubstr("is between 8.89"), HasSubstr("and 11"),
                                      HasSubstr("residual strength")));
  }
  for (const char* const other : {"hanger18.toml", "hanger0.toml"}) {
    const auto refused = shell(verify + " --problem " + argument(other));
    EXPECT_EQ(refused.exit_code, 1) << refused.output;
    EXPECT_THAT(refused.output, HasSubstr("NOT PROVED"));
  }
}

// By hand as in GivesBothFactorsOfStruts. Other residual strengths are refused.
TEST_F(LossCommand, ProvesBothFactorsOfStrutsAfterALoss) {
  for (const std::string share : {", residual = 0.3", ", residual = 0.301", ""})
    std::ofstream(in_folder("hanger" + std::to_string(share.size()) + ".toml"))
        << hanger_with_strut(share);
  const auto run = shell(command + " limit " + argument("hanger16.toml") +
                         " --lose 1 --certificate " + argument("cert"));
  ASSERT_EQ(run.exit_code, 0) << run.output;
  const auto verify = command + " verify " + argument("cert");
  for (const std::string& call : {verify, verify + " --problem " + argument("hanger16.toml")}) {
    const auto proved = shell(call);
    EXPECT_EQ(proved.exit_code, 0) << proved.output;
    EXPECT_THAT(proved.output, HasSubstr("strength"));
    EXPECT_THAT(proved.output, ContainsRegex("PROVED: after the loss of any member the load factor "
                                             "is at least (3.89999|3.9)"));
    EXPECT_THAT(proved.output, ContainsRegex("at least (5.99999|6)"));
  }
  for (const char* const other : {"hanger18.toml", "hanger0.toml"}) {
    const auto refused = shell(verify + " --problem " + argument(other));
    EXPECT_EQ(refused.exit_code, 1) << refused.output;
    EXPECT_THAT(refused.output, HasSubstr("NOT PROVED"));
  }
}

// By hand: case "hang" has 3 at both strengths; case "push" has 4, and 0.4 after buckling, so that it
// governs.
std::string tie_and_strut(const std::string& more = {}) {
  return R"(name = "tie and strut"
dimension = 2
units = { length = "m", force = "kN" }
[nodes]
a = [0, 0]
b = [0, 1]
c = [1, 0]
[[members]]
yield = 3
between = [["a", "b"]]
[[members]]
yield = { tension = 1, compression = 4, residual = 0.1 }
between = [["a", "c"]]
[[supports]]
nodes = ["b", "c"]
[[loads]]
kind = "reference"
case = "hang"
nodes = ["a"]
force = [0, -1]
[[loads]]
kind = "reference"
case = "push"
nodes = ["a"]
force = [1, 0]
)" + more;
}

std::string dead_load(const std::string& force) {
  return "[[loads]]\nkind = \"dead\"\ncase = \"hang\"\nnodes = [\"a\"]\nforce = " + force + "\n";
}

TEST_F(LossCommand, ReportsTheGoverningCaseBeforeAndAfterBuckling) {
  std::ofstream(in_folder("two.toml")) << tie_and_strut();
  const auto verdict = [&](const std::string& options) {
    return file_of(argument("two.toml") + options)["verdict"];
  };
  const auto json = file_of(argument("two.toml"));
  EXPECT_EQ(json["result"]["case"], "push");
  EXPECT_NEAR(json["result"]["nominal"], 4, 1e-9);
  EXPECT_NEAR(json["result"]["struts"]["nominal"], 0.4, 1e-9);
  EXPECT_NEAR(json["result"]["maximum"]["upper"]["value"], 3, 1e-6);
  EXPECT_THAT(json["verdict"]["details"].dump(),
              HasSubstr("is that of load case push, at residual"));
  EXPECT_THAT(shell(command + " limit " + argument("two.toml")).output,
              HasSubstr("the least factor is that of push\n"));
  EXPECT_THAT(verdict("")["sentence"],
              testing::ContainsRegex("It carries 0.(4|39999) times the reference load"));
  const auto uncertain = verdict(" --alpha 0.1 --certificate " + argument("cert"));
  EXPECT_THAT(uncertain["sentence"],
              testing::ContainsRegex("to 0.(4|39999) of the reference load"));
  EXPECT_THAT(uncertain["sentence"], HasSubstr("Open: whether every factor from 0 to 1"));
  EXPECT_NEAR(
      nlohmann::json::parse(content(in_folder("out.json")))["result"]["maximum"]["upper"]["value"],
      3, 1e-6);
  EXPECT_THAT(uncertain.dump(), Not(HasSubstr("not proved")));
  const auto proved =
      shell(command + " verify " + argument("cert") + " --problem " + argument("two.toml"));
  EXPECT_EQ(proved.exit_code, 0) << proved.output;
  EXPECT_THAT(proved.output, Not(HasSubstr("only")));
  EXPECT_THAT(proved.output.substr(proved.output.rfind("PROVED")),
              testing::ContainsRegex("is between 0.(4|399)"));
  const auto loss = file_of(argument("two.toml") + " --lose 1")["result"];
  EXPECT_NEAR(loss["factor"]["lower"]["value"], 0, 1e-6);
}

// The strut holds 4, and 0.4 after buckling, so that factor 1 is carried before buckling only.
TEST_F(LossCommand, DoesNotPassStrutsThatCarryTheLoadBeforeBucklingOnly) {
  std::ofstream(in_folder("push.toml")) << tie_and_strut();
  const auto json = file_of(argument("push.toml") + " --case push --alpha 0");
  EXPECT_NEAR(json["result"]["maximum"]["lower"]["value"], 0.4, 1e-6);
  EXPECT_NEAR(json["result"]["maximum"]["upper"]["value"], 4, 1e-6);
  EXPECT_THAT(json["verdict"]["sentence"], Not(HasSubstr("Passed")));
  const auto swept = shell(command + " sweep " + argument("push.toml") + " --case push --alpha 1");
  EXPECT_EQ(swept.exit_code, 2) << swept.output;
  EXPECT_THAT(swept.output, HasSubstr("has members with `residual`"));
}

TEST_F(LossCommand, VerifiesStrutsOfAChosenCase) {
  std::ofstream(in_folder("two.toml")) << tie_and_strut();
  const auto run = shell(command + " limit " + argument("two.toml") +
                         " --case push --lose 1 --keep a-b --certificate " + argument("cert"));
  ASSERT_EQ(run.exit_code, 0) << run.output;
  const auto verify = command + " verify " + argument("cert") + " --problem ";
  const auto proved = shell(verify + argument("two.toml"));
  EXPECT_EQ(proved.exit_code, 0) << proved.output;
  EXPECT_THAT(proved.output, HasSubstr("in load case \"push\""));
  std::ofstream(in_folder("bar.toml")) << R"(name = "bar"
dimension = 2
units = { length = "m", force = "kN" }
[nodes]
a = [0, 0]
b = [1, 0]
[[members]]
yield = 1
between = [["a", "b"]]
[[supports]]
nodes = ["a"]
[[supports]]
nodes = ["b"]
fixed = ["y"]
[[loads]]
kind = "reference"
nodes = ["b"]
force = [1, 0]
)";
  const auto refused = shell(verify + argument("bar.toml"));
  EXPECT_EQ(refused.exit_code, 1) << refused.output;
  EXPECT_THAT(refused.output, HasSubstr("refused"));
}

// Without the claim of the second case the factor of the first one would be that of both.
TEST_F(LossCommand, ResidualClaimsOfSomeCasesAreNoLowerBoundAfterALoss) {
  std::ofstream(in_folder("two.toml")) << tie_and_strut();
  const auto run = shell(command + " limit " + argument("two.toml") + " --lose 1 --certificate " +
                         argument("cert"));
  ASSERT_EQ(run.exit_code, 0) << run.output;
  const auto verify =
      command + " verify " + argument("cert") + " --problem " + argument("two.toml");
  EXPECT_THAT(shell(verify).output, HasSubstr("all struts at their residual strength, PROVED"));
  auto text = content(in_folder("cert"));
  const auto theorem = text.rfind("\ntheorem 2 largest residual");
  ASSERT_LT(theorem, text.size());
  text.erase(theorem, text.rfind("\nend") - theorem);
  text.replace(text.find("theorems 4"), 10, "theorems 3");
  std::ofstream(in_folder("cert")) << sealed(text);
  const auto weaker = shell(verify);
  EXPECT_EQ(weaker.exit_code, 0) << weaker.output;
  EXPECT_THAT(weaker.output,
              HasSubstr("the claims at residual strength are for load case \"hang\" only"));
  EXPECT_THAT(weaker.output.substr(weaker.output.rfind("PROVED")),
              testing::AllOf(HasSubstr("at most"), Not(HasSubstr("at least"))));
}

TEST_F(LossCommand, NamesTheLossInTheSentenceOnStruts) {
  std::ofstream(in_folder("hanger.toml")) << hanger_with_strut(", residual = 0.3");
  EXPECT_THAT(file_of(argument("hanger.toml") + " --lose 1")["verdict"]["sentence"],
              testing::ContainsRegex("while no strut falls below its residual strength, the limit "
                                     "load factor is at least 3.(9|899)"));
  std::ofstream(in_folder("two.toml")) << tie_and_strut(dead_load("[0.2, 0]"));
  const auto fatal = file_of(argument("two.toml") + " --lose 1")["verdict"].dump();
  EXPECT_THAT(fatal,
              HasSubstr("After the loss of a-c it does not carry its dead load at any load"));
  EXPECT_THAT(fatal, Not(HasSubstr("residual")));  // it follows
}

// @return the output of verify for a certificate with a replaced line and a correct digest
std::string LossCommand::verified_after(const std::string& from, const std::string& to) const {
  auto text = content(in_folder("cert"));
  text.resize(text.rfind("digest "));
  const auto at = text.rfind(from);
  EXPECT_NE(at, std::string::npos) << from;
  text.replace(at, from.size(), to);
  std::ofstream(in_folder("other")) << text;
  const auto other = argument("other");
  shell("printf 'digest %s\\n' $(sha1sum < " + other + " | cut -d' ' -f1) >> " + other);
  return on_one_line(
      shell(command + " verify " + other + " --problem " + argument("two.toml")).output);
}

TEST_F(LossCommand, OneClaimForCasesThatDifferIsRefused) {
  auto text = tie_and_strut();
  text.erase(text.find(", residual = 0.1"), 16);
  std::ofstream(in_folder("two.toml")) << text;
  const auto certificate = " --certificate " + argument("cert");
  file_of(argument("two.toml") + " --lose 1 --keep a-b" + certificate);
  EXPECT_THAT(verified_after("0x1p+0 1 0\n", "0x1p+0 1 0\n"),
              testing::AllOf(HasSubstr("load case \"hang\""), HasSubstr("load case \"push\""),
                             HasSubstr("any member except a-b (kept) in each of 2 load")));
  EXPECT_THAT(verified_after("0x1p+0 1 0\n", "0x1p+0 0\n"), HasSubstr("with the same losses"));
  EXPECT_THAT(verified_after("strength 1 0x1p+0", "strength 1 0x1.8p+0"),
              HasSubstr("with the same losses"));
  file_of(argument("two.toml") + " --case hang --lose 1" + certificate);
  const auto one = verified_after("case\n", "case\n");
  EXPECT_THAT(one, HasSubstr("not part of the certificate: load case \"push\""));
  EXPECT_THAT(one, HasSubstr("in load case \"hang\""));
  // The same case without its name and with it.
  auto twice = content(in_folder("cert"));
  const auto add = [&](const std::string& from, const std::string& to, const std::string& count) {
    const auto first = twice.find(from);
    const auto block = twice.substr(first, twice.find(to) - first);
    twice.insert(twice.find(to), block);
    twice.replace(twice.find(count), count.size(), count.substr(0, count.size() - 1) + "2");
  };
  const auto once = twice;
  add("\ncase\n", "\ntheorems", "cases 1");
  add("\ntheorem 1 ", "\nend", "theorems 1");
  twice.replace(twice.rfind("\ncase\n"), 6, "\ncase hang\n");
  twice.replace(twice.rfind("\ntheorem 1"), 10, "\ntheorem 2");
  std::ofstream(in_folder("cert")) << twice;
  EXPECT_THAT(verified_after("end", "end"),
              HasSubstr("different names of load cases; only a single one may have none"));
  std::ofstream(in_folder("cert")) << once;
  const auto none = verified_after("case\n", "case lift\n");
  EXPECT_THAT(none, HasSubstr("refused: "));
  EXPECT_THAT(none, HasSubstr("no load case \"lift\""));
}

// Without a loss the dead load is carried at no factor: the certificate proves this.
TEST_F(LossCommand, WritesTheCertificateOfALoadThatIsNotCarriedWithoutLoss) {
  std::ofstream(in_folder("two.toml")) << tie_and_strut(dead_load("[5, 0]"));
  EXPECT_THAT(proved(" --case hang --lose 1", "two.toml"), HasSubstr("at no load factor"));
}

// The load is just carried by two bars at full strength, which rounding errors leave unproved.
TEST_F(LossCommand, WritesNoCertificateOfClaimsAtResidualStrengthOnly) {
  std::ofstream(in_folder("just.toml")) << R"(name = "just carried"
dimension = 2
units = { length = "m", force = "kN" }
[nodes]
a = [0, 0]
b = [1, -3]
c = [-1, -3]
[[members]]
yield = { tension = 1, compression = 3.1622776601683795, residual = 0.5 }
between = [["a", "b"], ["a", "c"]]
[[supports]]
nodes = ["b", "c"]
[[loads]]
kind = "reference"
nodes = ["a"]
force = [1, 0]
[[loads]]
kind = "dead"
nodes = ["a"]
force = [0, -6]
)";
  const auto run = shell(command + " limit " + argument("just.toml") + " --alpha 0 --certificate " +
                         argument("cert"));
  EXPECT_EQ(run.exit_code, 3) << run.output;
  EXPECT_THAT(run.output,
              HasSubstr("all at their residual strength: the dead load is carried at no load "
                        "factor of either sign, proved"));
  EXPECT_THAT(on_one_line(run.output), HasSubstr("No certificate was written"));
  EXPECT_FALSE(std::ifstream(in_folder("cert")));
}

// Limit analysis does not apply to case "self", the first one, which the certificate is not about.
TEST_F(LossCommand, VerifiesACaseBesideOneWithoutReferenceLoad) {
  auto text = tie_and_strut();
  text.insert(text.find("[[loads]]"),
              "[[loads]]\nkind = \"dead\"\ncase = \"self\"\nnodes = [\"a\"]\nforce = [0, -1]\n");
  std::ofstream(in_folder("cases.toml")) << text;
  EXPECT_THAT(proved(" --case push --alpha 1", "cases.toml"), HasSubstr("load case \"push\""));
  EXPECT_THAT(proved(" --case push --lose 1 --keep a-b", "cases.toml"),
              HasSubstr("load case \"push\""));
}

// A sum of zero in double precision, of -2.8e-17 exactly.
TEST_F(LossCommand, ProvesLoadsThatCancelAtANode) {
  auto text = tie_and_strut();
  for (const std::string force : {"[0, 0.1]", "[0, 0.3]", "[0, -0.4]"})
    text += "[[loads]]\nkind = \"dead\"\ncase = \"push\"\nnodes = [\"a\"]\nforce = " + force + "\n";
  std::ofstream(in_folder("cancel.toml")) << text;
  EXPECT_THAT(proved(" --case push --alpha 0.1", "cancel.toml"), HasSubstr("PROVED"));
}

// The half-width of each case is one number, but not the same.
TEST_F(LossCommand, VerifyListsHalfWidthsThatDifferBetweenCases) {
  const auto uncertain = [](const std::string& name, const std::string& axis,
                            const std::string& alpha) {
    return "[[uncertainty]]\ncase = \"" + name + "\"\nnodes = [\"a\"]\naxes = [\"" + axis +
           "\"]\nalpha = " + alpha + "\n";
  };
  auto text = tie_and_strut(uncertain("hang", "y", "0.5") + uncertain("push", "x", "0.25"));
  text.erase(text.find(", residual = 0.1"), 16);
  std::ofstream(in_folder("two.toml")) << text;
  for (const std::string call : {"", " --lose 1 --keep \"a-b a-c\""}) {
    const auto proof = proved(call, "two.toml");
    EXPECT_THAT(proof, HasSubstr("load case \"hang\" uncertain loads: 1 unnamed within +- 0.5"));
    EXPECT_THAT(proof, HasSubstr("load case \"push\" uncertain loads: 1 unnamed within +- 0.25"));
    EXPECT_THAT(proof, HasSubstr("uncertain loads within these half-widths"));
  }
  const auto all = file_of(argument("two.toml"))["result"]["maximum"];
  EXPECT_NEAR(all["lower"]["value"], 2.5, 1e-6);
  shell(command + " report " + argument("out.json") + " --output " + argument("page.html"));
  EXPECT_THAT(content(in_folder("page.html")),
              HasSubstr("every admissible load in every load case is carried at factors up to"));
}

TEST_F(LossCommand, LimitWarnsOfObstacles) {
  std::ofstream(in_folder("contact.toml"))
      << hanger << "[[contact]]\nnodes = [\"a\"]\nnormal = [0, 1]\n";
  const auto run = shell(command + " limit " + argument("contact.toml"));
  EXPECT_EQ(run.exit_code, 0) << run.output;
  EXPECT_THAT(run.output, HasSubstr("kusabi limit ignores [[contact]]"));
}

// All free displacements have loads, so that no load is uncertain.
TEST_F(LossCommand, AlphaWithoutUncertainLoadsHasNoEffect) {
  write_hanger();
  const auto run = shell(command + " limit " + argument("hanger.toml") + " --alpha 40 --output " +
                         argument("out.json"));
  EXPECT_THAT(run.output, HasSubstr("--alpha has no effect"));
  const auto json = nlohmann::json::parse(content(in_folder("out.json")));
  EXPECT_EQ(json["result"]["uncertain"]["half_width"], 0);
  EXPECT_THAT(json["verdict"]["sentence"], HasSubstr("under its dead load"));
  const auto swept = shell(command + " sweep " + argument("hanger.toml") + " --alpha 1");
  EXPECT_EQ(swept.exit_code, 2) << swept.output;
  EXPECT_THAT(swept.output, HasSubstr("no load on a free displacement is uncertain"));
}

// Case "hang" is carried at no factor, so it is not analysed after buckling.
TEST_F(LossCommand, NamesTheCasesOfClaimsAtResidualStrength) {
  std::ofstream(in_folder("two.toml")) << tie_and_strut(dead_load("[5, 0]"));
  const auto json = file_of(argument("two.toml") + " --certificate " + argument("cert"));
  EXPECT_THAT(json["verdict"].dump(), Not(HasSubstr("residual strength")));
  const auto proved =
      shell(command + " verify " + argument("cert") + " --problem " + argument("two.toml"));
  EXPECT_EQ(proved.exit_code, 0) << proved.output;
  EXPECT_THAT(proved.output,
              HasSubstr("the claims at residual strength are for load case \"push\" only"));
}

}  // namespace
}  // namespace kusabi::test
