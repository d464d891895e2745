// `kusabi rays`: options, stages and results; both methods, on all ranks.
#include "run/rays/rays.hpp"

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <memory>
#include <optional>
#include <sstream>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "answer/words.hpp"
#include "engine/signals.hpp"
#include "nodes/wedged/exact_list.hpp"
#include "nodes/wedged/rays/ray_list_tree.hpp"
#include "nodes/wedged/rays/ray_search.hpp"
#include "run/command/command_run.hpp"
#include "run/command/registrations.hpp"
#include "run/output/values.hpp"
#include "run/output/wrong_input.hpp"
#include "run/pictures/vtu_series.hpp"
#include "run/rays/ray_lines.hpp"
#include "run/rays/rays_report.hpp"
#include "run/session/time_limit.hpp"
#include "run/wedged/configuration_grid.hpp"
#include "run/wedged/contact_problem.hpp"
#include "run/wedged/exact_json.hpp"
#include "run/wedged/problem_summary.hpp"
#include "run/wedged/whole_state_json.hpp"
#include "support/fingerprint.hpp"

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
                               : pictures::ContactState::inactive);
  }
  return states;
}

class Rays final : public Subcommand {
 public:
  void describe(OptionTable& table) override;
  void check() const override;
  void read(CommandRun& run) override { options_.input.read(run); }
  void prepare(CommandRun& run) override;
  [[nodiscard]] std::string announcement(const std::string& ranks) const override;
  void search(CommandRun& run) override;
  std::vector<Step> results(CommandRun& run) override;
  [[nodiscard]] answer::Verdict verdict() const override;
  [[nodiscard]] double seconds_to_write(std::uint64_t solutions) const override;
  [[nodiscard]] bool limit_includes_writing() const override { return options_.lines; }
  std::vector<std::string> remarks(CommandRun& run) override;

 private:
  void check_problem() const;
  void open_lines(CommandRun& run);
  [[nodiscard]] std::uint64_t tree_fingerprint() const;
  void end_lines(engine::Analysis& analysis);
  void draw_all(OutputFolder& folder, const WholeStates& states) const;

  const OptionTable* table_ = nullptr;
  RaysOptions options_;
  std::string vtu_;
  ContactProblem contact_;
  std::vector<double> friction_;
  std::optional<rays::ReactionCone> cone_;
  std::optional<RayLines> lines_;
  wedged::RayFindings found_;  // on rank 0
  wedged::ExactTest exact_;    // of its cones

  [[nodiscard]] bool whole() const { return found_.status == engine::Status::solved; }
  // True if the exact test of the cones, which comes after the search, leaves nothing open either.
  [[nodiscard]] bool answered() const { return whole() && exact_.unable.empty(); }
};

void Rays::describe(OptionTable& table) {
  table_ = &table;
  table.problem(options_.input.file);
  table.friction(options_.friction);
  table.choice("--method", options_.method,
               {{"auto", RayMethod::automatic},
                {"double-description", RayMethod::double_description},
                {"tree", RayMethod::tree}},
               "Algorithm 4.2 with all rays on every rank (double-description), the rays "
               "of each sign pattern in turn (tree), or the method that is faster in a trial, "
               "with the rays divided among the ranks (auto). The rays are the same");
  table.output();
  table.lines(options_.lines,
              "format of the result file: one object (json), or a line per ray (jsonl), for more "
              "than about 100,000 rays. All ranks write the lines during the search, and memory "
              "does not grow with their number, except with --method double-description");
  table.pictures(vtu_, "ray", "rays.pvd");
  table.csv_of("rays");
  table.further_output(
      "--dot", "graph of the maximal cones and their rays for Graphviz, of at most 200 rays");
  table.whole_states(options_.whole, "rays", "none");
  table.search_limits(options_.limits);
  table.resume(options_.checkpoint, ". A resumed run repeats short steps, which are not stored");
  table.prove(options_.prove,
              "compare the cones with a list of patterns whose nodes are tested in exact "
              "arithmetic, as kusabi verify does");
  table.quiet_and_serial();
}

