// Calls that the command refuses with one line each, its help, and searches without MPI.
#include <algorithm>
#include <fstream>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <mpi.h>
#include <nlohmann/json.hpp>

#include "shell.hpp"

namespace kusabi::test {
namespace {

using testing::HasSubstr;

TEST_F(Command, ReportsAnInvalidFileInOneLineWithExitCodeTwo) {
  const auto file = in_folder("typo.toml");
  std::ofstream(file) << "name = \"x\"\ndimensions = 3\n";
  const auto run = shell(command + " patterns " + quoted(file) + " --mu 0.5");
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_THAT(run.output, HasSubstr(file + ":2:1: "));
  EXPECT_THAT(run.output, HasSubstr("dimensions"));
  EXPECT_EQ(std::count(run.output.begin(), run.output.end(), '\n'), 1) << run.output;
}

TEST_F(Command, ReportsAnInvalidFileOnceForAllRanks) {
  const auto run =
      shell(fmt::format("{} {} patterns {} --mu 1", ranks(3), command, argument("none.toml")));
  EXPECT_EQ(run.exit_code, 2);
  const auto first = run.output.find("none.toml: the file cannot be read");
  ASSERT_NE(first, std::string::npos);
  EXPECT_EQ(run.output.find("none.toml: the file cannot be read", first + 1), std::string::npos);
}

// One line each, with the fault and the expectation.
TEST_F(Command, RefusesInvalidCallsInOneLine) {
  const std::string good = "patterns " + truss + " --mu 0.5";
  const std::string above_0 = "expected a number above 0";
  const std::string all =
      "expected one of patterns, rays, critical, hold, limit, sweep, mip, verify";
  const auto plane = quoted(std::string(KUSABI_SOURCE_DIR) + "/examples/plane-truss.toml");
  struct Wrong {
    std::string call;
    std::string message;
  };
  const std::vector<Wrong> wrong{
      {"paterns " + truss + " --mu 0.5", "no subcommand 'paterns'; did you mean patterns?"},
      {"none-of-these " + truss + " --mu 0.5", "no subcommand 'none-of-these'; " + all},
      {truss + " --mu 0.5", "a subcommand must precede "},
      {"help nothing", "no subcommand 'nothing'; " + all},
      {"grid --bays 2", "no subcommand 'grid'; did you mean example grid?"},
      {"bench", "kusabi bench has no subcommand; expected one of scaling, schedules, uts"},
      {"example gird", "kusabi example has no subcommand 'gird'; did you mean grid?"},
      {"--quiet " + good, "no option --quiet; options of a subcommand follow it"},
      {"--completion tcsh", "--completion: 'tcsh', expected one of bash, zsh, fish"},
      {"patterns --facest 8", "patterns has no option --facest; did you mean --facets?"},
      {"patterns " + truss + " --frction 0.5", "did you mean --mu (friction coefficient)?"},
      {"limit " + truss + " --facets 8", "limit has no option --facets; it is one of patterns"},
      {good + " --output", "--output has no value; expected the name of a file"},
      {good + " --mu 0.6", "--mu is given more than once"},
      {good + " more.toml", "'more.toml' is superfluous; patterns takes one file"},
      {good + " -- --mu", "'--mu' is superfluous; patterns takes one file"},
      {"patterns", "file is required"},
      {"patterns x.toml", "--mu is required"},
      {"patterns " + truss, "--mu is required"},
      {"patterns " + truss + " --mu 0", "--mu: '0', " + above_0},
      {"patterns " + truss + " --mu -1", "--mu: '-1', " + above_0},
      {"patterns " + truss + " --mu nan", "--mu: 'nan', " + above_0},
      {"patterns " + truss + " --mu inf", "--mu: 'inf', " + above_0},
      {"patterns " + truss + " --mu 1,5", "--mu: '1,5', " + above_0},
      {"patterns " + truss + " --mu 0:1:0.1", "for a range: kusabi sweep FILE --mu 0:1:0.1"},
      {"limit " + truss + " --alpha 0:60:5", "for a range: kusabi sweep FILE --alpha 0:60:5"},
      {"patterns " + truss + " --mu ''", "--mu: '', " + above_0},
      {"patterns none.toml --mu 0.5", "none.toml: the file cannot be read"},
      {"patterns " + quoted(folder_.string()) + " --mu 0.5", "cannot be read"},
      {good + " --nonsense", "patterns has no option --nonsense (try kusabi patterns --help)"},
      {good + " --tolerance 0", "--tolerance: '0', expected a number from 1e-12 to 0.001"},
      {good + " --tolerance 0.1", "--tolerance: '0.1', expected a number from 1e-12 to 0.001"},
      {good + " --output /nowhere/at/all.json", "--output /nowhere/at/all.json: cannot be written"},
      {good + " --trace /nowhere/at/all.json", "--trace /nowhere/at/all.json: cannot be written"},
      {good + " --output " + quoted(folder_.string()), "--output " + folder_.string() + ": "},
      {"sweep " + truss + " --alpha 10,20 --certificate " + quoted(in_folder("proofs")) +
           " --csv " + quoted(in_folder("proofs/10.cert")),
       "is in the folder of --certificate, whose files end in .cert; expected another name"},
      {good + " --serial=false", "--serial takes no value"},
      {good + " --node-limit 0", "--node-limit: '0', expected a whole number above 0"},
      {good + " --node-limit 1.5", "--node-limit: '1.5', expected a whole number above 0"},
      {good + " --node-limit 99999999999999999999",
       "--node-limit: '99999999999999999999', expected"},
      {good + " --method simplex", "--method: 'simplex', expected one of cones, polyhedral"},
      {good + " --facets 8", "--facets requires --method polyhedral"},
      {good + " --candidates --method cones", "--candidates requires --method polyhedral"},
      {good + " --order sideways", "expected one of depth-first, breadth-first"},
      {good + " --facets 8 --method cones", "--facets requires --method polyhedral"},
      {good + " --probe 4 --method polyhedral", "--probe: requires --method cones"},
      {good + " --method polyhedral --facets 7",
       "--facets: '7', expected an even number from 4 to 64"},
      {"patterns " + plane + " --mu 0.5 --method polyhedral", "expected --method cones"},
      {good + " --time-limit -1", "--time-limit: '-1', " + above_0},
      {good + " --resume /nowhere/at/all", "--resume /nowhere/at/all: cannot be opened"},
      {good + " --resume " + truss,
       "--resume " + truss_file + ": would overwrite the problem file"},
      {"critical " + truss + " --method newton", "--mu-max is missing; expected"},
      {"critical " + truss + " --mu-max 0", "--mu-max: '0', " + above_0},
      {"critical " + truss + " --width 0", "--width: '0', " + above_0},
      {"critical " + truss + " --width 1e-20", "--width 1e-20: expected a number below --mu-max"},
      {"critical " + truss + " --method guess",
       "--method: 'guess', expected one of auto, descent, global, newton, bisection"},
      {"rays " + plane + " --mu 1 --method double-description --node-limit 9", "expected no limit"},
      {"rays " + truss + " --mu 1", "dimension is 3; expected 2"},
      {"limit " + truss + " --group-alpha wind", "--group-alpha: 'wind', expected NAME=NUMBER"},
      {"limit " + truss + " --group-alpha wind=-1", "with numbers that are not negative"},
      {"limit " + truss + " --alpha 1 --cuts some",
       "--cuts: 'some', expected one of none, disjunctive, tighten, static, all"},
      {"limit " + truss + " --alpha 1 --samples 0",
       "--samples: '0', expected a whole number from 1 to 100000000"},
      {"mip none.lp --gap 0", "--gap: '0', " + above_0},
      {"verify", "certificate is required"},
      {"verify none.cert", "none.cert: the file cannot be read; expected a certificate"},
      {"example grid", "--bays is required"},
      {"example grid --bays two", "--bays: 'two', expected a whole number above 0"},
      {"bench uts --tree T9", "--tree: 'T9', expected one of T1-4, "},
  };
  for (const auto& [call, message] : wrong) {
    const auto run = shell(command + " " + call);
    EXPECT_EQ(run.exit_code, 2) << call;
    EXPECT_THAT(run.output, HasSubstr(message)) << call;
    EXPECT_EQ(std::count(run.output.begin(), run.output.end(), '\n'), 1) << run.output;
  }
}

TEST_F(Command, AcceptsLettersForFrequentOptions) {
  const auto short_call =
      shell(command + " patterns " + truss + " --mu 0.65 -q -o " + argument("short.json"));
  EXPECT_EQ(short_call.exit_code, 0);
  EXPECT_EQ(short_call.output, "");
  shell(command + " patterns " + truss + " --mu 0.65 --quiet --output " + argument("long.json"));
  EXPECT_EQ(nlohmann::json::parse(content(in_folder("short.json")))["result"],
            nlohmann::json::parse(content(in_folder("long.json")))["result"]);
  EXPECT_THAT(shell(command + " patterns " + truss + " --mu 0.65 -o").output,
              HasSubstr("--output has no value"));
  EXPECT_THAT(shell(command + " patterns --help").output, HasSubstr("  -o, --output FILE"));
}

TEST_F(Command, PrintsHelpAndItsVersion) {
  const auto help = shell(command + " patterns --help");
  EXPECT_EQ(help.exit_code, 0);
  EXPECT_THAT(help.output, HasSubstr("--mu"));
  EXPECT_EQ(shell(command + " --help").exit_code, 0);
  EXPECT_THAT(shell(command + " --version").output, HasSubstr("kusabi "));
  // The manual has the text of the help.
  const auto manual = shell(command + " --manual");
  EXPECT_EQ(manual.exit_code, 0);
  EXPECT_TRUE(manual.output.starts_with(".TH KUSABI 1")) << manual.output;
  EXPECT_THAT(shell(command + " --manual patterns").output,
              HasSubstr("\\fB\\-\\-checkpoint\\-interval\\fR"));
}

TEST_F(Command, NeverCallsMpiIfSerial) {
  // Under a launcher, with Open MPI set to use a component that does not exist: a call of
  // MPI_Init fails.
  const auto call = "env OMPI_COMM_WORLD_SIZE=1 OMPI_MCA_pml=none_such timeout 60 " + command +
                    " patterns " + truss + " --mu 0.55";
#ifndef OPEN_MPI
  GTEST_SKIP() << "it is not built with Open MPI";
#endif
  EXPECT_NE(shell(call).exit_code, 0);
  const auto run = shell(call + " --serial");
  EXPECT_EQ(run.exit_code, 0) << run.output;
  EXPECT_THAT(run.output, HasSubstr("1 sign pattern "));
}

TEST_F(Command, RefusesASerialSearchUnderMpirun) {
  const auto run = shell("env OMPI_COMM_WORLD_SIZE=2 OMPI_MCA_pml=none_such timeout 60 " + command +
                         " patterns " + truss + " --mu 0.55 --serial");
  EXPECT_EQ(run.exit_code, 2) << run.output;
  EXPECT_THAT(run.output, HasSubstr("--serial: kusabi was started by mpirun"));
}

}  // namespace
}  // namespace kusabi::test
