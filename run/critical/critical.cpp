// `kusabi critical`: options, stages and results, on all ranks.
#include "run/critical/critical.hpp"

#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "nodes/wedged/critical_search.hpp"
#include "nodes/wedged/friction/critical_friction.hpp"
#include "problems/files/problem_text.hpp"
#include "problems/files/structure_file.hpp"
#include "run/command/command_run.hpp"
#include "run/critical/critical_certificate.hpp"
#include "run/critical/critical_report.hpp"
#include "run/critical/critical_verdict.hpp"
#include "run/output/values.hpp"
#include "run/output/wrong_input.hpp"
#include "run/pictures/vtu_series.hpp"
#include "run/session/kept_state.hpp"
#include "run/session/progress_text.hpp"
#include "run/wedged/agreement.hpp"
#include "run/wedged/configuration_grid.hpp"
#include "run/wedged/cuts_words.hpp"
#include "run/wedged/ignored_loads.hpp"
#include "run/wedged/problem_summary.hpp"
#include "run/wedged/whole_state_json.hpp"

namespace kusabi::run {
namespace {

class Critical final : public Subcommand {
 public:
  [[nodiscard]] std::string_view name() const override { return "critical"; }
  [[nodiscard]] std::string_view purpose() const override {
    return "smallest friction coefficient with a wedged configuration";
  }
  [[nodiscard]] std::string_view description() const override {
    return "The smallest friction coefficient at which the structure can stick, with a proved "
           "lower and upper bound.";
  }
  [[nodiscard]] std::string_view example() const override {
    return "examples/wedge-in-groove.toml";
  }
  [[nodiscard]] std::string notes() const override { return progress_explained(true); }
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
  void draw(OutputFolder& folder, const WholeStates& states) const;

