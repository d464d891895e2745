// The command `kusabi`: reads the call, hands over to a subcommand, and turns whatever goes wrong
// into one line and an exit code.
#include <cmath>
#include <cstdio>
#include <exception>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "engine/together.hpp"
#include "nodes/benchmark/standard_trees.hpp"
#include "nodes/wedged/facets.hpp"
#include "run/bench/bench_scaling.hpp"
#include "run/bench/bench_schedules.hpp"
#include "run/bench/bench_uts.hpp"
#include "run/critical/critical.hpp"
#include "run/example/example.hpp"
#include "run/limit/limit.hpp"
#include "run/mip/mip.hpp"
#include "run/output/exit_code.hpp"
#include "run/output/standard_output.hpp"
#include "run/patterns/patterns.hpp"
#include "run/rays/rays.hpp"
#include "run/session/session.hpp"
#include "run/verify/verify.hpp"
#include "support/input_error.hpp"

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

// The same, or zero.
const CLI::Validator not_negative(
    [](std::string& text) -> std::string {
      double value = 0;
      if (CLI::detail::lexical_cast(text, value) && std::isfinite(value) && value >= 0) return {};
      return "'" + text + "', expected a number of 0 or more";
    },
    ">= 0");

// From where on a margin counts as one: doubles have no more digits in theirs, and above nothing
// would be left to find.
const CLI::Validator sensible_tolerance(
    [](std::string& text) -> std::string {
      constexpr double least = 1e-12;
      constexpr double most = 1e-3;
      double value = 0;
      if (CLI::detail::lexical_cast(text, value) && value >= least && value <= most) return {};
      return fmt::format("'{}', expected a number from {:g} to {:g}", text, least, most);
    },
    "1e-12 - 1e-3");

// How many facets a polyhedral friction cone may have.
const CLI::Validator facet_count(
    [](std::string& text) -> std::string {
      using kusabi::wedged::FacetBound;
      int value = 0;
      if (CLI::detail::lexical_cast(text, value) && value % 2 == 0 && value >= FacetBound::fewest &&
          value <= FacetBound::most)
        return {};
      return fmt::format("'{}', expected an even number from {} to {}", text, FacetBound::fewest,
                         FacetBound::most);
    },
    "EVEN");

int complain(Session& session, const std::string& message) {
  if (session.speaks()) {
    std::fflush(stdout);
    tell("{}\n", message);
  }
  return wrong_input;
}

// What the call asks for, when all of it has been read. @return the exit code
using Action = std::function<int(Session&)>;

void add_serial(CLI::App& command, bool& serial) {
  command.add_flag("--serial", serial, "run in this process alone, without MPI")
      ->disable_flag_override();
}

void add_patterns(CLI::App& app, Action& action, bool& serial) {
  auto& command = *app.add_subcommand(
      "patterns",
      "every sign pattern of wedged configurations (contact or separated, node by node)");
  const auto options = std::make_shared<PatternsOptions>();
  command.add_option("file", options->file, "the problem, a TOML file")->required();
  command.add_option("--mu", options->friction, "friction coefficient")
      ->required()
      ->check(positive);
  command
      .add_option("--tolerance", options->tolerance,
                  "a margin t* up to this size is a tie, neither positive nor negative")
      ->check(sensible_tolerance)
      ->capture_default_str();
  command
      .add_option_function<std::string>(
          "--branching",
          [options](const std::string& rule) {
            using kusabi::wedged::Branching;
            options->branching = rule == "paper" ? Branching::product : Branching::relative;
          },
          "split nodes by the largest u_n r_n as the paper does, or by its size relative to the "
          "candidate's compliance: the same patterns from fewer nodes")
      ->check(CLI::IsMember({"paper", "relative"}))
      ->default_str("relative");
  const auto method = std::make_shared<std::string>("cones");
  command
      .add_option("--method", *method,
                  "bound nodes with the friction cones themselves, or with polyhedral ones around "
                  "them, and put each pattern that these let live to the test of the cones")
      ->check(CLI::IsMember({"cones", "polyhedral"}))
      ->capture_default_str();
  const auto facets = std::make_shared<int>(16);
  const auto* const facets_option =
      command.add_option("--facets", *facets, "of each polyhedral cone")
          ->check(facet_count)
          ->capture_default_str();
  command.add_option("--output", options->output, "write the result to this JSON file");
  command.add_option("--time-limit", options->limits.seconds, "stop after so many seconds")
      ->check(positive);
  command
      .add_option("--node-limit", options->limits.nodes, "stop when so many nodes have been opened")
      ->check(CLI::PositiveNumber);
  command.add_option("--pattern-limit", options->limits.solutions, "stop at so many patterns")
      ->check(CLI::PositiveNumber);
  command.add_option("--checkpoint", options->checkpoint,
                     "keep the state of the search in this file and others beside it");
  command
      .add_option("--checkpoint-interval", options->checkpoint_interval,
                  "seconds between two checkpoints")
      ->check(positive)
      ->capture_default_str();
  command.add_option("--restart", options->restart,
                     "go on from this checkpoint, on any number of ranks");
  command.add_option("--trace", options->trace,
                     "write what each rank did when to this file, for ui.perfetto.dev");
  command.add_option("--certificate", options->certificate,
                     "write the evidence to this file, for kusabi verify");
  command.add_flag("--quiet", options->quiet, "print errors only");
  add_serial(command, serial);
  command.callback([&action, options, method, facets, facets_option] {
    if (*method == "polyhedral")
      options->facets = *facets;
    else if (facets_option->count() != 0)
      throw CLI::RequiresError("--facets", "--method polyhedral");
    action = [options](Session& s) { return patterns(s, *options); };
  });
}

