// `kusabi patterns`: options, stages and results, on all ranks.
#include "run/patterns/patterns.hpp"

#include <algorithm>
#include <memory>
#include <optional>
#include <vector>

#include <fmt/format.h>

#include "engine/analysis/analysis.hpp"
#include "nodes/wedged/pattern_search.hpp"
#include "nodes/wedged/sweep/pattern_brackets.hpp"
#include "nodes/wedged/tree/facets.hpp"
#include "problems/files/problem_text.hpp"
#include "problems/files/structure_file.hpp"
#include "run/command/command_run.hpp"
#include "run/evidence/certificate_file.hpp"
#include "run/output/rank_table.hpp"
#include "run/output/trace_file.hpp"
#include "run/output/values.hpp"
#include "run/output/wrong_input.hpp"
#include "run/patterns/patterns_report.hpp"
#include "run/pictures/vtu_series.hpp"
#include "run/session/kept_state.hpp"
#include "run/session/progress_text.hpp"
#include "run/wedged/agreement.hpp"
#include "run/wedged/configuration_grid.hpp"
#include "run/wedged/cuts_words.hpp"
#include "run/wedged/ignored_loads.hpp"
#include "run/wedged/problem_summary.hpp"
#include "run/wedged/whole_state_json.hpp"
#include "support/fingerprint.hpp"

