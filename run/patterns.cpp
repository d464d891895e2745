// From the file to the report, on all ranks.
#include "run/patterns.hpp"

#include <cstdio>
#include <optional>
#include <vector>

#include <fmt/format.h>

#include "nodes/sign_pattern.hpp"
#include "problems/structure_file.hpp"
#include "run/exit_code.hpp"
#include "run/patterns_report.hpp"
#include "run/progress_line.hpp"
#include "run/result_file.hpp"

namespace kusabi::run {
namespace {

void announce(const PatternsOptions& options, const problems::WedgedProblem& problem, int ranks) {
  fmt::print(stderr,
             "kusabi {} · patterns · {}\n"
             "{}: {}, {} nodes, {} members, {} contact candidates; friction coefficient {}; {}\n",
             KUSABI_VERSION, options.file, problem.name,
             problem.dimension == 2 ? "in the plane" : "in space", problem.nodes, problem.members,
             problem.contact_names.size(), options.friction,
             ranks == 1 ? "1 rank" : fmt::format("{} ranks", ranks));
}

}  // namespace

int patterns(Session& session, const PatternsOptions& options) {
  std::optional<ResultFile> result_file;
  const std::string text = session.on_first_rank([&] {
    auto content = problems::file_text(options.file);
    if (options.output == options.file) {
      throw WrongInput(fmt::format("--output {}: is the problem file itself", options.output));
    }
    result_file.emplace(options.output);
    return content;
  });
  // Every rank works the problem out by itself: the same text gives the same bits everywhere.
  const auto problem = problems::wedged_problem(problems::read_structure(text, options.file));
  const std::vector<double> friction(problem.contact_names.size(), options.friction);
  nodes::SignPatternTree tree(problem, friction, {.sign = options.tolerance});

  engine::Options search_options;
  std::optional<ProgressLine> progress;
  if (session.speaks() && !options.quiet) {
    announce(options, problem, session.ranks());
    progress.emplace();
    search_options.progress = [&](const auto& state) { progress->show(state); };
  }
  const auto outcome = engine::search(tree, session.transport(), search_options);
  progress.reset();

  if (!session.speaks()) return solved;
  const PatternsReport report(options, problem, outcome);
  result_file->write(report.json());
  if (!options.quiet) fmt::print("{}", report.table());
  if (!options.output.empty()) fmt::print(stderr, "wrote {}\n", options.output);
  return solved;
}

}  // namespace kusabi::run
