// From the file to the report: which way, on which ranks.
#include "run/rays/rays.hpp"

#include <cstdio>
#include <optional>
#include <sstream>

#include <fmt/format.h>

#include "engine/together.hpp"
#include "nodes/wedged/ray_search.hpp"
#include "problems/files/structure_file.hpp"
#include "problems/wedged/precise_compliance.hpp"
#include "run/output/exit_code.hpp"
#include "run/output/last_steps.hpp"
#include "run/output/output_file.hpp"
#include "run/output/outputs.hpp"
#include "run/output/rank_table.hpp"
#include "run/output/result_file.hpp"
#include "run/output/standard_output.hpp"
#include "run/rays/rays_report.hpp"
#include "run/session/supervision.hpp"
#include "run/wedged/agreement.hpp"
#include "run/wedged/problem_summary.hpp"

namespace kusabi::run {
namespace {

void announce(const RaysOptions& options, const problems::WedgedProblem& problem, RayMethod method,
              int ranks) {
  tell(
      "kusabi {} · rays · {}\n"
      "{}; friction coefficient {}{}; {}{}\n",
      KUSABI_VERSION, options.file, problem_line(problem), options.friction,
      uniform_friction(problem) ? "" : " times that of each candidate",
      method == RayMethod::tree ? "the tree of sign patterns on " : "double description on one of ",
      ranks == 1 ? "1 rank" : fmt::format("{} ranks", ranks));
}

void refuse_space(const std::string& file) {
  throw WrongInput(fmt::format(
      "{}: dimension is 3; expected 2: in space the friction cones are round, and there "
      "is no finite list of extremal rays; use kusabi patterns instead",
      file));
}

// The files that rank 0 writes.
struct RaysFiles {
  RaysFiles(const RaysOptions& options)
      : result(options.output, options.file),
        csv("--csv", options.csv, options.file),
        dot("--dot", options.dot, options.file) {}
  ResultFile result;
  OutputFile csv;
  OutputFile dot;
};

// @return the exit code
int report(const RaysOptions& options, const problems::WedgedProblem& problem,
           const rays::ReactionCone& cone, wedged::RayFindings& found, RaysFiles& files) {
  const bool whole = found.status == engine::Status::solved;
  RaysReport report(options, problem, cone, found);
  std::ostringstream table;
  std::ostream* const csv = files.csv.wanted() ? &files.csv.stream() : nullptr;
  const auto write_all = [&](JsonWriter* json) {
    report.write(options.quiet ? nullptr : &table, csv, json);
  };
  do_all({[&] {
            if (files.result.wanted()) {
              files.result.write([&](JsonWriter& json) { write_all(&json); });
            } else {
              write_all(nullptr);
            }
          },
          [&] {
            if (files.csv.wanted()) files.csv.put_in_place();
          },
          [&] {
            if (!files.dot.wanted()) return;
            report.draw(files.dot.stream());
            files.dot.put_in_place();
          },
          [&] { print_answer(table.str()); }});
  if (!options.quiet) tell_written({options.output, options.csv, options.dot});
  if (!found.health.sound()) {
    tell(
        "kusabi: {} numbers are too close to zero to tell from it: the lists may be wrong; "
        "expected a structure with less cancellation, fewer candidates, or another friction "
        "coefficient\n",
        found.health.doubtful);
    return failed;
  }
  if (!whole) {
    tell(
        "stopped early ({}): the list of rays is not complete, and no cones are made "
        "of it\n",
        status_name(found.status));
  }
  return whole ? solved : stopped_early;
}

}  // namespace

int rays(Session& session, const RaysOptions& options) {
  std::optional<RaysFiles> files;
  const std::string text = session.from_first_rank([&] {
    if (options.method == RayMethod::double_description && wedged::limited(options.limits)) {
      throw WrongInput(
          "--method double-description has nothing to show before its end; expected no "
          "limit, or --method tree");
    }
    auto content = problems::file_text(options.file);
    check_outputs(options.file,
                  {{"--output", options.output}, {"--csv", options.csv}, {"--dot", options.dot}});
    files.emplace(options);
    return content;
  });
  // Every rank works the problem out by itself: the same text gives the same bits everywhere.
  const auto structure = problems::read_structure(text, options.file);
  const auto problem = problems::wedged_problem(structure);
  agree(session, problem);
  if (problem.dimension != 2) refuse_space(options.file);
  const auto friction = friction_at(problem, options.friction, options.file);
  const rays::ReactionCone cone(problems::precise_compliance(structure), friction);
  const RayMethod method = wedged::chosen_method(options.method, options.limits, cone.candidates());
  if (session.speaks() && !options.quiet) announce(options, problem, method, session.ranks());

  // Double description has nothing to show before its end, so a signal ends it at once.
  engine::Campaign campaign(session.transport(), method == RayMethod::tree
                                                     ? supervision(options.limits, options.quiet)
                                                     : engine::Supervision{});
  auto found = wedged::find_rays(campaign, problem, friction, cone, method);
  const int code = session.speaks() ? report(options, problem, cone, found, *files) : int{solved};
  engine::meet(session.transport());
  return code;
}

}  // namespace kusabi::run
