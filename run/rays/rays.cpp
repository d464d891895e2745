// From the file to the report: which way, on which ranks.
#include "run/rays/rays.hpp"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <optional>
#include <sstream>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "engine/together.hpp"
#include "nodes/wedged/ray_tree.hpp"
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
#include "run/session/shown_search.hpp"
#include "run/wedged/agreement.hpp"
#include "run/wedged/problem_summary.hpp"

namespace kusabi::run {
namespace {

using nlohmann::ordered_json;

/// Up to so many candidates double description is two to four times as fast as the tree on one
/// rank, and takes less than a gigabyte; beyond, its memory grows threefold with each candidate,
/// and the tree's twofold from a tenth of it (bench/README.md). By size alone: the result must not
/// depend on the number of ranks.
constexpr int most_for_double_description = 14;

bool limited(const engine::Limits& limits) {
  const engine::Limits none;
  return limits.seconds != none.seconds || limits.nodes != none.nodes;
}

RayMethod chosen_method(const RaysOptions& options, int candidates) {
  if (options.method != RayMethod::automatic) return options.method;
  // Only the tree can stop early with something to show for it.
  const bool small = candidates <= most_for_double_description && !limited(options.limits);
  return small ? RayMethod::double_description : RayMethod::tree;
}

ordered_json effort_json(const rays::Effort& effort) {
  return {{"peak_rays", effort.peak_rays}, {"pairs", effort.pairs}, {"adjacent", effort.adjacent}};
}

RaysFound by_double_description(const rays::ReactionCone& cone) {
  const auto start = std::chrono::steady_clock::now();
  auto enumeration = rays::complementary_rays(cone);
  const std::chrono::duration<double> time = std::chrono::steady_clock::now() - start;
  RaysFound found;
  found.rays = std::move(enumeration.rays);
  found.health = enumeration.health;
  found.statistics = effort_json(enumeration.effort);
  found.statistics["seconds"] = time.count();
  return found;
}

// What rank 0 makes of the outcome of the tree.
RaysFound gathered(engine::Outcome<wedged::RayTree>& outcome) {
  RaysFound found;
  found.method = RayMethod::tree;
  found.status = status_name(outcome.status);
  const auto total = outcome.tally();
  for (auto& leaf : outcome.solutions) {
    auto& own = leaf.solution.rays;
    found.rays.insert(found.rays.end(), own.begin(), own.end());
    own = {};  // the memory is needed
  }
  found.health = total.health;
  found.tree = tally_json(total.patterns);
  found.tree["opened"] = outcome.opened();
  found.tree["open"] = outcome.open;
  found.tree["fingerprint"] = fmt::format("{:016x}", outcome.fingerprint());
  found.statistics = {{"ranks", rank_reports(outcome.ranks, [](const auto& tally) {
                         auto own = tally_json(tally.patterns);
                         own.update(effort_json(tally.effort));
                         return own;
                       })}};
  return found;
}

std::optional<RaysFound> by_tree(Session& session, const RaysOptions& options,
                                 const problems::WedgedProblem& problem,
                                 const std::vector<double>& friction,
                                 const rays::ReactionCone& cone) {
  // Rays are known by their zeros at all candidates, so the blocks stay together.
  problems::WedgedProblem whole = problem;
  whole.blocks.clear();
  wedged::RayTree tree(wedged::SignPatternTree(whole, friction), cone);
  auto outcome = shown_search(session, tree, {}, options.limits, options.quiet);
  if (!session.speaks()) return std::nullopt;
  return gathered(outcome);
}

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
           const rays::ReactionCone& cone, RaysFound& found, RaysFiles& files) {
  const bool whole = found.status == "solved";
  std::sort(found.rays.begin(), found.rays.end(), rays::comes_before);
  if (whole) found.cones = rays::maximal_cones(found.rays, cone.all());
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
        found.status);
  }
  return whole ? solved : stopped_early;
}

}  // namespace

int rays(Session& session, const RaysOptions& options) {
  std::optional<RaysFiles> files;
  const std::string text = session.from_first_rank([&] {
    if (options.method == RayMethod::double_description && limited(options.limits)) {
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
  const RayMethod method = chosen_method(options, cone.candidates());
  if (session.speaks() && !options.quiet) announce(options, problem, method, session.ranks());

  std::optional<RaysFound> found;
  if (method == RayMethod::tree) {
    found = by_tree(session, options, problem, friction, cone);
  } else if (session.speaks()) {
    found = by_double_description(cone);
  }
  const int code = found ? report(options, problem, cone, *found, *files) : int{solved};
  engine::meet(session.transport());
  return code;
}

}  // namespace kusabi::run
