// Defaults from a file: its place, its permitted contents, and messages about it.
#include <fstream>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "tests/run/shell.hpp"

namespace kusabi::test {
namespace {

using testing::HasSubstr;
using testing::Not;

class Config : public Command {
 protected:
  // Writes a file of defaults into the folder. @return its name
  std::string config(const std::string& text, const std::string& name = "config.toml") {
    fs::create_directories(fs::path(in_folder(name)).parent_path());
    std::ofstream(in_folder(name)) << text;
    return in_folder(name);
  }

  // A call whose environment has no other defaults.
  [[nodiscard]] std::string call(const std::string& rest) const {
    return "env -u KUSABI_CONFIG XDG_CONFIG_HOME=" + argument("xdg") + " " + command + " " + rest;
  }
};

TEST_F(Config, SetsOptionsThatTheCallDoesNotSet) {
  const auto file = config("[patterns]\nmu = 0.65\nsort = \"margin\"\ntop = 2\n[rays]\nmu = 3\n");
  const auto result = in_folder("result.json");
  const auto rest = "patterns " + truss + " --output " + quoted(result);
  const auto run = shell(call(rest + " --config " + quoted(file)));
  EXPECT_EQ(run.exit_code, 0) << run.output;
  EXPECT_THAT(run.output,
              HasSubstr("\ndefaults of " + file + ": --mu 0.65 --sort margin --top 2\n"));
  EXPECT_THAT(run.output, HasSubstr("27 sign patterns"));
  const auto json = nlohmann::json::parse(content(result));
  EXPECT_EQ(json["config"]["file"], file);
  EXPECT_EQ(json["config"]["options"],
            (nlohmann::json{{"mu", "0.65"}, {"sort", "margin"}, {"top", "2"}}));
  // The call overrides the file.
  const auto own = shell(call(rest + " --mu 0.55 --config " + quoted(file)));
  EXPECT_THAT(own.output, HasSubstr("friction coefficient 0.55"));
  EXPECT_THAT(own.output, HasSubstr(": --sort margin --top 2\n"));
  // Without a file the result mentions none.
  const auto none = shell(call(rest + " --mu 0.65"));
  EXPECT_FALSE(nlohmann::json::parse(content(result)).contains("config"));
  EXPECT_THAT(none.output, Not(HasSubstr("defaults of")));
}

TEST_F(Config, IsFoundInTheStandardFolders) {
  const auto rest = "show " + truss;
  config("[show]\nquiet = true\n", "xdg/kusabi/config.toml");
  const auto other = config("[show]\nquiet = false\n", "other.toml");
  const auto broken = config("[show\n", "broken.toml");
  EXPECT_EQ(shell(call(rest)).output, "");
  EXPECT_NE(shell(call(rest + " --no-config")).output, "");
  EXPECT_NE(shell(call(rest + " --config " + quoted(other))).output, "");
  const auto named = [&](const std::string& file) {
    return "env XDG_CONFIG_HOME=" + argument("xdg") + " KUSABI_CONFIG=" + quoted(file) + " " +
           command + " " + rest;
  };
  EXPECT_NE(shell(named(other)).output, "");
  EXPECT_NE(shell(named("")).output, "");  // none at all
  EXPECT_THAT(shell(named(broken)).output, HasSubstr(broken + ":1:6: "));
  EXPECT_EQ(shell(named(broken) + " --config " + quoted(other)).exit_code, 0);
  const auto home =
      "env -u KUSABI_CONFIG -u XDG_CONFIG_HOME HOME=" + argument("home") + " " + command;
  config("[show]\nquiet = true\n", "home/.config/kusabi/config.toml");
  EXPECT_EQ(shell(home + " " + rest).output, "");
}

TEST_F(Config, ReportsFileLineAndKeyOfAFault) {
  struct Wrong {
    std::string text;
    std::string message;
  };
  const std::vector<Wrong> wrong{
      {"[paterns]\n", ":1:2: unknown table \"paterns\"; expected one of patterns, rays, "},
      {"[paterns]\n", "did you mean \"patterns\"?"},
      {"mu = 1\n", ":1:1: unknown table \"mu\""},
      {"patterns = 1\n", ":1:12: patterns: expected a table, [patterns]"},
      {"[example.gird]\n", ":1:10: unknown table of example \"gird\"; expected one of space-truss"},
      {"[rays]\nmuu = 1\n", ":2:1: unknown option \"muu\""},
      {"[patterns]\n\nfrictoin = 1\n",
       ":3:1: unknown option \"frictoin\"; expected one of mu, tol"},
      {"[patterns]\nmu = -1\n", ":2:6: mu: '-1', expected a number above 0"},
      {"[patterns]\nmu = [1]\n", ":2:6: mu: expected a number above 0"},
      {"[patterns]\nsort = \"name\"\n", ":2:8: sort: 'name', expected one of number, margin"},
      {"[patterns]\nquiet = 1\n", ":2:9: quiet: expected true or false"},
      {"[patterns]\noutput = \"a\"\n", ":2:1: output names a file of one run"},
      {"[patterns]\nresume = \"a\"\n", ":2:1: resume names a file of one run"},
      {"[patterns]\nserial = true\n", ":2:1: serial applies before this file is read"},
      {"[patterns]\nfile = \"a\"\n", ":2:1: unknown option \"file\""},
      {"[patterns]\nmu = 1\nmu = 2\n", ":3:6: "},
  };
  for (const auto& [text, message] : wrong) {
    const auto file = config(text);
    const auto run = shell(call("patterns " + truss + " --config " + quoted(file)));
    EXPECT_EQ(run.exit_code, 2) << text;
    EXPECT_THAT(run.output, HasSubstr(message)) << text;
    EXPECT_TRUE(run.output.starts_with(file)) << run.output;
    EXPECT_EQ(std::count(run.output.begin(), run.output.end(), '\n'), 1) << run.output;
  }
  const auto missing = shell(call("patterns " + truss + " --mu 1 --config " + argument("none")));
  EXPECT_EQ(missing.exit_code, 2);
  EXPECT_THAT(missing.output,
              HasSubstr("none: the file cannot be read; expected defaults in TOML"));
}

TEST_F(Config, OmitsOptionsWhoseRequiredOptionIsMissing) {
  const auto file = config("[limit]\nsamples = 3\n[patterns]\nmu = 0.65\nfacets = 8\n");
  const auto rest = " --config " + quoted(file);
  EXPECT_EQ(shell(call("patterns " + truss + rest)).exit_code, 0);
  EXPECT_EQ(shell(call("patterns " + truss + " --method cones" + rest)).exit_code, 0);
  const auto run = shell(call("patterns " + truss + " --method polyhedral --probe 4" + rest));
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_THAT(run.output, HasSubstr("--probe: requires --method cones"));
  EXPECT_THAT(run.output, HasSubstr("(defaults of " + file + ": --facets 8 --mu 0.65)\n"));
}

TEST_F(Config, IsTheSameOnAllRanks) {
  const auto file = config("[patterns]\nmu = 0.65\n");
  const auto rest = command + " patterns " + truss + " --config ";
  const auto run = shell(ranks(2) + rest + quoted(file));
  EXPECT_EQ(run.exit_code, 0) << run.output;
  EXPECT_THAT(run.output, HasSubstr("defaults of " + file));
  EXPECT_THAT(run.output, HasSubstr("27 sign patterns"));
  // A resumed search has the same options, even if the file changes.
  const auto stopped =
      shell(ranks(2) + rest + quoted(file) + " --node-limit 20 --resume " + argument("state"));
  EXPECT_EQ(stopped.exit_code, 3) << stopped.output;
  EXPECT_THAT(stopped.output, HasSubstr("--mu 0.65"));
  fs::remove(file);
  EXPECT_EQ(shell(ranks(2) + rest + quoted(file)).exit_code, 2);
}

}  // namespace
}  // namespace kusabi::test
