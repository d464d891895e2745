// From the file to the bracket, on all ranks.
#include "run/critical/critical.hpp"

#include <cmath>
#include <cstdio>
#include <optional>
#include <vector>

#include <fmt/format.h>

#include "nodes/wedged/critical_friction.hpp"
#include "nodes/wedged/critical_search.hpp"
#include "problems/files/structure_file.hpp"
#include "run/critical/critical_certificate.hpp"
#include "run/critical/critical_report.hpp"
#include "run/output/exit_code.hpp"
#include "run/output/last_steps.hpp"
#include "run/output/outputs.hpp"
#include "run/output/rank_table.hpp"
#include "run/output/result_file.hpp"
#include "run/output/standard_output.hpp"
#include "run/session/supervision.hpp"
#include "run/wedged/agreement.hpp"
#include "run/wedged/problem_summary.hpp"

namespace kusabi::run {
namespace {

void announce(const CriticalOptions& options, const problems::WedgedProblem& problem, int ranks) {
  tell("kusabi {} · critical · {}\n{}; up to a friction coefficient of {}{}; {}\n", KUSABI_VERSION,
       options.file, problem_line(problem), options.most.value_or(wedged::usual_most),
       uniform_friction(problem) ? "" : " times that of each candidate",
       ranks == 1 ? "1 rank" : fmt::format("{} ranks", ranks));
}

void check(const CriticalOptions& options) {
  if (options.way != CriticalWay::global && !options.most) {
    throw WrongInput(
        "--mu-max is missing; expected the friction coefficient at which the patterns are looked "
        "for, or --method global");
  }
  const double most = options.most.value_or(wedged::usual_most);
  constexpr double most_multiples = 1e15;
  if (options.width >= most || most > most_multiples * options.width) {
    throw WrongInput(fmt::format("--width {}: expected a number below --mu-max {} and above {}",
                                 options.width, most, most / most_multiples));
  }
}

void tell_what_is_open(const CriticalOptions& options, const wedged::CriticalFindings& findings) {
  if (findings.status != engine::Status::solved) {
    tell("stopped early ({}): nothing lives below {:.10g}; more is not proved\n",
         status_name(findings.status), findings.lower);
  }
  for (const auto& sentence : open_sentences(options, findings)) tell("open: {}\n", sentence);
}

}  // namespace

int critical(Session& session, const CriticalOptions& asked) {
  CriticalOptions options = asked;
  std::optional<ResultFile> result_file;
  const std::string text = session.from_first_rank([&] {
    check(options);
    auto content = problems::file_text(options.file);
    std::vector<NamedFile> files{{"--output", options.output}};
    if (!options.certificate.empty()) {
      for (const char* const end : {".lower", ".upper"})
        files.push_back({"--certificate", options.certificate + end});
    }
    check_outputs(options.file, files);
    result_file.emplace(options.output, options.file);
    return content;
  });
  const auto structure = problems::read_structure(text, options.file);
  const auto problem = problems::wedged_problem(structure);
  // No further than the roughest candidate can be computed with.
  const double most = wedged::CriticalFriction::range(problem).most;
  if (options.most) friction_at(problem, *options.most, options.file);
  if (!options.most && most < wedged::usual_most) options.most = most;
  agree(session, problem);
  if (session.speaks() && !options.quiet) announce(options, problem, session.ranks());
  engine::Campaign campaign(session.transport(), supervision(options.limits, options.quiet));
  const auto findings = wedged::find_critical_friction(
      campaign, structure, problem,
      {.way = options.way, .most = options.most, .width = options.width},
      end_recorder(session, options, problem));
  int code = findings.answered() ? solved : stopped_early;
  if (session.speaks()) {
    do_all({[&] { result_file->write(critical_json(options, problem, findings)); },
            [&] {
              if (!options.quiet) print_answer(critical_table(options, problem, findings));
            }});
    if (!options.quiet) tell_written({options.output});
    tell_what_is_open(options, findings);
  }
  return code;
}

}  // namespace kusabi::run