namespace kusabi::run {
namespace {

class Patterns final : public Subcommand {
 public:
  [[nodiscard]] std::string_view name() const override { return "patterns"; }
  [[nodiscard]] std::string_view purpose() const override {
    return "all sign patterns of wedged configurations";
  }
  [[nodiscard]] std::string_view description() const override {
    return "Lists all combinations of contact and separation for which the structure sticks, each "
           "with one configuration. The list is complete up to rounding errors; --certificate and "
           "kusabi verify prove it.";
  }
  [[nodiscard]] std::string_view example() const override {
    return "examples/space-truss.toml --mu 0.65";
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
  [[nodiscard]] std::uint64_t tree_fingerprint() const;
  [[nodiscard]] bool whole() const { return findings_->whole(); }
  void end_certificate();
  void draw(OutputFolder& folder, const WholeStates& states) const;
  [[nodiscard]] std::string what_became_of_the_certificate() const;

  PatternsOptions options_;
  std::string trace_;
  std::string vtu_;
  problems::ProblemText text_;
  problems::Structure structure_;
  problems::WedgedProblem problem_;
  std::vector<double> friction_;
  wedged::PatternQuestion question_;
  std::optional<CertificateFile> certificate_;
  std::optional<wedged::PatternFindings> findings_;
  std::vector<wedged::PatternBracket> brackets_;  // on rank 0, if requested
  bool goes_on_ = false;  // a state is kept from which the search can be resumed
};

void Patterns::describe(OptionTable& table) {
  using wedged::Branching;
  using wedged::FacetBound;
  table.problem(options_.file);
  table.friction(options_.friction).swept();
  // Lower limit: the digits of a double in a margin. Upper limit: larger values would leave nothing
  // to find.
  table.number("--tolerance", &options_.tolerance, between(1e-12, 1e-3),
               "margins |t*| up to this value are degenerate, neither positive nor negative");
  table.choice("--branching", options_.branching,
               {{"auto", Branching::automatic},
                {"paper", Branching::product},
                {"relative", Branching::relative},
                {"deepest", Branching::deepest},
                {"weighed", Branching::weighed}},
               "branching rule: largest u_n r_n (paper), the same relative to the compliance "
               "(relative), largest loss of both children (deepest), a weighted mean of these two "
               "(weighed), or the rule with the smallest sampled tree (auto). The patterns are the "
               "same, the number of nodes differs");
  table.choice(
      "--cuts", options_.tightening, cuts_words(),
      "compute bounds of the reaction and the gap of each candidate before the search, which cut "
      "nodes: for constrained bodies with a large tree (auto), never, or always");
  table.number("--probe", &options_.probes, between(0, 1000),
               "number of candidates for strong branching at each node: fewer nodes and a smaller "
               "certificate, but more time; 8 is enough");
  table.choice("--method", options_.polyhedral, {{"cones", false}, {"polyhedral", true}},
               "friction cones of the search: second-order cones, or polyhedral cones around them, "
               "with a test of each resulting pattern against the second-order cones");
  Range facets = between(FacetBound::fewest, FacetBound::most);
  facets.even = true;
  table.number("--facets", &options_.facets, facets, "number of facets per cone").needs("--method");
  table
      .flag("--candidates", options_.list_candidates,
            "list the patterns of the polyhedral cones, each with the result of its test")
      .needs("--method")
      .varies();
  table
      .choice("--sort", options_.sort,
              {{"number", PatternSort::number},
               {"margin", PatternSort::margin},
               {"contact", PatternSort::contact},
               {"critical", PatternSort::critical}},
              "order of the table: as found, by largest margin, by fewest candidates in contact, "
              "or by the friction coefficient at which each pattern first sticks, which costs some "
              "ten cone programs per pattern")
      .varies();
  table
      .number("--group", &options_.group, between(0, 1000),
              "list as one line the patterns whose contact sets differ in at most so many "
              "candidates, directly or through others; groups are also in the result file. "
              "Default: no groups, but on a terminal more than 40 patterns are grouped around "
              "those with the largest margins; 0 lists all")
      .varies();
  table
      .number("--top", &options_.top, above(0),
              "maximum number of rows; files contain all patterns")
      .varies();
  // Order by the number of decided signs, see SignPatternTree::bound.
  table
      .choice("--order", options_.order,
              {{"depth-first", engine::Order::depth_first},
               {"breadth-first", engine::Order::best_first}},
              "order in which nodes are opened; the patterns are the same, breadth-first needs "
              "more memory")
      .varies();
  table.output();
  table.further_output("--csv", "CSV file of the patterns, one row each");
  table.pictures(vtu_, "pattern", "patterns.pvd");
  table.whole_states(
      options_.whole, "patterns",
      fmt::format("the first {} and the one with the largest margin", whole_unless_requested));
  table.time_limit(options_.limits);
  table.node_limit(options_.limits);
  table
      .number("--pattern-limit", &options_.limits.solutions, above(0), "maximum number of patterns")
      .stops(engine::Status::solution_limit)
      .varies();
  table.resume(options_.checkpoint);
  table.former_name("--checkpoint", "--resume");
  table.former_name("--restart", "--resume");
  table.file("--trace", trace_, Role::output,
             "file for the timeline of all ranks, for ui.perfetto.dev");
  table.file("--certificate", options_.certificate, Role::evidence,
             "certificate file, for kusabi verify");
  table.flag("--exists", options_.exists,
             "find one pattern, or prove that there is none; large blocks are first searched "
             "without a tree");
  table.prove(options_.prove, "test every node exactly, as kusabi verify does");
  table.quiet();
  table.serial();
}

void Patterns::check() const {
  if (options_.facets != PatternsOptions{}.facets && !options_.polyhedral) {
    throw WrongInput("--facets: requires --method polyhedral");
  }
  if (options_.list_candidates && !options_.polyhedral) {
    throw WrongInput("--candidates: requires --method polyhedral");
  }
  if (options_.exists && !options_.certificate.empty()) {
    throw WrongInput(
        "--certificate: --exists writes no certificate; expected --certificate without --exists, "
        "or kusabi critical --certificate");
  }
  if (options_.probes > 0 && options_.polyhedral)
    throw WrongInput("--probe: requires --method cones");
}

void Patterns::read(CommandRun& run) {
  text_ = run.session().from_first_rank([&] { return problems::problem_text(options_.file); });
}

// Fingerprint of the tree: a checkpoint belongs to a tree, which depends on friction and tolerance.
std::uint64_t Patterns::tree_fingerprint() const {
  support::Fingerprint fingerprint;
  fingerprint.add(problem_.fingerprint);
  fingerprint.add(options_.friction);
  fingerprint.add(options_.tolerance);
  fingerprint.add(static_cast<std::uint64_t>(options_.branching));
  if (options_.tightening != wedged::Tightening::automatic)
    fingerprint.add(static_cast<std::uint64_t>(options_.tightening));
  fingerprint.add(static_cast<std::uint64_t>(options_.facets_in_use()));
  if (options_.probes > 0) fingerprint.add(static_cast<std::uint64_t>(options_.probes));
  if (options_.prove) fingerprint.add(std::string_view("prove"));
  if (options_.exists) fingerprint.add(std::string_view("exists"));
  return fingerprint.value();
}

void Patterns::prepare(CommandRun& run) {
  // Every rank prepares the problem by itself: the same text gives the same bits everywhere.
  auto [structure, facets] = problems::read_structure_and_facets(text_, options_.file);
  structure_ = std::move(structure);
  warn_all(run.session(), structure_.warnings);
  warn_all(run.session(), ignored_loads(structure_, "patterns"));
  warn_all(run.session(), facet_warnings(facets, options_.friction, options_.file));
  problem_ = run.within_limits(
      [&](const auto& work) { return problems::wedged_problem(structure_, work); });
  friction_ = friction_at(problem_, options_.friction, options_.file);
  agree(run.session(), problem_);
  if (options_.polyhedral && problem_.dimension == 2) {
    throw WrongInput(
        fmt::format("--method polyhedral: {} is a plane problem, whose friction cones are "
                    "polyhedral already; expected --method cones",
                    options_.file));
  }
  question_.tree = {.tolerances = {.sign = options_.tolerance},
                    .branching = options_.branching,
                    .tightening = options_.tightening,
                    .probes = options_.probes,
                    .facets = options_.facets_in_use(),
                    .thorough = !options_.certificate.empty()};
  question_.structure = &structure_;
  if (options_.prove) question_.proving = wedged::Proving::always;
  question_.exists = options_.exists;
  auto& search = question_.search;
  search.order = options_.order;
  run.keep_state(options_.checkpoint, {{"the problem", hexadecimal(problem_.fingerprint)}});
  // If an earlier run has finished, no further evidence is recorded.
  certificate_.emplace(run.session(), run.has_searched() ? std::string() : options_.certificate,
                       options_.file, tree_fingerprint(), run.has_begun_to_search(),
                       options_.checkpoint.state);
  if (certificate_->wanted())
    question_.recorder = [this](const auto& evidence) { certificate_->add(evidence); };
  if (!trace_.empty()) search.trace_events = trace_events_a_rank(run.session().ranks());
  search.warn = warn;
}

std::string Patterns::announcement(const std::string& ranks) const {
  return fmt::format("{}; friction coefficient {}{}; {}", problem_line(problem_), options_.friction,
                     uniform_friction(problem_) ? "" : " times that of each candidate", ranks);
}

void Patterns::search(CommandRun& run) {
  engine::Analysis analysis(run.session().transport(), run.supervision(options_.limits));
  findings_ = wedged::find_patterns(analysis, problem_, friction_, question_);
  if (certificate_->wanted()) certificate_->close();
  if (options_.sort != PatternSort::critical) return;
  const bool searched = run.session().from_first_rank([&] { return whole(); });
  if (!searched) return;
  brackets_ = wedged::pattern_brackets(analysis, problem_, findings_->leaves, options_.friction);
}

// After an early stop the parts of the certificate are kept only with a checkpoint to resume from.
void Patterns::end_certificate() {
  if (!certificate_->wanted() && !options_.certificate.empty()) {
    put_earlier_certificate_in_place(options_.certificate, options_.file, tree_fingerprint(),
                                     certificate_header(problem_, friction_, findings_->bounds));
  }
  if (!certificate_->wanted()) return;
  if (whole()) {
    certificate_->put_in_place(certificate_header(problem_, friction_, findings_->bounds));
  } else if (goes_on_) {
    certificate_->require_parts();
  } else {
    certificate_->drop();
  }
}

std::string Patterns::what_became_of_the_certificate() const {
  if (whole()) return fmt::format("wrote {}", options_.certificate);
  if (goes_on_) return fmt::format("the proofs so far are in {}.part.*", options_.certificate);
  return "no certificate: an incomplete one could not be resumed";
}

void Patterns::draw(OutputFolder& folder, const WholeStates& states) const {
  const ConfigurationGrids grids(states);
  const auto& leaves = findings_->leaves;
  const auto count = std::min(leaves.size(), longest_series);
  VtuSeries series(folder);
  for (std::size_t i = 0; i < count; ++i) {
    const auto& leaf = leaves[i];
    series.add(
        numbered_vtu("pattern", i + 1, count),
        grids.grid({fmt::format("pattern {} at friction coefficient {}", i + 1, options_.friction),
                    options_.friction, leaf.lower},
                   leaf.block, leaf.pattern, findings_->idle(), leaf.reaction, leaf.displacement));
  }
  series.finish("patterns.pvd", problem_line(problem_));
}

std::vector<Step> Patterns::results(CommandRun& run) {
  const auto report = std::make_shared<const PatternsReport>(
      PatternsReport{options_, problem_, *findings_, brackets_, CommandRun::page()});
  goes_on_ = !options_.checkpoint.state.empty();
  const auto states = std::make_shared<const WholeStates>(structure_, problem_);
  return {run.result(
              [report, states](JsonWriter& json) { report->write(json, WholeStateJson(*states)); }),
          run.file("--csv", [report](std::ostream& out) { report->write_csv(out); }),
          run.folder("--vtu", [this, states](auto& folder) { draw(folder, *states); }),
          run.file("--trace", [this](auto& out) { write_trace(out, findings_->outcome.traces); }),
          [this] { end_certificate(); },
          run.answer([report] { return report->table(); })};
}

Verdict Patterns::verdict() const {
  return PatternsReport{options_, problem_, *findings_, brackets_, CommandRun::page()}.verdict();
}

std::vector<std::string> Patterns::remarks(CommandRun& run) {
  std::vector<std::string> remarks;
  const auto& outcome = findings_->outcome;
  if (!whole() && verdict().ended != engine::Status::solved)
    remarks = run.how_to_go_on(outcome.status);
  const auto drawn = series_remark(findings_->leaves.size(), "patterns");
  if (run.wants("--vtu") && !drawn.empty()) remarks.push_back(drawn);
  if (!options_.certificate.empty() && !(whole() && run.quiet())) {
    remarks.push_back(what_became_of_the_certificate());
  }
  return remarks;
}

}  // namespace

std::unique_ptr<Subcommand> patterns_subcommand() {
  return std::make_unique<Patterns>();
}

}  // namespace kusabi::run