void add_rays(CLI::App& app, Action& action, bool& serial) {
  auto& command = *app.add_subcommand(
      "rays", "every extremal ray of wedged configurations in the plane, and every maximal cone");
  const auto options = std::make_shared<RaysOptions>();
  command.add_option("file", options->file, "the problem, a TOML file")->required();
  command.add_option("--mu", options->friction, "friction coefficient")
      ->required()
      ->check(positive);
  const std::map<std::string, RayMethod> methods{
      {"auto", RayMethod::automatic},
      {"double-description", RayMethod::double_description},
      {"tree", RayMethod::tree}};
  command
      .add_option_function<std::string>(
          "--method", [options, methods](const auto& name) { options->method = methods.at(name); },
          "Algorithm 4.2 on one rank, pattern by pattern on all ranks, or whichever suits the "
          "size; "
          "both give the same rays")
      ->check(CLI::IsMember(methods))
      ->default_str("auto");
  command.add_option("--output", options->output, "write the result to this JSON file");
  command.add_option("--csv", options->csv, "write the rays to this file, a line each");
  command.add_option("--dot", options->dot,
                     "write the cross-complementarity graph to this file, for Graphviz");
  command.add_option("--time-limit", options->limits.seconds, "stop after so many seconds")
      ->check(positive);
  command
      .add_option("--node-limit", options->limits.nodes, "stop when so many nodes have been opened")
      ->check(CLI::PositiveNumber);
  command.add_flag("--quiet", options->quiet, "print errors only");
  add_serial(command, serial);
  command.callback(
      [&action, options] { action = [options](Session& s) { return rays(s, *options); }; });
}

void add_critical(CLI::App& app, Action& action, bool& serial) {
  auto& command = *app.add_subcommand(
      "critical", "the smallest friction coefficient at which anything can wedge, proved");
  const auto options = std::make_shared<CriticalOptions>();
  command.add_option("file", options->file, "the problem, a TOML file")->required();
  const std::map<std::string, CriticalWay> ways{{"global", CriticalWay::global},
                                                {"newton", CriticalWay::newton},
                                                {"bisection", CriticalWay::bisection}};
  command
      .add_option_function<std::string>(
          "--method", [options, ways](const std::string& way) { options->way = ways.at(way); },
          "one search for the smallest, or the coefficients of all patterns that live at --mu-max")
      ->check(CLI::IsMember(ways))
      ->default_str("global");
  command.add_option("--mu-max", options->most, "no larger coefficient is of interest")
      ->check(positive);
  command.add_option("--width", options->width, "of the brackets")
      ->check(positive)
      ->capture_default_str();
  command.add_option("--output", options->output, "write the result to this JSON file");
  command.add_option(
      "--certificate", options->certificate,
      "write the evidence of both ends to NAME.lower and NAME.upper, for kusabi verify");
  command.add_option("--time-limit", options->limits.seconds, "stop after so many seconds")
      ->check(positive);
  command
      .add_option("--node-limit", options->limits.nodes, "stop when so many nodes have been opened")
      ->check(CLI::PositiveNumber);
  command.add_flag("--quiet", options->quiet, "print errors only");
  add_serial(command, serial);
  command.callback(
      [&action, options] { action = [options](Session& s) { return critical(s, *options); }; });
}

