// From the file to the report, on all ranks.
#include "run/patterns/patterns.hpp"

#include <cstdio>
#include <optional>
#include <stdexcept>

#include <fmt/format.h>

#include "engine/checkpoint.hpp"
#include "engine/together.hpp"
#include "nodes/wedged/pattern_search.hpp"
#include "problems/files/structure_file.hpp"
#include "run/evidence/certificate_file.hpp"
#include "run/output/exit_code.hpp"
#include "run/output/last_steps.hpp"
#include "run/output/output_file.hpp"
#include "run/output/outputs.hpp"
#include "run/output/rank_table.hpp"
#include "run/output/result_file.hpp"
#include "run/output/standard_output.hpp"
#include "run/output/trace_file.hpp"
#include "run/patterns/patterns_report.hpp"
#include "run/session/restart.hpp"
#include "run/session/supervision.hpp"
#include "run/wedged/agreement.hpp"
#include "run/wedged/problem_summary.hpp"
#include "support/fingerprint.hpp"

namespace kusabi::run {
namespace {

void announce(const PatternsOptions& options, const problems::WedgedProblem& problem, int ranks) {
  tell(
      "kusabi {} · patterns · {}\n"
      "{}; friction coefficient {}{}; {}\n",
      KUSABI_VERSION, options.file, problem_line(problem), options.friction,
      uniform_friction(problem) ? "" : " times that of each candidate",
      ranks == 1 ? "1 rank" : fmt::format("{} ranks", ranks));
}

// A checkpoint belongs to a tree, and the tree depends on the friction and the tolerance as well.
std::uint64_t tree_fingerprint(const problems::WedgedProblem& problem,
                               const PatternsOptions& options) {
  support::Fingerprint fingerprint;
  fingerprint.add(problem.fingerprint);
  fingerprint.add(options.friction);
  fingerprint.add(options.tolerance);
  fingerprint.add(std::uint64_t{options.branching == wedged::Branching::product});
  fingerprint.add(static_cast<std::uint64_t>(options.facets));
  return fingerprint.value();
}

void tell_what_is_left(const PatternsOptions& options, const std::string& checkpoint,
                       const engine::Outcome<wedged::SignPatternTree>& outcome) {
  tell("stopped early ({}): {} open nodes are left, the list is not complete\n",
       status_name(outcome.status), outcome.open);
  std::string call = fmt::format("kusabi patterns {} --mu {}", options.file, options.friction);
  const PatternsOptions usual;
  if (options.tolerance != usual.tolerance)
    call += fmt::format(" --tolerance {}", options.tolerance);
  if (options.branching != usual.branching) call += " --branching paper";
  if (options.facets != 0) call += fmt::format(" --method polyhedral --facets {}", options.facets);
  if (!options.certificate.empty()) call += fmt::format(" --certificate {}", options.certificate);
  tell_how_to_go_on(call, checkpoint, outcome.saved);
}

void tell_what_is_open(std::size_t leaves) {
  tell(
      "open: of {} sign pattern{} it could not be told whether anything wedges: the list is "
      "complete but for {}\n",
      leaves, leaves == 1 ? "" : "s", leaves == 1 ? "it" : "them");
}

// Of a search that stopped early the parts stay, if anything can go on from them. On all ranks.
void end_certificate(Session& session, CertificateFile& certificate, const std::string& header,
                     bool whole, bool goes_on) {
  if (!certificate.wanted()) return;
  certificate.close();
  if (!session.speaks()) return;
  if (whole) {
    certificate.put_in_place(header);
  } else if (!goes_on) {
    certificate.drop();
  }
}

void tell_what_became_of_the_certificate(const PatternsOptions& options, bool whole, bool goes_on) {
  if (options.certificate.empty()) return;
  if (whole) {
    if (!options.quiet) tell_written({options.certificate});
  } else if (goes_on) {
    tell("what is proved so far is in {}.part.*\n", options.certificate);
  } else {
    tell("no certificate: nothing could go on with an incomplete one\n");
  }
}

}  // namespace

int patterns(Session& session, const PatternsOptions& options) {
  std::optional<ResultFile> result_file;
  std::optional<OutputFile> trace_file;
  const std::string text = session.from_first_rank([&] {
    auto content = problems::file_text(options.file);
    check_outputs(
        options.file,
        {{"--output", options.output},
         {"--trace", options.trace},
         {"--certificate", options.certificate}},
        {{"--checkpoint", options.checkpoint.empty() ? options.restart : options.checkpoint}});
    result_file.emplace(options.output, options.file);
    trace_file.emplace("--trace", options.trace, options.file);
    return content;
  });
  // Every rank works the problem out by itself: the same text gives the same bits everywhere.
  const auto problem = problems::wedged_problem(problems::read_structure(text, options.file));
  const auto friction = friction_at(problem, options.friction, options.file);
  agree(session, problem);
  if (options.facets != 0 && problem.dimension == 2) {
    throw WrongInput(fmt::format(
        "--method polyhedral: {} is in the plane, where the friction cone is a polyhedron already; "
        "expected --method cones",
        options.file));
  }
  wedged::PatternQuestion question;
  question.tree = {.tolerances = {.sign = options.tolerance},
                   .branching = options.branching,
                   .facets = options.facets,
                   .thorough = !options.certificate.empty()};

  auto& search_options = question.search;
  auto& checkpoint = search_options.checkpoint;
  checkpoint.file = options.checkpoint.empty() ? options.restart : options.checkpoint;
  checkpoint.interval = options.checkpoint_interval;
  const auto fingerprint = tree_fingerprint(problem, options);
  checkpoint.problem = fingerprint;
  checkpoint.resume_from = restart_from(session, options.checkpoint, options.restart, fingerprint);
  CertificateFile certificate(session, options.certificate, options.file, fingerprint,
                              !options.restart.empty(), checkpoint.file);
  if (certificate.wanted())
    question.witness = [&](const auto& evidence) { certificate.add(evidence); };
  if (!options.trace.empty()) search_options.trace_events = trace_events_a_rank(session.ranks());
  search_options.warn = warn;
  if (session.speaks() && !options.quiet) announce(options, problem, session.ranks());
  engine::Campaign campaign(session.transport(), supervision(options.limits, options.quiet));
  const auto findings = wedged::find_patterns(campaign, problem, friction, question);
  const auto& outcome = findings.outcome;

  const bool whole = findings.whole();
  const bool goes_on = !checkpoint.file.empty() && engine::checkpoint_exists(checkpoint.file);
  const auto certified = [&] {
    end_certificate(session, certificate, certificate_header(problem, friction), whole, goes_on);
  };
  std::size_t open = 0;
  if (!session.speaks()) {
    certified();
  } else {
    const PatternsReport report(options, problem, findings);
    open = findings.open();
    do_all({[&] { result_file->write(report.json()); },
            [&] {
              if (!trace_file->wanted()) return;
              write_trace(trace_file->stream(), outcome.traces);
              trace_file->put_in_place();
            },
            certified,
            [&] {
              if (!options.quiet) print_answer(report.table());
            }});
    if (!options.quiet) tell_written({options.output, options.trace});
    if (!whole) tell_what_is_left(options, checkpoint.file, outcome);
    if (open != 0) tell_what_is_open(open);
    tell_what_became_of_the_certificate(options, whole, goes_on);
  }
  const bool answered =
      engine::from_first_rank(session.transport(), [&] { return whole && open == 0; });
  return answered ? solved : stopped_early;
}

}  // namespace kusabi::run
