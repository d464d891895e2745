// The command `kusabi`: reads the call, hands over to a subcommand, and turns whatever goes wrong
// into one line and an exit code.
#include <cmath>
#include <cstdio>
#include <exception>
#include <string>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "problems/input_error.hpp"
#include "run/exit_code.hpp"
#include "run/patterns.hpp"
#include "run/session.hpp"

namespace {

using namespace kusabi::run;

// A number that is positive and finite; CLI11's own check lets infinity pass.
const CLI::Validator positive(
    [](std::string& text) -> std::string {
      double value = 0;
      if (CLI::detail::lexical_cast(text, value) && std::isfinite(value) && value > 0) return {};
      return "'" + text + "', expected a number above 0";
    },
    "> 0");

int complain(Session& session, const std::string& message) {
  if (session.speaks()) {
    std::fflush(stdout);
    fmt::print(stderr, "{}\n", message);
  }
  return wrong_input;
}

int run(Session& session, int argc, char** argv) {
  CLI::App app{"All wedged configurations of a structure with Coulomb friction.", "kusabi"};
  app.set_version_flag("--version", "kusabi " KUSABI_VERSION);
  app.require_subcommand(1);

  PatternsOptions options;
  auto* patterns_command = app.add_subcommand(
      "patterns",
      "every sign pattern of wedged configurations (contact or separated, node by node)");
  bool serial = false;
  patterns_command->add_option("file", options.file, "the problem, a TOML file")->required();
  patterns_command->add_option("--mu", options.friction, "friction coefficient")
      ->required()
      ->check(positive);
  patterns_command
      ->add_option("--tolerance", options.tolerance,
                   "a margin t* up to this size is neither positive nor negative")
      ->check(positive)
      ->capture_default_str();
  patterns_command->add_option("--output", options.output, "write the result to this JSON file");
  patterns_command->add_option("--time-limit", options.limits.seconds, "stop after so many seconds")
      ->check(positive);
  patterns_command
      ->add_option("--node-limit", options.limits.nodes, "stop when so many nodes have been opened")
      ->check(CLI::PositiveNumber);
  patterns_command
      ->add_option("--pattern-limit", options.limits.solutions, "stop at so many patterns")
      ->check(CLI::PositiveNumber);
  patterns_command->add_option("--checkpoint", options.checkpoint,
                               "keep the state of the search in this file and others beside it");
  patterns_command
      ->add_option("--checkpoint-interval", options.checkpoint_interval,
                   "seconds between two checkpoints")
      ->check(positive)
      ->capture_default_str();
  patterns_command->add_option("--restart", options.restart,
                               "go on from this checkpoint, on any number of ranks");
  patterns_command->add_option("--trace", options.trace,
                               "write what each rank did when to this file, for ui.perfetto.dev");
  patterns_command->add_flag("--quiet", options.quiet, "print errors only");
  patterns_command->add_flag("--serial", serial, "run in this process alone, without MPI")
      ->disable_flag_override();

  try {
    app.parse(argc, argv);
  } catch (const CLI::CallForHelp&) {
    if (session.speaks()) fmt::print("{}", app.help());
    return solved;
  } catch (const CLI::CallForAllHelp&) {
    if (session.speaks()) fmt::print("{}", app.help("", CLI::AppFormatMode::All));
    return solved;
  } catch (const CLI::CallForVersion& version) {
    if (session.speaks()) fmt::print("{}\n", version.what());
    return solved;
  } catch (const CLI::ParseError& error) {
    return complain(session, fmt::format("kusabi: {} (try --help)", error.what()));
  }

  if (serial && Session::serial_among_many()) {
    return complain(session,
                    "kusabi: --serial under mpirun: every process would do the whole search");
  }
  return patterns(session, options);
}

}  // namespace

int main(int argc, char** argv) {
  Session session(argc, argv);
  try {
    return run(session, argc, argv);
  } catch (const WrongInput& error) {
    return complain(session, error.what());
  } catch (const kusabi::problems::InputError& error) {
    return complain(session, error.what());
  } catch (const std::exception& error) {
    session.transport().abandon(error.what());
    fmt::print(stderr, "kusabi: {}\n", error.what());
    return failed;
  }
}