void add_limit(CLI::App& app, Action& action, bool& serial) {
  auto& command = *app.add_subcommand(
      "limit",
      "the load factor at which a truss collapses, and its worst case under loads that "
      "are not known exactly");
  const auto options = std::make_shared<LimitOptions>();
  command.add_option("file", options->file, "the problem, a TOML file")->required();
  auto* const alpha =
      command
          .add_option("--alpha", options->alpha,
                      "the uncertain components of the dead load are known up to +- this")
          ->check(not_negative);
  auto* const cuts =
      command
          .add_option(
              "--cuts", options->method,
              "how the worst case is found: by static cuts, or by the 0-1 program (29) with "
              "none, disjunctive ones (the paper's method), a tightened M, or all of these")
          ->transform(CLI::Transformer(
              std::map<std::string, LimitMethod>{{"none", LimitMethod::fixed},
                                                 {"disjunctive", LimitMethod::disjunctive},
                                                 {"tighten", LimitMethod::tightened},
                                                 {"static", LimitMethod::static_cuts},
                                                 {"all", LimitMethod::all}}))
          ->needs(alpha);
  command
      .add_option("--big-m", options->big_m,
                  "M of (29), where motions have f_R'u = 1 in the unit of force; 5 in the paper. "
                  "Without it a safe one is derived")
      ->needs(cuts)
      ->check(positive);
  command.add_option("--samples", options->samples, "compare with so many random dead loads")
      ->needs(alpha)
      ->check(CLI::Range(1U, 100'000'000U));
  command.add_option("--seed", options->seed, "of the random dead loads")->capture_default_str();
  command
      .add_flag("--curve", options->curve,
                "how the load factor falls as the critical load, or alpha, grows from zero")
      ->needs(alpha);
  command
      .add_option("--time-limit", options->limits.seconds,
                  "stop the search of a tree after so many seconds")
      ->check(positive);
  command
      .add_option("--node-limit", options->limits.nodes, "stop when so many nodes have been opened")
      ->check(CLI::PositiveNumber);
  command.add_option("--output", options->output, "write the result to this JSON file");
  command
      .add_option("--certificate", options->certificate,
                  "write the evidence to this file, for kusabi verify")
      ->needs(alpha);
  command.add_flag("--quiet", options->quiet, "print errors only");
  add_serial(command, serial);
  command.callback(
      [&action, options] { action = [options](Session& s) { return limit(s, *options); }; });
}

void add_mip(CLI::App& app, Action& action, bool& serial) {
  using kusabi::engine::Order;
  using kusabi::zero_one::ZeroOneBranching;
  using kusabi::zero_one::ZeroOneCuts;
  auto& command =
      *app.add_subcommand("mip", "the optimum of a mixed zero-one linear program, with its bound");
  const auto options = std::make_shared<MipOptions>();
  command.add_option("file", options->file, "the program, in MPS (.mps) or CPLEX LP (.lp) format")
      ->required();
  const auto choice = [&](const char* name, auto& value, const auto& names, const char* what) {
    command.add_option(name, value, what)->transform(CLI::Transformer(names));
  };
  choice("--cuts", options->cuts,
         std::map<std::string, ZeroOneCuts>{{"none", ZeroOneCuts::none},
                                            {"disjunctive", ZeroOneCuts::disjunctive}},
         "cuts at the root (default none)");
  choice("--branching", options->branching,
         std::map<std::string, ZeroOneBranching>{{"paper", ZeroOneBranching::paper},
                                                 {"look-ahead", ZeroOneBranching::look_ahead}},
         "split nodes by the largest tau (1 - tau) as the paper does (default), or by what the "
         "children's bounds gain: the same optimum from fewer nodes that cost more");
  choice("--order", options->order,
         std::map<std::string, Order>{{"depth-first", Order::depth_first},
                                      {"best-first", Order::best_first},
                                      {"hybrid", Order::hybrid}},
         "which node is opened next (default depth-first): the same optimum");
  command.add_flag("!--no-tighten", options->tighten, "leave big Ms as they are");
  command.add_flag("!--no-dive", options->dive, "do not look for points before the search");
  command.add_option("--output", options->output, "write the result to this JSON file");
  command.add_option("--time-limit", options->limits.seconds, "stop after so many seconds")
      ->check(positive);
  command
      .add_option("--node-limit", options->limits.nodes, "stop when so many nodes have been opened")
      ->check(CLI::PositiveNumber);
  command
      .add_option("--gap", options->limits.gap,
                  "stop when objective and bound differ by so much, relative to the objective")
      ->check(positive);
  command.add_option("--checkpoint", options->checkpoint,
                     "keep the state of the search in this file and others beside it");
  command
      .add_option("--checkpoint-interval", options->checkpoint_interval,
                  "seconds between two checkpoints")
      ->check(positive)
      ->capture_default_str();
  command.add_option("--restart", options->restart,
                     "go on from this checkpoint, on any number of ranks");
  command.add_flag("--quiet", options->quiet, "print errors only");
  add_serial(command, serial);
  command.callback(
      [&action, options] { action = [options](Session& s) { return mip(s, *options); }; });
}

