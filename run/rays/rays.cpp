// From the file to the report: which way, on which ranks.
#include "run/rays/rays.hpp"

#include <algorithm>
#include <chrono>
#include <memory>
#include <optional>
#include <sstream>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "nodes/wedged/ray_tree.hpp"
#include "problems/files/structure_file.hpp"
#include "problems/wedged/precise_compliance.hpp"
#include "run/command/command_run.hpp"
#include "run/output/rank_table.hpp"
#include "run/output/standard_output.hpp"
#include "run/output/wrong_input.hpp"
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

std::optional<RaysFound> by_tree(CommandRun& run, const engine::Limits& limits,
                                 const problems::WedgedProblem& problem,
                                 const std::vector<double>& friction,
                                 const rays::ReactionCone& cone) {
  // Rays are known by their zeros at all candidates, so the blocks stay together.
  problems::WedgedProblem whole = problem;
  whole.blocks.clear();
  wedged::RayTree tree(wedged::SignPatternTree(whole, friction), cone);
  auto outcome = shown_search(run.session(), tree, {}, limits, run.quiet());
  if (!run.session().speaks()) return std::nullopt;
  return gathered(outcome);
}

class Rays final : public Subcommand {
 public:
  [[nodiscard]] std::string_view name() const override { return "rays"; }
  [[nodiscard]] std::string_view purpose() const override {
    return "every extremal ray of wedged configurations in the plane, and every maximal cone";
  }
  void describe(OptionTable& table) override;
  void check() const override;
  void read(CommandRun& run) override;
  void prepare(CommandRun& run) override;
  [[nodiscard]] std::string announcement(const std::string& ranks) const override;
  void search(CommandRun& run) override;
  std::vector<Step> results(CommandRun& run) override;
  Verdict verdict(CommandRun& run) override;

 private:
  RaysOptions options_;
  std::string text_;
  problems::WedgedProblem problem_;
  std::vector<double> friction_;
  std::optional<rays::ReactionCone> cone_;
  RayMethod method_ = RayMethod::automatic;
  std::optional<RaysFound> found_;  // on rank 0

  [[nodiscard]] bool whole() const { return found_->status == "solved"; }
};

void Rays::describe(OptionTable& table) {
  table.file("file", options_.file, Role::input, "the problem, a TOML file").required();
  table.number("--mu", &options_.friction, above(0), "friction coefficient").required();
  table.choice("--method", options_.method,
               {{"auto", RayMethod::automatic},
                {"double-description", RayMethod::double_description},
                {"tree", RayMethod::tree}},
               "Algorithm 4.2 on one rank, pattern by pattern on all ranks, or whichever suits the "
               "size; both give the same rays");
  table.output();
  table.output("--csv", "write the rays to this file, a line each");
  table.output("--dot", "write the cross-complementarity graph to this file, for Graphviz");
  table.time_limit(options_.limits);
  table.node_limit(options_.limits);
  table.quiet();
  table.serial();
}

void Rays::check() const {
  if (options_.method == RayMethod::double_description && limited(options_.limits)) {
    throw WrongInput(
        "--method double-description has nothing to show before its end; expected no "
        "limit, or --method tree");
  }
}

void Rays::read(CommandRun& run) {
  text_ = run.session().from_first_rank([&] { return problems::file_text(options_.file); });
}

void Rays::prepare(CommandRun& run) {
  // Every rank works the problem out by itself: the same text gives the same bits everywhere.
  const auto structure = problems::read_structure(text_, options_.file);
  problem_ = problems::wedged_problem(structure);
  agree(run.session(), problem_);
  if (problem_.dimension != 2) {
    throw WrongInput(fmt::format(
        "{}: dimension is 3; expected 2: in space the friction cones are round, and there "
        "is no finite list of extremal rays; use kusabi patterns instead",
        options_.file));
  }
  friction_ = friction_at(problem_, options_.friction, options_.file);
  cone_.emplace(problems::precise_compliance(structure), friction_);
  method_ = chosen_method(options_, cone_->candidates());
}

std::string Rays::announcement(const std::string& ranks) const {
  return fmt::format("{}; friction coefficient {}{}; {}{}", problem_line(problem_),
                     options_.friction,
                     uniform_friction(problem_) ? "" : " times that of each candidate",
                     method_ == RayMethod::tree ? "the tree of sign patterns on "
                                                : "double description on one of ",
                     ranks);
}

void Rays::search(CommandRun& run) {
  if (method_ == RayMethod::tree) {
    found_ = by_tree(run, options_.limits, problem_, friction_, *cone_);
  } else if (run.session().speaks()) {
    found_ = by_double_description(*cone_);
  }
}

std::vector<Step> Rays::results(CommandRun& run) {
  auto& found = *found_;
  std::sort(found.rays.begin(), found.rays.end(), rays::comes_before);
  if (whole()) found.cones = rays::maximal_cones(found.rays, cone_->all());
  const auto report = std::make_shared<RaysReport>(options_, problem_, *cone_, found);
  // All is written in one pass over the rays, so that their numbers are made only once.
  const auto table = std::make_shared<std::ostringstream>();
  const auto write = [&run, report, table](JsonWriter* json) {
    report->write(run.quiet() ? nullptr : table.get(),
                  run.wants("--csv") ? &run.stream("--csv") : nullptr, json);
  };
  return {run.wants("--output") ? run.result([write](JsonWriter& json) { write(&json); })
                                : [write] { write(nullptr); },
          run.file("--csv", {}),
          run.file("--dot", [report](std::ostream& out) { report->draw(out); }),
          [table] { print_answer(table->str()); }};
}

Verdict Rays::verdict(CommandRun& /*run*/) {
  if (!found_->health.sound()) {
    return {{fmt::format(
                "kusabi: {} numbers are too close to zero to tell from it: the lists may be wrong; "
                "expected a structure with less cancellation, fewer candidates, or another "
                "friction coefficient",
                found_->health.doubtful)},
            failed};
  }
  if (whole()) return {};
  return {{fmt::format("stopped early ({}): the list of rays is not complete, and no cones are "
                       "made of it",
                       found_->status)},
          stopped_early};
}

}  // namespace

std::unique_ptr<Subcommand> rays_subcommand() {
  return std::make_unique<Rays>();
}

}  // namespace kusabi::run
