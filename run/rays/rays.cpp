// `kusabi rays`: options, stages and results; both methods, on all ranks.
#include "run/rays/rays.hpp"

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <memory>
#include <optional>
#include <sstream>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "nodes/wedged/exact_list.hpp"
#include "nodes/wedged/rays/divided_rays.hpp"
#include "nodes/wedged/rays/ray_search.hpp"
#include "problems/files/problem_text.hpp"
#include "problems/files/structure_file.hpp"
#include "run/command/command_run.hpp"
#include "run/output/values.hpp"
#include "run/output/wrong_input.hpp"
#include "run/pictures/vtu_series.hpp"
#include "run/rays/rays_report.hpp"
#include "run/session/kept_state.hpp"
#include "run/session/progress_text.hpp"
#include "run/wedged/agreement.hpp"
#include "run/wedged/configuration_grid.hpp"
#include "run/wedged/exact_json.hpp"
#include "run/wedged/ignored_loads.hpp"
#include "run/wedged/problem_summary.hpp"
#include "run/wedged/whole_state_json.hpp"

namespace kusabi::run {
namespace {

using wedged::RayMethod;

// Columns of one ray, candidate by candidate.
std::vector<pictures::ContactState> contact_states_of(const rays::Supports& supports, int count) {
  std::vector<pictures::ContactState> states;
  for (int i = 0; i < count; ++i) {
    const bool separates = (supports.separated() & rays::bit(i)) != 0;
    const bool presses = (supports.reaction() & rays::bit(i)) != 0;
    states.push_back(separates ? pictures::ContactState::separated
                     : presses ? pictures::ContactState::contact
                               : pictures::ContactState::at_rest);
  }
  return states;
}

class Rays final : public Subcommand {
 public:
  [[nodiscard]] std::string_view name() const override { return "rays"; }
  [[nodiscard]] std::string_view purpose() const override {
    return "all extremal rays and maximal cones, in the plane";
  }
  [[nodiscard]] std::string_view description() const override {
    return "All extremal rays of wedged configurations in the plane, and all maximal cones.";
  }
  [[nodiscard]] std::string_view example() const override {
    return "examples/plane-truss.toml --mu 0.8";
  }
  [[nodiscard]] std::string notes() const override { return progress_explained(false); }
  void describe(OptionTable& table) override;
  void check() const override;
  void read(CommandRun& run) override;
  void prepare(CommandRun& run) override;
  [[nodiscard]] std::string announcement(const std::string& ranks) const override;
  void search(CommandRun& run) override;
  std::vector<Step> results(CommandRun& run) override;
  [[nodiscard]] Verdict verdict() const override;
  std::vector<std::string> remarks(CommandRun& run) override;

 private:
  void check_problem() const;
  void draw_all(OutputFolder& folder, const WholeStates& states) const;

  RaysOptions options_;
  std::string vtu_;
  problems::ProblemText text_;
  problems::Structure structure_;
  problems::WedgedProblem problem_;
  std::vector<double> friction_;
  std::optional<rays::ReactionCone> cone_;
  wedged::RayFindings found_;  // on rank 0
  wedged::ExactTest exact_;    // of its cones