  CriticalOptions options_;
  std::string vtu_;
  problems::ProblemText text_;
  problems::Structure structure_;
  std::vector<problems::FacetDoubt> facets_;
  problems::WedgedProblem problem_;
  wedged::CriticalFindings findings_;
};

void Critical::describe(OptionTable& table) {
  table.problem(options_.file);
  table.choice("--method", options_.question.way,
               {{"auto", wedged::CriticalWay::automatic},
                {"descent", wedged::CriticalWay::descent},
                {"global", wedged::CriticalWay::global},
                {"newton", wedged::CriticalWay::newton},
                {"bisection", wedged::CriticalWay::bisection}},
               "search method. For the smallest coefficient: descent from --mu-max, global search "
               "from zero, or automatic alternation of both. For the coefficients of all patterns "
               "that stick at --mu-max: newton or bisection");
  table.number("--mu-max", &options_.question.most, above(0), "upper limit of the search");
  table.number("--width", &options_.question.width, above(0),
               "width of the brackets. Default: 1e-8; with more than 100 candidates 1e-6, and cone "
               "programs are solved in double precision only");
  table.choice("--cuts", options_.question.tightening, cuts_words(),
               "compute bounds of the reaction and the gap of each candidate, which cut nodes: for "
               "large constrained bodies (auto), never, or always");
  table.flag("--list", options_.question.list,
             "list all patterns that stick at the upper bound, not only the one that proves it");
  table
      .number("--list-limit", &options_.question.list_nodes, above(0),
              "maximum number of nodes opened for this list")
      .needs("--list");
  table
      .number("--top", &options_.top, above(0),
              "maximum number of rows, smallest coefficients first; files contain all patterns")
      .varies();
  table.output();
  table.further_output("--csv", "CSV file of the patterns, one row each");
  table.pictures(vtu_, "listed pattern", "critical.pvd");
  table
      .file("--certificate", options_.certificate, Role::evidence,
            "certificates of both bounds, NAME.lower and NAME.upper, for kusabi verify")
      .ends_in({".lower", ".upper"});
  table.whole_states(options_.whole, "patterns",
                     fmt::format("the first {}", whole_unless_requested));
  table.time_limit(options_.limits);
  table.node_limit(options_.limits);
  table.resume(options_.checkpoint, "; with --certificate both bounds are proved anew");
  table.save_on(options_.checkpoint);
  table.quiet();
  table.serial();
}

void Critical::check() const {
  if (!looks_for_smallest(options_.question.way) && !options_.question.most) {
    throw WrongInput(
        "--mu-max is missing; expected the friction coefficient of the list of patterns, or "
        "--method auto");
  }
  if (!looks_for_smallest(options_.question.way) && !vtu_.empty()) {
    throw WrongInput(
        "--vtu: this method stores no configurations; expected --method auto, descent or global");
  }
  if (!looks_for_smallest(options_.question.way) && options_.question.list) {
    throw WrongInput(
        "--list: this method lists all patterns that stick at --mu-max; expected --method auto, "
        "descent or global");
  }
  const double most = options_.question.most.value_or(wedged::usual_most);
  const double width = options_.question.width.value_or(wedged::usual_width);
  if (width >= most || most > wedged::most_multiples * width) {
    throw WrongInput(fmt::format("--width {}: expected a number below --mu-max {} and above {}",
                                 width, most, most / wedged::most_multiples));
  }
}

void Critical::read(CommandRun& run) {
  text_ = run.session().from_first_rank([&] { return problems::problem_text(options_.file); });
}

void Critical::prepare(CommandRun& run) {
  // Every rank prepares the problem by itself: the same text gives the same bits everywhere.
  auto [structure, facets] = problems::read_structure_and_facets(text_, options_.file);
  structure_ = std::move(structure);
  warn_all(run.session(), structure_.warnings);
  warn_all(run.session(), ignored_loads(structure_, "critical"));
  facets_ = std::move(facets);
  problem_ = run.within_limits(
      [&](const auto& work) { return problems::wedged_problem(structure_, work); });
  // Upper limit: the largest coefficient that the candidate with the most friction permits.
  const double most = wedged::CriticalFriction::range(problem_).most;
  if (options_.question.most) friction_at(problem_, *options_.question.most, options_.file);
  if (!options_.question.most && most < wedged::usual_most) options_.question.most = most;
  agree(run.session(), problem_);
  run.keep_state(options_.checkpoint, {{"the problem", hexadecimal(problem_.fingerprint)}});
}

std::string Critical::announcement(const std::string& ranks) const {
  return fmt::format("{}; up to a friction coefficient of {}{}; {}", problem_line(problem_),
                     options_.question.most.value_or(wedged::usual_most),
                     uniform_friction(problem_) ? "" : " times that of each candidate", ranks);
}

void Critical::search(CommandRun& run) {
  engine::Analysis analysis(run.session().transport(), run.supervision(options_.limits));
  findings_ = wedged::find_critical_friction(
      analysis, structure_, problem_, options_.question,
      end_recorder(run.session(), {options_.certificate, options_.file, run.quiet()}, problem_));
  if (!run.session().speaks()) return;
  const double answer = findings_.upper.value_or(findings_.lower);
  warn_all(run.session(), facet_warnings(facets_, answer, options_.file));
}

void Critical::draw(OutputFolder& folder, const WholeStates& states) const {
  const ConfigurationGrids grids(states);
  const auto& entries = findings_.patterns;
  const auto count = std::min(entries.size(), longest_series);
  VtuSeries series(folder);
  for (std::size_t i = 0; i < count; ++i) {
    const auto& entry = entries[i];
    if (entry.reaction.empty()) continue;
    series.add(
        numbered_vtu("pattern", i + 1, count),
        grids.grid({fmt::format("configuration that becomes feasible at friction coefficient {}",
                                entry.upper.value_or(entry.lower)),
                    entry.upper.value_or(entry.lower)},
                   entry.block, entry.pattern, {}, entry.reaction, entry.displacement));
  }
  series.finish("critical.pvd", problem_line(problem_));
}

std::vector<Step> Critical::results(CommandRun& run) {
  const auto states = std::make_shared<const WholeStates>(structure_, problem_);
  return {run.result([this, states] {
            return critical_json(options_, problem_, findings_, WholeStateJson(*states));
          }),
          run.file("--csv",
                   [this](std::ostream& out) { write_critical_csv(out, problem_, findings_); }),
          run.folder("--vtu", [this, states](auto& folder) { draw(folder, *states); }),
          run.answer([this] {
            return critical_table(options_, problem_, findings_, CommandRun::page());
          })};
}

Verdict Critical::verdict() const {
  return critical_verdict(options_, problem_, findings_);
}

std::vector<std::string> Critical::remarks(CommandRun& run) {
  if (findings_.status == engine::Status::solved) return {};
  return run.how_to_go_on(findings_.status);
}

}  // namespace

std::unique_ptr<Subcommand> critical_subcommand() {
  return std::make_unique<Critical>();
}

}  // namespace kusabi::run