void Rays::check() const {
  if (options_.lines) table_->check_lines({"--csv", "--vtu", "--dot", "--whole"});
  if (options_.method == RayMethod::double_description && wedged::limited(options_.limits)) {
    throw WrongInput(
        "--method double-description gives no partial results; expected no limit, or another "
        "method");
  }
}

void Rays::prepare(CommandRun& run) {
  contact_ = contact_problem(run, options_.input, options_.friction);
  check_problem();
  friction_ = friction_at(contact_.problem, options_.friction, options_.input.file);
  keep_state(run, options_.checkpoint, contact_.problem);
  cone_ = wedged::reaction_cone(contact_.problem, friction_);
  if (options_.lines) open_lines(run);
}

void Rays::open_lines(CommandRun& run) {
  lines_.emplace(run.session(), *cone_,
                 PartsOwner{.option = "--output",
                            .name = *table_->find("--output")->given,
                            .content = "the rays",
                            .tree = tree_fingerprint(),
                            .checkpoint = options_.checkpoint.state},
                 run.has_begun_to_search(), run.has_searched());
}

// Parts of lines belong to a problem, its friction and the method.
std::uint64_t Rays::tree_fingerprint() const {
  support::Fingerprint fingerprint;
  fingerprint.add(std::string_view("rays"));
  fingerprint.add(contact_.problem.provenance.fingerprint);
  fingerprint.add(options_.friction);
  fingerprint.add(static_cast<std::uint64_t>(options_.method));
  return fingerprint.value();
}

void Rays::check_problem() const {
  if (contact_.problem.dimension != 2) {
    throw WrongInput(
        fmt::format("{}: dimension is 3; expected 2, since circular friction cones have no finite "
                    "list of extremal rays; kusabi patterns has no such limit",
                    options_.input.file));
  }
  const auto candidates = std::ssize(contact_.problem.contact_names);
  if (candidates > rays::max_candidates) {
    throw WrongInput(fmt::format(
        "{}: {} contact candidates; expected at most {}; kusabi patterns has no such limit",
        options_.input.file, candidates, rays::max_candidates));
  }
}

std::string Rays::announcement(const std::string& ranks) const {
  const bool by_pattern = options_.method == RayMethod::tree;
  const auto longest = options_.lines ? wedged::longest_recorded_list : wedged::longest_list;
  const auto megabytes =
      std::max<std::uint64_t>(wedged::memory_of_lists(cone_->candidates(), longest) >> 20U, 1);
  return fmt::format("{}; friction coefficient {}; {} on {}{}", problem_line(contact_.problem),
                     friction_text(contact_.problem, options_.friction),
                     by_pattern ? "the tree of sign patterns" : "double description", ranks,
                     options_.method == RayMethod::automatic
                         ? fmt::format(", lists of rays in {} MB each", megabytes)
                         : "");
}

void Rays::search(CommandRun& run) {
  engine::Analysis analysis(run.session().transport(), run.analysis_options(options_.limits));
  wedged::RayRecorder recorder;
  if (lines_) recorder = [this](const auto& zero, const auto& ray) { lines_->add(zero, ray); };
  found_ =
      wedged::find_rays(analysis, contact_.problem, friction_, *cone_, options_.method, recorder);
  if (lines_) end_lines(analysis);
  const bool searched = run.session().from_first_rank([&] { return whole(); });
  if (!searched) return;
  const auto proving = options_.prove ? wedged::Proving::always : wedged::Proving::automatic;
  exact_ = wedged::tested_cones(analysis, {contact_.structure, contact_.problem, proving},
                                friction_, found_.cones);
}

void Rays::end_lines(engine::Analysis& analysis) {
  auto cones = lines_->close(found_);
  if (!analysis.is_first()) return;
  wedged::find_cones(found_, std::move(cones), cone_->all(), analysis.budget());
  // The search ended for the time to write, which is part of the limit.
  const bool limited = options_.limits.seconds != engine::Limits{}.seconds;
  if (limited && found_.status == engine::Status::interrupted && !engine::end_asked_by_signal())
    found_.status = engine::Status::time_limit;
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
  series.finish("rays.pvd", problem_line(contact_.problem));
}

