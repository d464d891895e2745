// kusabi limit with uncertain loads on several ranks, stopped at a limit, and its certificates.
#include <fstream>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "shell.hpp"

namespace kusabi::test {
namespace {

using testing::HasSubstr;

using WorstCaseCommand = Command;

std::string example_file(const std::string& name) {
  return quoted(std::string(KUSABI_SOURCE_DIR) + "/examples/" + name);
}

TEST_F(WorstCaseCommand, FindsTheSameOnOneAndTwoRanks) {
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
      EXPECT_THAT(proved.output, HasSubstr("PROVED: the worst-case load factor"));
    }
  }
}

TEST_F(WorstCaseCommand, StopsAtALimitWithItsBracket) {
  const auto run =
      shell(command + " limit " + example_file("paper/limit-3x3.toml") +
            " --alpha 40 --cuts none --node-limit 50 --output " + argument("out.json"));
  EXPECT_EQ(run.exit_code, 3) << run.output;
  EXPECT_THAT(run.output, HasSubstr("Stopped early (node-limit)"));
  const auto json = nlohmann::json::parse(content(in_folder("out.json")));
  EXPECT_EQ(json["status"], "node-limit");
  const auto& bracket = json["result"]["worst_case"];
  EXPECT_LT(json["result"]["zero_one"]["lower"], 37.0120);  // tests/reference/limit.json
  EXPECT_NEAR(bracket["lower"], 37.0120, 1e-4);             // by static cuts
  EXPECT_GE(bracket["upper"], 37.0120);
}

TEST_F(WorstCaseCommand, CertificateIsRefusedIfItClaimsTooMuch) {
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
  EXPECT_THAT(weak.output, HasSubstr("of the certificate, counted from 1, yields"));
  EXPECT_THAT(weak.output, HasSubstr("NOT PROVED"));
  const auto outside = spoilt("alpha 0x1.4p+5", "alpha 0x1.3p+5");
  EXPECT_EQ(outside.exit_code, 1) << outside.output;
  EXPECT_THAT(outside.output, HasSubstr("outside of its bounds"));
}

TEST_F(WorstCaseCommand, ReportsALoadCarriedAtNoFactor) {
  const auto run =
      shell(command + " limit " + example_file("paper/limit-3x3.toml") + " --alpha 4000");
  EXPECT_EQ(run.exit_code, 0) << run.output;
  EXPECT_THAT(run.output, HasSubstr("some admissible dead load is not carried at any load factor"));
}

TEST_F(WorstCaseCommand, NamesTheMissingSectionOfTheFile) {
  const auto run = shell(command + " limit " + truss);
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_THAT(run.output, HasSubstr("a [[members]] group has no yield"));
  const auto other =
      shell(command + " patterns " + example_file("paper/limit-3x3.toml") + " --mu 0.5");
  EXPECT_EQ(other.exit_code, 2);
  EXPECT_THAT(other.output, HasSubstr("no contact candidates; expected at least one [[contact]]"));
}

}  // namespace
}  // namespace kusabi::test
