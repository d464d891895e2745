// Searches of patterns that are stopped by limits and signals, and resumed from their states.
#include <filesystem>
#include <string>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "shell.hpp"

namespace kusabi::test {
namespace {

using testing::HasSubstr;

using PatternsResume = Command;

// The printed call has all options and the number of ranks, including names that a shell would
// split and options that change the tree.
TEST_F(PatternsResume, PrintsTheCallThatResumes) {
  fs::copy(truss_file, in_folder("a truss.toml"));
  const std::string call = fmt::format(
      " patterns {} --mu 1 --branching paper --tolerance 1e-9 --certificate {} --output {}",
      argument("a truss.toml"), argument("c.cert"), argument("all.json"));
  ASSERT_EQ(shell(command + call + " --quiet").exit_code, 0);
  const auto whole = without_statistics(in_folder("all.json"));
  const auto certificate = content(in_folder("c.cert"));
  fs::remove(in_folder("c.cert"));
  const auto stopped =
      shell(ranks(2) + command + call + " --node-limit 12 --resume " + argument("it's a state"));
  EXPECT_EQ(stopped.exit_code, 3);
  const auto on = call_to_go_on(stopped.output);
  EXPECT_TRUE(on.starts_with("mpirun -np 2 kusabi patterns ")) << on;
  EXPECT_THAT(on, testing::Not(HasSubstr("--node-limit")));
  const auto gone_on = shell(as_typed(on));
  ASSERT_EQ(gone_on.exit_code, 0) << gone_on.output;
  EXPECT_EQ(without_statistics(in_folder("all.json")), whole);
  EXPECT_EQ(fs::file_size(in_folder("c.cert")), certificate.size());
}

TEST_F(PatternsResume, ContinuesAfterALimit) {
  const std::string call = command + " patterns " + truss + " --mu 1.0 --output ";
  const auto whole = in_folder("whole.json");
  ASSERT_EQ(shell(call + quoted(whole)).exit_code, 0);

  const auto part = in_folder("part.json");
  const auto stopped =
      shell(ranks(2) + call + quoted(part) + " --node-limit 300 --resume " + argument("state"));
  EXPECT_EQ(stopped.exit_code, 3) << stopped.output;
  EXPECT_THAT(stopped.output, HasSubstr("Stopped early (node-limit)"));
  EXPECT_THAT(stopped.output, HasSubstr("--resume"));
  const auto json = nlohmann::json::parse(content(part));
  EXPECT_EQ(json["status"], "node-limit");
  EXPECT_GT(json["result"]["tree"]["open"], 0);
  EXPECT_LT(json["result"]["count"], 251);

  // It is the state of another tree.
  const auto other =
      shell(command + " patterns " + truss + " --mu 0.9 --resume " + argument("state"));
  EXPECT_EQ(other.exit_code, 2);
  EXPECT_THAT(other.output, HasSubstr("was started with --mu 1"));

  const auto rest = in_folder("rest.json");
  const auto resumed = shell(ranks(3) + call + quoted(rest) + " --resume " + argument("state"));
  EXPECT_EQ(resumed.exit_code, 0) << resumed.output;
  EXPECT_EQ(without_statistics(rest), without_statistics(whole));
}

// The shell's condition that no search has saved a state yet. A state is complete with its
// manifest, such as state.search3; its parts, such as state.search3.1.0, are written before.
std::string nothing_saved(const std::string& state) {
  return fmt::format("! ls {}* 2>/dev/null | grep -q 'search[0-9]*$'", quoted(state + ".search"));
}

// A search of a second or more.
constexpr auto make_long = " example space-truss --rows 15 --depth 2 --output ";
constexpr auto long_friction = " --mu 0.52 ";

TEST_F(PatternsResume, ContinuesAfterASignal) {
  shell(command + make_long + argument("long.toml"));
  const auto call = command + " patterns " + argument("long.toml") + " --cuts none" + long_friction;
  const auto whole = in_folder("whole.json");
  ASSERT_EQ(shell(ranks(2) + call + " --quiet --output " + quoted(whole)).exit_code, 0);
  for (const std::string signal : {"TERM", "INT"}) {
    const auto state = in_folder(signal);
    // From its first checkpoint on the command handles signals.
    const auto stopped = shell(
        fmt::format("{{ {} --resume {} --checkpoint-interval 0.02 >{} & p=$!;"
                    "   while {} && kill -0 $p; do sleep 0.01; done; kill -{} $p; wait $p; }}",
                    call, quoted(state), argument("table"), nothing_saved(state), signal));
    EXPECT_EQ(stopped.exit_code, 3) << stopped.output;
    EXPECT_THAT(stopped.output, HasSubstr("Stopped early (interrupted)"));
    const auto file = in_folder(signal + ".json");
    const auto resumed = shell(fmt::format("{} {} --quiet --resume {} --output {}", ranks(2), call,
                                           quoted(state), quoted(file)));
    EXPECT_EQ(resumed.exit_code, 0) << resumed.output;
    EXPECT_EQ(without_statistics(file), without_statistics(whole));
  }
}

TEST_F(PatternsResume, WritesACheckpointWithoutStoppingAtSIGUSR1) {
  shell(command + " example space-truss --rows 10 --depth 4 --output " + argument("long.toml"));
  const auto state = in_folder("state");
  // The command handles signals from shortly after its first line of output on.
  const auto run = shell(fmt::format(
      "{{ {} patterns {} --mu 0.55 --cuts none --resume {} >{} 2>{} & p=$!;"
      "   while [ ! -s {} ] && kill -0 $p; do sleep 0.01; done; sleep 0.2; kill -USR1 $p;"
      "   while {} && kill -0 $p; do sleep 0.01; done; kill -TERM $p; wait $p; }}",
      command, argument("long.toml"), quoted(state), argument("table"), argument("log"),
      argument("log"), nothing_saved(state)));
  EXPECT_EQ(run.exit_code, 3) << content(in_folder("log"));
  // The first checkpoint is due to SIGUSR1, the second one to the end: the search continued.
  for (const auto* const ending : {".previous", ".1.0", ".2.0"})
    EXPECT_THAT(files(), testing::Contains(testing::EndsWith(ending)));
}

TEST_F(PatternsResume, KeepsTheCertificateOfAKilledSearch) {
  shell(command + make_long + argument("long.toml"));
  const auto call = command + " patterns " + argument("long.toml") + " --cuts none" +
                    long_friction + " --certificate " + argument("cert");
  const auto state = argument("state");
  shell(
      fmt::format("{{ {} --resume {} --checkpoint-interval 0.02 >{} 2>&1 & p=$!;"
                  "   while {} && kill -0 $p; do sleep 0.01; done; sleep 0.05;"
                  "   kill -KILL $p; wait $p; }}",
                  call, state, argument("log"), nothing_saved(in_folder("state"))));
  const auto resumed = shell(ranks(2) + call + " --quiet --resume " + state);
  ASSERT_EQ(resumed.exit_code, 0) << resumed.output;
  const auto run = shell(ranks(2) + command + " verify " + argument("cert"));
  EXPECT_EQ(run.exit_code, 0) << run.output;
  EXPECT_THAT(run.output, HasSubstr("cover all 2^30 sign patterns, each once"));
}

}  // namespace
}  // namespace kusabi::test