std::vector<Step> Rays::results(CommandRun& run) {
  const auto states = std::make_shared<const WholeStates>(contact_.structure, contact_.problem);
  const auto report =
      std::make_shared<RaysReport>(options_, *states, *cone_, found_, exact_, CommandRun::page());
  const auto head =
      run.head(problem_json(contact_.structure, contact_.problem, options_.input.file));
  if (lines_) {
    return {run.result_lines(
                [this, report, states, head](std::ostream& out) {
                  return lines_->write(out, report->head_line(head));
                },
                [this] { lines_->end(!options_.checkpoint.state.empty() && !answered()); }),
            run.answer([report, states] { return report->summary(); })};
  }
  // Table, CSV and JSON are written in one pass over the rays, whose numbers are computed once.
  const auto table = std::make_shared<std::ostringstream>();
  const auto write = [&run, report, table, states, head](JsonWriter* json) {
    report->write(head, run.quiet() ? nullptr : table.get(),
                  run.wants("--csv") ? &run.stream("--csv") : nullptr, json);
  };
  return {run.wants("--output") ? run.result([write](JsonWriter& json) { write(&json); })
                                : [write] { write(nullptr); },
          run.file("--csv", {}),
          run.folder("--vtu", [this, states](auto& folder) { draw_all(folder, *states); }),
          run.file("--dot", [report](std::ostream& out) { report->draw(out); }),
          run.answer([table] { return table->str(); })};
}

answer::Verdict Rays::verdict() const {
  // Without a cone there is no ray.
  const bool none = exact_.cones == 0U && found_.count() == 0;
  const answer::Sticking sticking{
      .thing = "extremal ray",
      .friction = options_.friction,
      .factor = !uniform_friction(contact_.problem),
      .count = found_.count(),
      .standing = support::proved_if(none),
      .grounds = none ? answer::Grounds::exact_arithmetic : answer::Grounds::solver_bounds,
      .ambiguous = !found_.health.sound(),
      .proved_cones = exact_.cones,
      .remainder = remainder_of(exact_),
      .displacement_ratio = exact_.displacement_ratio};
  answer::Verdict verdict{.ended = found_.status, .answer = sticking};
  if (answer::is_known_to_stick(sticking)) verdict.details.push_back(answer::next_step(false));
  return verdict;
}

double Rays::seconds_to_write(std::uint64_t solutions) const {
  if (options_.lines) return seconds_per_written_line * static_cast<double>(solutions);
  return Subcommand::seconds_to_write(solutions);
}

std::vector<std::string> Rays::remarks(CommandRun& run) {
  if (!found_.health.sound()) {
    return {fmt::format(
        "kusabi: {} numbers cannot be distinguished from zero: the lists may be wrong; expected a "
        "structure with less cancellation, fewer candidates, or another friction coefficient",
        found_.health.undecided)};
  }
  std::vector<std::string> remarks;
  const auto drawn = series_remark(found_.rays.size(), "rays");
  if (run.wants("--vtu") && !drawn.empty()) remarks.push_back(drawn);
  if (run.wants("--dot") && found_.rays.size() > max_drawn_rays) {
    remarks.push_back(
        fmt::format("--dot: {} rays exceed the limit of a graph ({}); the file of --output has the "
                    "rays of each cone, that of --csv a row per ray",
                    found_.rays.size(), max_drawn_rays));
  }
  return remarks;
}

}  // namespace

constexpr Registration rays_subcommand{
    {.name = "rays",
     .chapter = "Wedged configurations",
     .purpose = "all extremal rays and maximal cones, in the plane",
     .description = "All extremal rays of the wedged configurations of a plane structure, and all "
                    "maximal cones, each with its rays.",
     .example = "examples/plane-truss.toml --mu 0.8",
     .progress = ProgressLines::solutions},
    make<Rays>};

}  // namespace kusabi::run
