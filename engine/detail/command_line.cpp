// Options of the command line of a search program, by CLI11.
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "engine/detail/program.hpp"

namespace kusabi::engine {
namespace {

// An option whose values have names.
template <class Value>
void add_choice(CLI::App& app, const std::string& name, const std::map<std::string, Value>& values,
                Value& chosen, const std::string& purpose) {
  app.add_option_function<std::string>(
         name, [values, &chosen](const std::string& word) { chosen = values.at(word); }, purpose)
      ->check(CLI::IsMember(values));
}

// Solutions beside the best one. A gap alone has no limit of their number.
void describe_pool(CLI::App& app, Options& options) {
  const auto any_number = [&pool = options.pool] {
    if (pool.count == Pool{}.count) pool.count = Pool::no_limit;
  };
  app.add_option("--solutions", options.pool.count, "number of best solutions")
      ->check(CLI::PositiveNumber);
  app.add_option("--within", options.pool.gap,
                 "all solutions whose objective differs from the best one by at most this")
      ->check(CLI::NonNegativeNumber)
      ->each([any_number](const std::string&) { any_number(); });
  app.add_option("--within-share", options.pool.relative_gap,
                 "the same, relative to the best objective")
      ->check(CLI::Range(0.0, 1.0))
      ->each([any_number](const std::string&) { any_number(); });
  app.add_option("--cutoff", options.cutoff, "only solutions whose objective is as good as this");
}

void describe(CLI::App& app, ProblemKind kind, CommandLine& line) {
  auto& options = line.options;
  std::map<std::string, Goal> goals{{"all", Goal::all}, {"first", Goal::first}};
  if (kind.has_objective) goals["best"] = Goal::best;
  add_choice(app, "--goal", goals, options.goal, "solutions that are requested");
  if (kind.has_objective) describe_pool(app, options);
  if (kind.bounded) {
    const std::map<std::string, Order> orders{
        {"depth", Order::depth_first}, {"best", Order::best_first}, {"hybrid", Order::hybrid}};
    add_choice(app, "--order", orders, options.order, "node that a rank opens next");
    app.add_option("--gap", options.limits.gap,
                   "relative gap between objective and bound at which the search stops")
        ->check(CLI::PositiveNumber);
    app.add_option("--heap-nodes", options.heap_nodes,
                   "open nodes of a rank above which it searches depth first");
    app.add_option("--heap-bytes", options.heap_bytes,
                   "memory of these nodes above which a rank searches depth first")
        ->transform(CLI::AsSizeValue(false));
  }
  app.add_option("--time-limit", options.limits.seconds, "maximum time, in seconds")
      ->check(CLI::PositiveNumber);
  app.add_option("--node-limit", options.limits.nodes, "maximum number of nodes, on all ranks");
  app.add_option("--solution-limit", options.limits.solutions, "maximum number of solutions");
  auto* const resume =
      app.add_option("--resume", line.resume,
                     "file of the state: written during the search, read by a later call");
  app.add_option("--checkpoint-interval", options.checkpoint.interval, "seconds between two states")
      ->check(CLI::PositiveNumber);
  app.add_option("--record", line.record,
                 "file that receives depth and time of each node, for kusabi bench scaling --trace")
      ->excludes(resume);
  app.add_option("--check-expand", options.check_expand,
                 "share of the nodes that are expanded twice and compared")
      ->check(CLI::Range(0.0, 1.0));
  app.add_flag("--quiet", line.quiet, "no progress and no summary");
  app.add_option("words", line.words, "words of the program itself");
}

// Without the folder.
std::string name_of_program(const char* path) {
  const std::string whole = path;
  return whole.substr(whole.rfind('/') + 1);
}

}  // namespace

CommandLine read_command_line(int argc, const char* const* argv, ProblemKind kind,
                              const Options& options) {
  CommandLine line;
  line.options = options;
  if (kind.has_objective && line.options.goal == Goal::all) line.options.goal = Goal::best;
  CLI::App app("Parallel tree search, in one process or under mpirun.", name_of_program(argv[0]));
  describe(app, kind, line);
  try {
    app.parse(argc, argv);
  } catch (const CLI::CallForHelp&) {
    line.help = app.help();
  } catch (const CLI::ParseError& wrong) {
    throw std::invalid_argument(wrong.what());
  }
  return line;
}

std::vector<std::string> own_words(int argc, const char* const* argv) {
  try {
    return read_command_line(argc, argv, {.has_objective = true, .bounded = true}).words;
  } catch (const std::invalid_argument&) {
    return {};  // `run` says what is wrong
  }
}

}  // namespace kusabi::engine
