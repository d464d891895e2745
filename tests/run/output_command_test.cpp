// Files that the command writes: results, pipes, links, traces, and the state of the whole
// structure.
#include <array>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <sys/stat.h>

#include "shell.hpp"

namespace kusabi::test {
namespace {

using testing::HasSubstr;

using CommandOutput = Command;

TEST_F(CommandOutput, IsEmptyIfQuiet) {
  const auto run = shell(command + " patterns " + truss + " --mu 0.55 --quiet");
  EXPECT_EQ(run.exit_code, 0);
  EXPECT_EQ(run.output, "");
}

// Long lists have the whole state of 100 patterns, and of the one that the verdict names.
TEST_F(CommandOutput, HasTheWholeStateOfAllPatternsOnRequest) {
  const auto patterns = [&](const std::string& option) {
    shell(command + " patterns " + truss + " --mu 1 --quiet --output " + argument("all.json") +
          option);
    return nlohmann::json::parse(content(in_folder("all.json")))["result"]["patterns"];
  };
  const auto few = patterns("");
  const auto all = patterns(" --whole");
  ASSERT_EQ(few.size(), 251U);
  ASSERT_EQ(all.size(), few.size());
  std::size_t best = 0;
  for (std::size_t i = 1; i < all.size(); ++i)
    if (all[i]["margin"] > all[best]["margin"]) best = i;
  for (std::size_t i = 0; i < all.size(); ++i) {
    EXPECT_TRUE(all[i].contains("all_displacements"));
    if (i < 100 || i == best) {
      EXPECT_EQ(few[i], all[i]);
    } else {
      EXPECT_FALSE(few[i].contains("displacement"));
      EXPECT_FALSE(few[i].contains("imbalance"));
      EXPECT_EQ(few[i]["reaction"], all[i]["reaction"]);
    }
  }
  EXPECT_EQ(shell(command + " draw " + argument("all.json") + " --pattern 250 --output " +
                  argument("one.svg"))
                .exit_code,
            0);
}

// W (4) and (5): contact forces and support reactions are in equilibrium.
TEST_F(CommandOutput, HasTheWholeStateOfTheStructure) {
  const auto plane = quoted(std::string(KUSABI_SOURCE_DIR) + "/examples/plane-truss.toml");
  for (const std::string& call : {" patterns " + plane + " --mu 1", " critical " + plane,
                                  " rays " + plane + " --mu 1 --whole"}) {
    ASSERT_EQ(shell(command + call + " --quiet --output " + argument("all.json")).exit_code, 0);
    const auto json = nlohmann::json::parse(content(in_folder("all.json")));
    const auto& result = json["result"];
    const auto& configurations = result.contains("rays") ? result["rays"] : result["patterns"];
    ASSERT_FALSE(configurations.empty());
    for (const auto& each : configurations) {
      EXPECT_LE(each["imbalance"], 1e-12) << call;
      std::array<double, 2> sum{};
      double size = 0;
      const auto& frames = json["problem"]["contact"];
      for (std::size_t i = 0; i < frames.size(); ++i) {
        const auto& frame = frames[i];
        for (std::size_t axis = 0; axis < 2; ++axis) {
          const double n = frame["n"][axis];
          const double t = frame["t1"][axis];
          const double force =
              each["reaction"][i][0].get<double>() * n + each["reaction"][i][1].get<double>() * t;
          sum[axis] += force;
          size += std::abs(force);
          // The candidate's own displacement, in global axes.
          const double u = each["displacement"][i][0].get<double>() * n +
                           each["displacement"][i][1].get<double>() * t;
          const auto node = json["problem"]["structure"]["candidates"][i].get<std::size_t>();
          const double whole = each["all_displacements"][node][axis];
          EXPECT_NEAR(u, whole, 1e-9 * (std::abs(u) + 1));
        }
      }
      EXPECT_EQ(each["support_reactions"].size(), 5U);
      for (const auto& support : each["support_reactions"]) {
        for (std::size_t axis = 0; axis < 2; ++axis) sum[axis] += support[axis].get<double>();
      }
      EXPECT_LE(std::abs(sum[0]) + std::abs(sum[1]), 1e-12 * size) << call;
    }
  }
}

TEST_F(CommandOutput, DoesNotOverwriteTheProblem) {
  fs::copy_file(truss_file, in_folder("truss.toml"));
  fs::create_symlink("truss.toml", in_folder("link"));
  const auto call = command + " patterns " + argument("truss.toml") + " --mu 0.5 --output ";
  for (const auto* other_name : {"truss.toml", "./truss.toml", "link"}) {
    const auto run = shell(call + argument(other_name));
    EXPECT_EQ(run.exit_code, 2) << other_name;
    EXPECT_THAT(
        run.output,
        HasSubstr(other_name +
                  std::string(": would overwrite the problem file; expected another name\n")));
    EXPECT_EQ(content(in_folder("truss.toml")), content(truss_file)) << other_name;
  }
  EXPECT_EQ(files(), (std::vector<std::string>{"link", "truss.toml"}));
}

TEST_F(CommandOutput, DoesNotOverwriteAFileThatTheProblemNames) {
  const std::string cases = std::string(KUSABI_SOURCE_DIR) + "/tests/cases/";
  for (const auto* name : {"c_lc8_o1.toml", "plug_lc8_o1.msh"})
    fs::copy_file(cases + name, in_folder(name));
  const auto mesh = content(in_folder("plug_lc8_o1.msh"));
  const auto run = shell(command + " export matrix " + argument("c_lc8_o1.toml") + " --output " +
                         argument("plug_lc8_o1.msh"));
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_THAT(run.output, HasSubstr("which the problem file names; expected another name\n"));
  EXPECT_EQ(content(in_folder("plug_lc8_o1.msh")), mesh);
}

TEST_F(CommandOutput, IsWrittenToTheTargetOfALink) {
  std::ofstream(in_folder("old.json")) << "old";
  fs::create_symlink("old.json", in_folder("link"));
  const auto call = command + " patterns " + truss + " --mu 0.5 --quiet --output ";
  ASSERT_EQ(shell(call + argument("link")).exit_code, 0);
  EXPECT_TRUE(fs::is_symlink(in_folder("link")));
  EXPECT_EQ(nlohmann::json::parse(content(in_folder("old.json")))["command"], "patterns");
}

TEST_F(CommandOutput, IsWrittenToAPipeWithoutReplacingIt) {
  const auto call = command + " patterns " + truss + " --mu 0.5 --quiet --output ";
  EXPECT_EQ(nlohmann::json::parse(shell(call + "/dev/stdout").output)["command"], "patterns");
  ASSERT_EQ(mkfifo(in_folder("pipe").c_str(), 0600), 0);
  const auto run =
      shell("{ cat " + argument("pipe") + " & " + call + argument("pipe") + "; wait; }");
  EXPECT_EQ(nlohmann::json::parse(run.output)["command"], "patterns");
  EXPECT_TRUE(fs::is_fifo(in_folder("pipe")));
}

TEST_F(CommandOutput, LeavesNoIncompleteFileAfterAnError) {
  std::ofstream(in_folder("typo.toml")) << "name = 1\n";
  shell(command + " patterns " + argument("typo.toml") + " --mu 0.5 --output " +
        argument("result.json"));
  EXPECT_EQ(files(), std::vector<std::string>{"typo.toml"});
}

TEST_F(CommandOutput, CanBePipedFromAndToOtherCommands) {
  const auto through = shell(command + " example plane-truss --rows 5 | " + command +
                             " patterns - --mu 1 --output - 2>/dev/null");
  EXPECT_EQ(through.exit_code, 0);
  const auto piped = nlohmann::json::parse(through.output);
  ASSERT_EQ(shell(command + " example plane-truss --rows 5 --output " + argument("five.toml") +
                  " && " + command + " patterns " + argument("five.toml") +
                  " --mu 1 --quiet --output " + argument("result.json"))
                .exit_code,
            0);
  const auto filed = nlohmann::json::parse(content(in_folder("result.json")));
  EXPECT_EQ(piped["result"]["patterns"], filed["result"]["patterns"]);
  EXPECT_EQ(piped["problem"]["fingerprint"], filed["problem"]["fingerprint"]);
  EXPECT_FALSE(fs::exists("-"));
  const auto wrong = shell("echo 'name = ' | " + command + " patterns - --mu 1");
  EXPECT_EQ(wrong.exit_code, 2);
  EXPECT_THAT(wrong.output, HasSubstr("-:1:8: "));
  const auto twice = shell(command + " patterns " + truss + " --mu 1 --output - --trace -");
  EXPECT_EQ(twice.exit_code, 2);
}

// The open standard output keeps its text from before and receives that of later commands.
TEST_F(CommandOutput, IsAppendedToTheOpenStandardOutput) {
  const auto call = command + " patterns " + truss + " --mu 0.65 --output ";
  const auto file = in_folder("all");
  for (const auto* const name : {"-", "/dev/stdout --quiet"}) {
    const auto run =
        shell("{ echo before; " + call + name + "; echo after; } > " + argument("all"));
    EXPECT_EQ(run.exit_code, 0) << run.output;
    const auto text = content(file);
    ASSERT_TRUE(text.starts_with("before\n{") && text.ends_with("}\nafter\n")) << text;
    const auto json = text.substr(7, text.size() - 7 - 6);
    EXPECT_EQ(nlohmann::json::parse(json)["command"], "patterns");
  }
  EXPECT_EQ(std::distance(fs::directory_iterator(fs::path(file).parent_path()), {}), 1);
  const auto full = shell("{ " + call + "- > /dev/full; }");
  EXPECT_EQ(full.exit_code, 1);
  EXPECT_THAT(full.output, HasSubstr("standard output"));
}

TEST_F(CommandOutput, HasATraceOfAllRanksAndTheSameResult) {
  const std::string call = command + " patterns " + truss + " --mu 1.0 --quiet --output ";
  const auto plain = in_folder("plain.json");
  ASSERT_EQ(shell(call + quoted(plain)).exit_code, 0);
  const auto file = in_folder("result.json");
  const auto trace = in_folder("trace.json");
  for (int count = 1; count <= 2; ++count) {
    const auto run = shell(ranks(count) + call + quoted(file) + " --trace " + quoted(trace));
    ASSERT_EQ(run.exit_code, 0) << run.output;
    EXPECT_EQ(without_statistics(file), without_statistics(plain));
    const auto events = nlohmann::json::parse(content(trace))["traceEvents"];
    std::vector<double> work_ends(static_cast<std::size_t>(count), 0);
    for (const auto& event : events) {
      ASSERT_LT(event["pid"], count);
      if (event["ph"] != "X" || event["tid"] != 0) continue;
      auto& end = work_ends[event["pid"].get<std::size_t>()];
      // Times are written to the nanosecond; their sums are rounded.
      constexpr double rounding = 1e-3;
      EXPECT_GE(event["ts"].get<double>(), end - rounding);
      EXPECT_GE(event["dur"].get<double>(), 0);
      end = event["ts"].get<double>() + event["dur"].get<double>();
    }
    for (const double end : work_ends) EXPECT_GT(end, 0);
  }
  EXPECT_EQ(files(), (std::vector<std::string>{"plain.json", "result.json", "trace.json"}));
}

}  // namespace
}  // namespace kusabi::test