void add_verify(CLI::App& app, Action& action, bool& serial) {
  auto& command = *app.add_subcommand(
      "verify",
      "proves a list of patterns, or a worst-case load factor, from its certificate, exactly");
  const auto options = std::make_shared<VerifyOptions>();
  command
      .add_option("certificate", options->certificate,
                  "what patterns or limit --certificate has written")
      ->required();
  command.add_option("--problem", options->problem,
                     "prove it of the structure in this problem file, whose stiffness is computed "
                     "anew with bounds for every rounding; without it, of the numbers in the "
                     "certificate");
  command.add_flag("--quiet", options->quiet, "print errors and what is refused only");
  add_serial(command, serial);
  command.callback(
      [&action, options] { action = [options](Session& s) { return verify(s, *options); }; });
}

void add_grid(CLI::App& example, Action& action) {
  auto& grid = *example.add_subcommand(
      "grid", "a plane grid truss, braced crosswise, with loads for limit analysis");
  const auto options = std::make_shared<ExampleGridOptions>();
  grid.add_option("--bays", options->bays, "bays along each axis")->required();
  grid.add_option("--output", options->output, "write to this file instead of standard output");
  grid.callback(
      [&action, options] { action = [options](Session& s) { return example_grid(s, *options); }; });
}

void add_space_truss(CLI::App& example, Action& action) {
  auto& truss = *example.add_subcommand(
      "space-truss", "a space truss against an inclined wall; the candidates are rows x depth");
  const auto options = std::make_shared<ExampleSpaceTrussOptions>();
  const auto count = [&](const char* name, int& value, const char* what) {
    truss.add_option(name, value, what)->check(CLI::PositiveNumber)->capture_default_str();
  };
  count("--rows", options->size.rows, "rows of nodes along y");
  count("--depth", options->size.depth, "planes of nodes along z");
  count("--bays", options->size.bays, "bays between the wall and the obstacle");
  truss.add_option("--output", options->output, "write to this file instead of standard output");
  truss.callback([&action, options] {
    action = [options](Session& s) { return example_space_truss(s, *options); };
  });
}

void add_plane_truss(CLI::App& example, Action& action) {
  using kusabi::problems::Verticals;
  auto& truss = *example.add_subcommand(
      "plane-truss", "a plane truss against an inclined wall; the candidates are the rows");
  const auto options = std::make_shared<ExamplePlaneTrussOptions>();
  auto& size = options->size;
  truss.add_option("--rows", size.rows, "rows of nodes along y, 1 m apart")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  truss.add_option("--bays", size.bays, "bays between the wall and the obstacle")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  truss.add_option("--width", size.width, "of the lowest row, m")
      ->check(positive)
      ->capture_default_str();
  truss.add_option("--lean", size.lean, "of the obstacle, degrees from the vertical")
      ->check(CLI::NonNegativeNumber)
      ->capture_default_str();
  const std::map<std::string, Verticals> braces{
      {"none", Verticals::none}, {"inner", Verticals::inner}, {"all", Verticals::all}};
  truss
      .add_option_function<std::string>(
          "--brace",
          [options, braces](const auto& name) { options->size.verticals = braces.at(name); },
          "bars from row to row besides the diagonals: none, in the inner columns, or on the "
          "obstacle, too")
      ->check(CLI::IsMember(braces))
      ->default_str("inner");
  truss.add_option("--output", options->output, "write to this file instead of standard output");
  truss.callback([&action, options] {
    action = [options](Session& s) { return example_plane_truss(s, *options); };
  });
}

void add_scaling(CLI::App& bench, Action& action) {
  auto& command = *bench.add_subcommand(
      "scaling", "how far the search scales, by simulation of up to 65536 ranks in virtual time");
  const auto options = std::make_shared<BenchScalingOptions>();
  const auto number = [&](const char* name, auto& value, const char* what) {
    command.add_option(name, value, what)->check(positive)->capture_default_str();
  };
  number("--nodes", options->nodes, "of the tree");
  number("--node-us", options->node_microseconds, "microseconds to open a node");
  number("--latency-us", options->latency_microseconds, "microseconds that a message travels");
  number("--handling-us", options->handling_microseconds,
         "microseconds that a message costs its sender, and its receiver");
  number("--bandwidth", options->gigabytes_a_second, "gigabytes a second");
  number("--least-ranks", options->least_ranks, "the first row");
  number("--most-ranks", options->most_ranks, "where to stop; each row has four times as many");
  number("--seed", options->seed, "of the tree and of the schedule");
  command.callback([&action, options] {
    action = [options](Session& s) { return bench_scaling(s, *options); };
  });
}