  [[nodiscard]] bool whole() const { return found_.status == engine::Status::solved; }
};

void Rays::describe(OptionTable& table) {
  table.problem(options_.file);
  table.friction(options_.friction);
  table.choice("--method", options_.method,
               {{"auto", RayMethod::automatic},
                {"double-description", RayMethod::double_description},
                {"tree", RayMethod::tree}},
               "method: Algorithm 4.2 with all rays on every rank (double-description), pattern by "
               "pattern (tree), or the faster of both by a trial, with the list divided among the "
               "ranks (auto): the same rays");
  table.output();
  table.pictures(vtu_, "ray", "rays.pvd");
  table.further_output("--csv", "CSV file of the rays, one row each");
  table.further_output("--dot", "graph of cones and their rays for Graphviz; up to 200 rays");
  table.whole_states(options_.whole, "rays", "none");
  table.time_limit(options_.limits);
  table.node_limit(options_.limits);
  table.resume(options_.checkpoint, "; short steps that all ranks make together are repeated");
  table.prove(options_.prove,
              "compare the cones with a list of patterns that is tested exactly, as by kusabi "
              "verify");
  table.quiet();
  table.serial();
}

void Rays::check() const {
  if (options_.method == RayMethod::double_description && wedged::limited(options_.limits)) {
    throw WrongInput(
        "--method double-description gives no partial results; expected no limit, or another "
        "method");
  }
}

void Rays::read(CommandRun& run) {
  text_ = run.session().from_first_rank([&] { return problems::problem_text(options_.file); });
}

void Rays::prepare(CommandRun& run) {
  // Every rank prepares the problem by itself: the same text gives the same bits everywhere.
  auto [structure, facets] = problems::read_structure_and_facets(text_, options_.file);
  structure_ = std::move(structure);
  warn_all(run.session(), structure_.warnings);
  warn_all(run.session(), ignored_loads(structure_, "rays"));
  warn_all(run.session(), facet_warnings(facets, options_.friction, options_.file));
  problem_ = run.within_limits(
      [&](const auto& work) { return problems::wedged_problem(structure_, work); });
  agree(run.session(), problem_);
  run.keep_state(options_.checkpoint, {{"the problem", hexadecimal(problem_.fingerprint)}});
  check_problem();
  friction_ = friction_at(problem_, options_.friction, options_.file);
  cone_ = wedged::reaction_cone(problem_, friction_);
}

void Rays::check_problem() const {
  if (problem_.dimension != 2) {
    throw WrongInput(
        fmt::format("{}: dimension is 3; expected 2, since circular friction cones have no finite "
                    "list of extremal rays; kusabi patterns has no such limit",
                    options_.file));
  }
  const auto candidates = std::ssize(problem_.contact_names);
  if (candidates > rays::most_candidates) {
    throw WrongInput(fmt::format(
        "{}: {} contact candidates; expected at most {}; kusabi patterns has no such limit",
        options_.file, candidates, rays::most_candidates));
  }
}

std::string Rays::announcement(const std::string& ranks) const {
  const bool by_pattern = options_.method == RayMethod::tree;
  const auto megabytes =
      std::max<std::uint64_t>(wedged::memory_of_lists(cone_->candidates()) >> 20U, 1);
  return fmt::format("{}; friction coefficient {}{}; {} on {}{}", problem_line(problem_),
                     options_.friction,
                     uniform_friction(problem_) ? "" : " times that of each candidate",
                     by_pattern ? "the tree of sign patterns" : "double description", ranks,
                     options_.method == RayMethod::automatic
                         ? fmt::format(", lists of rays in {} MB each", megabytes)
                         : "");
}

void Rays::search(CommandRun& run) {
  engine::Analysis analysis(run.session().transport(), run.supervision(options_.limits));
  found_ = wedged::find_rays(analysis, problem_, friction_, *cone_, options_.method);
  const bool searched = run.session().from_first_rank([&] { return whole(); });
  if (!searched) return;
  const auto proving = options_.prove ? wedged::Proving::always : wedged::Proving::automatic;
  exact_ = wedged::tested_cones(analysis, {structure_, problem_, proving}, friction_, found_.cones);
}

void Rays::draw_all(OutputFolder& folder, const WholeStates& states) const {
  const ConfigurationGrids grids(states);
  const auto count = std::min(found_.rays.size(), longest_series);
  VtuSeries series(folder);
  auto health = found_.health;  // complete after the rays are written
  for (std::size_t i = 0; i < count; ++i) {
    const auto ray = cone_->ray(found_.rays[i], health);
    series.add(
        numbered_vtu("ray", i + 1, count),
        grids.grid({fmt::format("ray {} at friction coefficient {}", i + 1, options_.friction),
                    options_.friction},
                   numbers(ray.reaction), numbers(ray.displacement),
                   contact_states_of({found_.rays[i], cone_->all()}, cone_->candidates())));
  }
  series.finish("rays.pvd", problem_line(problem_));
}

std::vector<Step> Rays::results(CommandRun& run) {
  const auto states = std::make_shared<const WholeStates>(structure_, problem_);
  const auto report =
      std::make_shared<RaysReport>(options_, *states, *cone_, found_, exact_, CommandRun::page());
  // Table, CSV and JSON are written in one pass over the rays, whose numbers are computed once.
  const auto table = std::make_shared<std::ostringstream>();
  const auto write = [&run, report, table, states](JsonWriter* json) {
    report->write(run.quiet() ? nullptr : table.get(),
                  run.wants("--csv") ? &run.stream("--csv") : nullptr, json);
  };
  return {run.wants("--output") ? run.result([write](JsonWriter& json) { write(&json); })
                                : [write] { write(nullptr); },
          run.file("--csv", {}),
          run.folder("--vtu", [this, states](auto& folder) { draw_all(folder, *states); }),
          run.file("--dot", [report](std::ostream& out) { report->draw(out); }),
          run.answer([table] { return table->str(); })};
}

Verdict Rays::verdict() const {
  return {.ended = found_.status,
          .answer = Sticking{.thing = "extremal ray",
                             .friction = options_.friction,
                             .factor = !uniform_friction(problem_),
                             .count = found_.rays.size(),
                             .standing = Standing::computed,
                             .ambiguous = !found_.health.sound(),
                             .doubt = doubt_of(exact_)}};
}

std::vector<std::string> Rays::remarks(CommandRun& run) {
  if (!found_.health.sound()) {
    return {fmt::format(
        "kusabi: {} numbers cannot be distinguished from zero: the lists may be wrong; expected a "
        "structure with less cancellation, fewer candidates, or another friction coefficient",
        found_.health.doubtful)};
  }
  std::vector<std::string> remarks;
  const auto drawn = series_remark(found_.rays.size(), "rays");
  if (run.wants("--vtu") && !drawn.empty()) remarks.push_back(drawn);
  if (run.wants("--dot") && found_.rays.size() > most_drawn_rays) {
    remarks.push_back(
        fmt::format("--dot: {} rays exceed the limit of a graph ({}); the file of --output has the "
                    "rays of each cone, that of --csv a row per ray",
                    found_.rays.size(), most_drawn_rays));
  }
  if (whole()) return remarks;
  std::ranges::move(run.how_to_go_on(found_.status), std::back_inserter(remarks));
  return remarks;
}

}  // namespace

std::unique_ptr<Subcommand> rays_subcommand() {
  return std::make_unique<Rays>();
}

}  // namespace kusabi::run
