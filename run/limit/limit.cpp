// From the file to the report, on all ranks.
#include "run/limit/limit.hpp"

#include <optional>
#include <string>

#include <fmt/format.h>

#include "engine/together.hpp"
#include "nodes/limit/limit_loads.hpp"
#include "problems/files/structure_file.hpp"
#include "problems/limit/limit_problem.hpp"
#include "run/limit/limit_report.hpp"
#include "run/output/exit_code.hpp"
#include "run/output/last_steps.hpp"
#include "run/output/output_file.hpp"
#include "run/output/outputs.hpp"
#include "run/output/result_file.hpp"
#include "run/output/standard_output.hpp"
#include "run/session/supervision.hpp"
#include "verify/limit_certificate.hpp"

namespace kusabi::run {
namespace {

using problems::LimitProblem;

void announce(const LimitOptions& options, const LimitProblem& problem, int ranks) {
  tell(
      "kusabi {} · limit · {}\n"
      "{}: {}, {} nodes, {} members, {} free displacements; {}\n",
      KUSABI_VERSION, options.file, problem.name,
      problem.dimension == 2 ? "in the plane" : "in space", problem.node_names.size(),
      problem.member_count(), problem.free_count(),
      ranks == 1 ? "1 rank" : fmt::format("{} ranks", ranks));
}

limit::LimitFindings limit_findings(Session& session, const LimitOptions& options,
                                    const problems::Structure& truss, const LimitProblem& problem) {
  engine::Campaign campaign(session.transport(), supervision(options.limits, options.quiet));
  try {
    return limit::limit_loads(campaign, truss, problem,
                              {.alpha = options.alpha,
                               .method = options.method,
                               .big_m = options.big_m,
                               .samples = options.samples,
                               .seed = options.seed,
                               .curve = options.curve});
  } catch (const limit::BigMTooSmall&) {
    throw WrongInput(
        "--cuts: (29) has no point, its M is too small; expected a larger --big-m, or none");
  }
}

}  // namespace

int limit(Session& session, const LimitOptions& options) {
  std::optional<ResultFile> result_file;
  std::optional<OutputFile> certificate_file;
  const std::string text = session.from_first_rank([&] {
    auto content = problems::file_text(options.file);
    check_outputs(options.file,
                  {{"--output", options.output}, {"--certificate", options.certificate}});
    result_file.emplace(options.output, options.file);
    certificate_file.emplace("--certificate", options.certificate, options.file);
    return content;
  });
  // Every rank works the problem out by itself: the same text gives the same bits everywhere.
  const auto truss = problems::read_structure(text, options.file);
  const auto problem = problems::limit_problem(truss);
  engine::agree(session.transport(), problem.fingerprint);
  if (session.speaks() && !options.quiet) announce(options, problem, session.ranks());
  const auto found = limit_findings(session, options, truss, problem);
  const auto& answer = found.answer;
  const auto& certificate = found.certificate;
  if (session.speaks()) {
    if (!options.quiet && answer.worst && answer.worst->no_safe_m) {
      tell(
          "--cuts: no safe M was found, and (29) was not tried; the ends are those of static "
          "cuts\n");
    }
    const LimitReport report{options, problem, answer, session.ranks()};
    do_all({[&] { result_file->write(report.json()); },
            [&] {
              if (!certificate_file->wanted() || !certificate) return;
              certificate_file->stream() << limit_certificate_text(*certificate);
              certificate_file->put_in_place();
            },
            [&] {
              if (!options.quiet) print_answer(report.table());
            }});
    if (!options.quiet) {
      tell_written({options.output, certificate ? options.certificate : std::string()});
      if (!options.certificate.empty() && !certificate) {
        const bool load = answer.worst && answer.worst->status == limit::RootStatus::not_carried;
        tell("no certificate ({} is as it was): {}\n", options.certificate,
             !answer.worst ? "it would be of a worst case; expected --alpha"
             : load        ? "they hold load factors, and here a load is carried at none"
                           : "the two ends are not proved");
      }
    }
  }
  return answer.whole() ? solved : stopped_early;
}

}  // namespace kusabi::run