void add_schedules(CLI::App& bench, Action& action) {
  auto& command = *bench.add_subcommand(
      "schedules",
      "simulates searches under random schedules: does each find what one rank finds?");
  const auto options = std::make_shared<BenchSchedulesOptions>();
  command.add_option("--seeds", options->seeds, "how many schedules")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  command.add_option("--first-seed", options->first_seed, "of the first schedule")
      ->capture_default_str();
  command.callback([&action, options] {
    action = [options](Session& s) { return bench_schedules(s, *options); };
  });
}

void add_uts(CLI::App& bench, Action& action, bool& serial) {
  auto& command = *bench.add_subcommand(
      "uts", "the Unbalanced Tree Search benchmark: are the published counts found, how fast");
  const auto options = std::make_shared<BenchUtsOptions>();
  std::vector<std::string> names;
  for (const auto& tree : kusabi::benchmark::standard_trees()) names.emplace_back(tree.name);
  command.add_option("--tree", options->tree, "a standard tree")
      ->check(CLI::IsMember(names))
      ->capture_default_str();
  constexpr unsigned about_a_second = 10'000'000;
  command.add_option("--work", options->work, "hashes a node, some 0.1 microseconds each")
      ->check(CLI::Range(1U, about_a_second))
      ->capture_default_str();
  command.add_option("--rounds", options->rounds, "searches, of which the fastest counts")
      ->check(CLI::Range(1U, 1000U))
      ->capture_default_str();
  add_serial(command, serial);
  command.callback(
      [&action, options] { action = [options](Session& s) { return bench_uts(s, *options); }; });
}

int run(Session& session, int argc, char** argv) {
  CLI::App app{
      "All wedged configurations of a structure with Coulomb friction, worst-case limit loads of "
      "trusses, and the 0-1 programs that they are.",
      "kusabi"};
  app.set_version_flag("--version", "kusabi " KUSABI_VERSION);
  app.require_subcommand(1);
  Action action;
  bool serial = false;
  add_patterns(app, action, serial);
  add_rays(app, action, serial);
  add_critical(app, action, serial);
  add_limit(app, action, serial);
  add_mip(app, action, serial);
  add_verify(app, action, serial);
  auto& example = *app.add_subcommand("example", "writes a problem file of a family of structures");
  example.require_subcommand(1);
  add_space_truss(example, action);
  add_plane_truss(example, action);
  add_grid(example, action);
  auto& bench = *app.add_subcommand("bench", "measures and tries the search engine");
  bench.require_subcommand(1);
  add_scaling(bench, action);
  add_schedules(bench, action);
  add_uts(bench, action, serial);

  try {
    app.parse(argc, argv);
  } catch (const CLI::CallForHelp&) {
    if (session.speaks()) print_answer(app.help());
    return solved;
  } catch (const CLI::CallForAllHelp&) {
    if (session.speaks()) print_answer(app.help("", CLI::AppFormatMode::All));
    return solved;
  } catch (const CLI::CallForVersion& version) {
    if (session.speaks()) print_answer(fmt::format("{}\n", version.what()));
    return solved;
  } catch (const CLI::ParseError& error) {
    return complain(session, fmt::format("kusabi: {} (try --help)", error.what()));
  }

  if (const auto fault = session.fault_of_launch(serial)) {
    if (!fault->empty()) complain(session, "kusabi: " + *fault);
    return wrong_input;
  }
  return action(session);
}

}  // namespace

int main(int argc, char** argv) {
  secure_standard_streams();  // before MPI and anything else opens a file
  Session session(argc, argv);
  try {
    return run(session, argc, argv);
  } catch (const WrongInput& error) {
    return complain(session, error.what());
  } catch (const kusabi::support::InputError& error) {
    return complain(session, error.what());
  } catch (const kusabi::engine::Disagreement& error) {
    if (session.speaks()) tell("kusabi: {}\n", error.what());
    return failed;
  } catch (const std::exception& error) {
    session.transport().abandon(error.what());
    tell("kusabi: {}\n", error.what());
    return failed;
  }
}
