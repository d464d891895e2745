// `kusabi patterns`: stages and results, on all ranks.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <sstream>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <unistd.h>

#include "engine/analysis/analysis.hpp"
#include "engine/node_record.hpp"
#include "nodes/wedged/hold/load_program.hpp"
#include "nodes/wedged/pattern_search.hpp"
#include "nodes/wedged/relaxation/facets.hpp"
#include "nodes/wedged/sweep/pattern_brackets.hpp"
#include "problems/structure/model/load_cases.hpp"
#include "run/command/command_run.hpp"
#include "run/command/subcommand.hpp"
#include "run/evidence/certificate_file.hpp"
#include "run/output/rank_table.hpp"
#include "run/output/standard_output.hpp"
#include "run/output/trace_file.hpp"
#include "run/output/values.hpp"
#include "run/output/wrong_input.hpp"
#include "run/patterns/pattern_lines.hpp"
#include "run/patterns/patterns_report.hpp"
#include "run/pictures/vtu_series.hpp"
#include "run/session/kept_state.hpp"
#include "run/session/time_limit.hpp"
#include "run/wedged/configuration_files.hpp"
#include "run/wedged/contact_problem.hpp"
#include "run/wedged/problem_summary.hpp"
#include "support/fingerprint.hpp"

namespace kusabi::run {

const OptionWords<wedged::Branching>& branching_words() {
  using wedged::Branching;
  static const OptionWords<Branching> words{{"auto", Branching::automatic},
                                            {"paper", Branching::product},
                                            {"relative", Branching::relative},
                                            {"deepest", Branching::deepest},
                                            {"weighed", Branching::weighed}};
  return words;
}

namespace {

// True if one reference load is the load of the file: none is of a load case.
bool has_reference_load(const problems::Structure& structure) {
  const auto is_reference = [](const auto& load) {
    return load.kind == problems::Load::Kind::reference;
  };
  return std::ranges::any_of(structure.loads, is_reference) &&
         problems::load_cases(structure).empty();
}

// A message, once, that a long list takes memory. @pre progress is shown
void report_memory(engine::AnalysisOptions& analysis_options) {
  constexpr std::uint64_t long_list = 100'000;
  constexpr std::uint64_t kilobytes = 5;  // for each pattern of 20 candidates
  analysis_options.watch = [watch = analysis_options.watch](engine::Goal goal,
                                                            const engine::ShownObjective& shown) {
    return [show = watch(goal, shown), reported = false](const engine::Progress& progress) mutable {
      show(progress);
      if (reported || progress.found < long_list) return;
      reported = true;
      print_message(
          "{}the {} patterns found so far take about {:.1f} GB of memory; --output FILE --format "
          "jsonl writes them during the search\n",
          isatty(STDERR_FILENO) != 0 ? "\n" : "", progress.found,
          static_cast<double>(kilobytes * progress.found) / 1e6);
    };
  };
}

class Patterns final : public Subcommand {
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
  std::vector<std::string> remarks(CommandRun& run) override;

 private:
  void describe_tree(OptionTable& table);
  void describe_table(OptionTable& table);
  void describe_limits(OptionTable& table);
  [[nodiscard]] std::uint64_t tree_fingerprint() const;
  [[nodiscard]] bool whole() const { return findings_->whole(); }
  void record_nodes(CommandRun& run);
  [[nodiscard]] nlohmann::ordered_json head(const CommandRun& run) const;
  Step result_lines(CommandRun& run);
  [[nodiscard]] PatternsReport report() const;
  [[nodiscard]] std::string header() const;  ///< of the certificate
  void end_certificate();
  void draw(OutputFolder& folder, const WholeStates& states) const;
  [[nodiscard]] std::string certificate_remark() const;

  const OptionTable* table_ = nullptr;
  PatternsOptions options_;
  std::ostringstream node_records_;
  ContactProblem contact_;
  std::vector<double> friction_;
  bool prove_ = false;
  std::optional<CertificateFile> certificate_;
  std::optional<PatternLines> lines_;
  std::optional<wedged::PatternFindings> findings_;
  PatternNumbers numbers_;                       // on rank 0
  std::optional<wedged::LoadedProblem> loaded_;  // if the file has a reference load
  std::optional<engine::Analysis> unlimited_;    // of the firmness of lines
  std::optional<wedged::PatternFirmness> firmness_;
  bool can_resume_ = false;  // a state is kept from which the search can be resumed
};

void Patterns::describe(OptionTable& table) {
  table_ = &table;
  table.problem(options_.input.file);
  table.friction(options_.friction).swept();
  describe_tree(table);
  describe_table(table);
  table.output();
  table.lines(options_.lines,
              "format of the result file: one object (json), or a line per pattern (jsonl), for "
              "more than about 100,000 patterns. All ranks write the lines during the search, and "
              "memory does not grow with their number; an object takes 5 kB of memory per pattern");
  table.csv_of("patterns");
  table.pictures(options_.vtu, "pattern", "patterns.pvd");
  table.whole_states(
      options_.whole, "patterns",
      fmt::format("the first {} and the one with the largest margin", whole_unless_requested));
  describe_limits(table);
  table.file("--trace", options_.trace, Role::output, "timeline of all ranks, for ui.perfetto.dev");
  table.file("--record", options_.record, Role::output,
             "depth and CPU time of each node of a search in one process, from which kusabi bench "
             "scaling --trace predicts the time on many ranks");
  table.file("--certificate", options_.certificate, Role::evidence,
             "certificate file, for kusabi verify");
  table.flag("--exists", options_.parameters.exists,
             "find one pattern, or prove that there is none. Large decoupled subproblems are first "
             "searched without a tree");
  table.prove(prove_, "test every node in exact arithmetic, as kusabi verify does");
  table.quiet_and_serial();
}

void Patterns::describe_tree(OptionTable& table) {
  using wedged::FacetBound;
  // Lower limit: the digits of a double in a margin. Upper limit: larger values would leave nothing
  // to find.
  table.number("--tolerance", &options_.parameters.tree.tolerances.sign, between(1e-12, 1e-3),
               "tolerance of margins: a node with |t*| up to this value is degenerate");
  table.choice(
      "--branching", options_.parameters.tree.branching, branching_words(),
      "branching rule: largest u_n r_n (paper), largest u_n r_n relative to the "
      "compliance (relative), largest decrease of the margins of both children (deepest), "
      "a weighted mean of relative and deepest (weighed), or the rule whose sampled tree is "
      "smallest (auto). The patterns are the same; the number of nodes differs");
  table.choice(
      "--cuts", options_.parameters.tree.tightening, cuts_words(),
      "cuts from bounds of the reaction and the gap of each candidate, computed before the "
      "search and added to every node: for constrained bodies with a large tree (auto), "
      "never (none), or always (always)");
  table.number(
      "--probe", &options_.parameters.tree.probes, between(0, 1000),
      "number of candidates that strong branching compares at each node. Strong branching gives "
      "fewer nodes and a smaller certificate, but takes more time; 8 candidates are "
      "enough");
  table.choice("--method", options_.polyhedral, {{"cones", false}, {"polyhedral", true}},
               "friction cones of the search: second-order cones (cones), or polyhedral cones that "
               "contain them (polyhedral, Algorithm 5.8); the resulting patterns are then tested "
               "with second-order cones");
  Range even_facets = between(FacetBound::minimum, FacetBound::maximum);
  even_facets.even = true;
  table.number("--facets", &options_.facets, even_facets, "number of facets of each cone")
      .needs("--method", "polyhedral");
  table
      .flag("--candidates", options_.list_candidates,
            "list all patterns found with polyhedral cones, each with the result of its test")
      .needs("--method", "polyhedral")
      .varies();
}

// Order, groups and length of the table, and the order of the search.
void Patterns::describe_table(OptionTable& table) {
  table
      .choice("--sort", options_.sort,
              {{"number", PatternSort::number},
               {"margin", PatternSort::margin},
               {"contact", PatternSort::contact},
               {"critical", PatternSort::critical}},
              "order of the table: as found (number), largest margin first (margin), fewest "
              "candidates in contact first (contact), or smallest critical friction coefficient "
              "first (critical), which requires about ten cone programs per pattern")
      .varies();
  table
      .number(
          "--group", &options_.group, between(0, 1000),
          "table with one row per group of patterns. Two patterns are in one group if their "
          "contact sets differ in at most this number of candidates, or if a chain of such pairs "
          "connects them. Groups are also in the result file. Default: no groups, but on a "
          "terminal more than 40 patterns are grouped around those with the largest margins; 0 "
          "lists all")
      .varies();
  table.top(options_.top);
  // Order by the number of decided signs, see SignPatternTree::bound.
  table
      .choice("--order", options_.parameters.search.order,
              {{"depth-first", engine::Order::depth_first},
               {"breadth-first", engine::Order::best_first}},
              "order in which nodes are opened. The patterns are the same; breadth-first requires "
              "more memory")
      .varies();
}

void Patterns::describe_limits(OptionTable& table) {
  table.search_limits(options_.limits);
  table
      .number("--pattern-limit", &options_.limits.solutions, above(0),
              "number of patterns after which the search ends; a few more may be found")
      .stops(engine::Status::solution_limit)
      .varies();
  table.resume(options_.checkpoint);
}

void Patterns::check() const {
  if (options_.lines) {
    table_->check_lines({"--csv", "--vtu", "--whole", "--group", "--exists"});
    if (options_.sort != PatternSort::number) table_->check_lines({"--sort"});
  }
  if (options_.parameters.exists && !options_.certificate.empty()) {
    throw WrongInput(
        "--certificate: --exists writes no certificate; expected --certificate without --exists, "
        "or kusabi critical --certificate");
  }
  if (options_.parameters.exists && options_.sort == PatternSort::critical) {
    throw WrongInput(
        "--sort critical: --exists ends with one pattern; expected --sort critical without "
        "--exists, or kusabi critical");
  }
  if (options_.parameters.tree.probes > 0 && options_.polyhedral)
    throw WrongInput("--probe: requires --method cones");
  const bool one_search_depth_first =
      !options_.parameters.exists && options_.checkpoint.state.empty() &&
      options_.parameters.search.order == engine::Order::depth_first;
  if (!options_.record.empty() && !one_search_depth_first)
    throw WrongInput(
        "--record: is not possible with --exists, --resume or breadth-first order; "
        "expected depth-first order and neither of the others");
}

// Fingerprint of the tree: a checkpoint belongs to a tree, which depends on friction and tolerance.
std::uint64_t Patterns::tree_fingerprint() const {
  support::Fingerprint fingerprint;
  fingerprint.add(contact_.problem.provenance.fingerprint);
  fingerprint.add(options_.friction);
  const auto& tree = options_.parameters.tree;
  fingerprint.add(tree.tolerances.sign);
  fingerprint.add(static_cast<std::uint64_t>(tree.branching));
  if (tree.tightening != wedged::Tightening::automatic)
    fingerprint.add(static_cast<std::uint64_t>(tree.tightening));
  fingerprint.add(static_cast<std::uint64_t>(tree.facets));
  if (tree.probes > 0) fingerprint.add(static_cast<std::uint64_t>(tree.probes));
  if (prove_) fingerprint.add(std::string_view("prove"));
  if (options_.parameters.exists) fingerprint.add(std::string_view("exists"));
  return fingerprint.value();
}

void Patterns::prepare(CommandRun& run) {
  const auto& file = options_.input.file;
  contact_ = contact_problem(run, options_.input, options_.friction);
  friction_ = friction_at(contact_.problem, options_.friction, file);
  if (has_reference_load(contact_.structure)) {
    loaded_ = run.within_limits(
        [&](const auto& work) { return wedged::loaded_problem(contact_.structure, work); });
    if (!loaded_->has_reference) loaded_.reset();
  }
  if (options_.polyhedral && contact_.problem.dimension == 2) {
    throw WrongInput(
        fmt::format("--method polyhedral: {} is a plane problem, whose friction cones are "
                    "polyhedral already; expected --method cones",
                    file));
  }
  auto& parameters = options_.parameters;
  if (options_.polyhedral) parameters.tree.facets = options_.facets;
  parameters.tree.thorough = !options_.certificate.empty();
  parameters.structure = &contact_.structure;
  if (prove_) parameters.proving = wedged::Proving::always;
  auto& search = parameters.search;
  engine::Facts facts{{"the problem", hexadecimal(contact_.problem.provenance.fingerprint)}};
  if (loaded_)
    facts.emplace_back("the loads", hexadecimal(fingerprint_of_loads(contact_.structure)));
  run.keep_state(options_.checkpoint, std::move(facts));
  // If an earlier run has finished, no further evidence is recorded.
  certificate_.emplace(run.session(), run.has_searched() ? std::string() : options_.certificate,
                       file, tree_fingerprint(), run.has_begun_to_search(),
                       options_.checkpoint.state);
  if (certificate_->wanted())
    parameters.recorder = [this](const auto& evidence) { certificate_->add(evidence); };
  if (options_.lines) {
    if (loaded_) {
      unlimited_.emplace(run.session().transport());
      firmness_.emplace(*unlimited_, *loaded_, options_.friction);
    }
    lines_.emplace(run.session(), contact_.problem,
                   PartsOwner{.option = "--output",
                              .name = *table_->find("--output")->given,
                              .content = "the patterns",
                              .tree = tree_fingerprint(),
                              .checkpoint = options_.checkpoint.state},
                   firmness_ ? &*firmness_ : nullptr, run.has_begun_to_search(),
                   run.has_searched());
    parameters.kept = [this](const auto& leaf) { lines_->add(leaf); };
  }
  if (!options_.trace.empty()) search.trace_events = trace_events_per_rank(run.session().ranks());
  if (!options_.record.empty()) record_nodes(run);
  search.warn = warn;
}

void Patterns::record_nodes(CommandRun& run) {
  if (run.session().ranks() > 1) {
    throw WrongInput(
        fmt::format("--record: the search has {} ranks; expected --serial", run.session().ranks()));
  }
  options_.parameters.search.record = [this](std::size_t depth, double seconds) {
    engine::write_node_record(node_records_, depth, seconds);
  };
}

std::string Patterns::announcement(const std::string& ranks) const {
  return fmt::format("{}; {}; {}", problem_line(contact_.problem),
                     friction_text(contact_.problem, options_.friction), ranks);
}

void Patterns::search(CommandRun& run) {
  auto analysis_options = run.analysis_options(options_.limits);
  if (analysis_options.watch && !options_.lines && !options_.parameters.exists)
    report_memory(analysis_options);
  engine::Analysis analysis(run.session().transport(), std::move(analysis_options));
  findings_ = wedged::find_patterns(analysis, contact_.problem, friction_, options_.parameters);
  if (certificate_->wanted()) certificate_->close();
  if (lines_) lines_->close(*findings_);
  const bool sorted = options_.sort == PatternSort::critical;
  const bool searched =
      (sorted || (loaded_ && !lines_)) && run.session().from_first_rank([&] { return whole(); });
  if (!searched) return;
  if (sorted)
    numbers_.brackets =
        wedged::pattern_brackets(analysis, contact_.problem, findings_->leaves, options_.friction);
  if (loaded_ && !lines_)
    numbers_.firmness =
        wedged::firmness_of_patterns(analysis, *loaded_, options_.friction, findings_->leaves);
}

std::string Patterns::header() const {
  return certificate_header(contact_.problem, friction_, list_theorems(contact_.problem),
                            findings_->bounds);
}

void Patterns::end_certificate() {
  if (!certificate_->wanted() && !options_.certificate.empty()) {
    put_earlier_certificate_in_place(options_.certificate, options_.input.file, tree_fingerprint(),
                                     header());
  }
  if (!certificate_->wanted()) return;
  if (whole()) {
    certificate_->put_in_place(header());
  } else if (can_resume_) {
    certificate_->require_parts();
  }
}

std::string Patterns::certificate_remark() const {
  if (whole()) return fmt::format("wrote {}", options_.certificate);
  if (can_resume_) return fmt::format("the evidence so far is in {}.part.*", options_.certificate);
  return "no certificate was written, since the search ended early; --resume keeps its parts";
}

void Patterns::draw(OutputFolder& folder, const WholeStates& states) const {
  const ConfigurationGrids grids(states);
  const auto& leaves = findings_->leaves;
  const auto count = std::min(leaves.size(), longest_series);
  VtuSeries series(folder);
  for (std::size_t i = 0; i < count; ++i) {
    const auto& leaf = leaves[i];
    series.add(numbered_vtu("pattern", i + 1, count),
               grids.grid({fmt::format("pattern {} at {}", i + 1,
                                       friction_text(contact_.problem, options_.friction)),
                           options_.friction, leaf.lower},
                          leaf.block, leaf.pattern, findings_->inactive(), leaf.reaction,
                          leaf.displacement));
  }
  series.finish("patterns.pvd", problem_line(contact_.problem));
}

nlohmann::ordered_json Patterns::head(const CommandRun& run) const {
  return run.head(problem_json(contact_.structure, contact_.problem, options_.input.file));
}

Step Patterns::result_lines(CommandRun& run) {
  return run.result_lines(
      [this, head = head(run)](std::ostream& out) {
        return lines_->write(out, report().head_line(head), *findings_);
      },
      [this] { lines_->end(can_resume_ && !whole()); });
}

std::vector<Step> Patterns::results(CommandRun& run) {
  const auto report = std::make_shared<const PatternsReport>(this->report());
  can_resume_ = !options_.checkpoint.state.empty();
  const auto states = std::make_shared<const WholeStates>(contact_.structure, contact_.problem);
  return {lines_ ? result_lines(run) : run.result([this, report, states, &run](JsonWriter& json) {
            report->write(json, head(run), WholeStateJson(*states));
          }),
          run.file("--csv", [report](std::ostream& out) { report->write_csv(out); }),
          run.folder("--vtu", [this, states](auto& folder) { draw(folder, *states); }),
          run.file("--trace", [this](auto& out) { write_trace(out, findings_->outcome.traces); }),
          run.file("--record",
                   [this](auto& out) {
                     out << engine::node_record_header << node_records_.str();
                     if (!whole()) out << engine::incomplete_record << '\n';
                   }),
          [this] { end_certificate(); },
          run.answer([report] { return report->table(); })};
}

PatternsReport Patterns::report() const {
  return {options_, contact_.problem,   *findings_,
          numbers_, CommandRun::page(), lines_ ? &lines_->numbers() : nullptr};
}

answer::Verdict Patterns::verdict() const {
  return report().verdict();
}

double Patterns::seconds_to_write(std::uint64_t solutions) const {
  if (options_.lines) return seconds_per_written_line * static_cast<double>(solutions);
  return Subcommand::seconds_to_write(solutions);
}

std::vector<std::string> Patterns::remarks(CommandRun& run) {
  std::vector<std::string> remarks;
  const auto drawn = series_remark(findings_->leaves.size(), "patterns");
  if (run.wants("--vtu") && !drawn.empty()) remarks.push_back(drawn);
  if (!options_.record.empty() && !whole())
    remarks.push_back(options_.record + " has the nodes opened before the early end only");
  if (!options_.certificate.empty() && !(whole() && run.quiet())) {
    remarks.push_back(certificate_remark());
  }
  return remarks;
}

}  // namespace

constexpr Registration patterns_subcommand{
    {.name = "patterns",
     .chapter = "Wedged configurations",
     .purpose = "all sign patterns of wedged configurations",
     .description =
         "All combinations of contact and separation (sign patterns) for which the structure "
         "sticks, with one wedged configuration of each. The list is complete up to rounding "
         "errors; a certificate (--certificate) and kusabi verify prove it.",
     .example = "examples/space-truss.toml --mu 0.65",
     .progress = ProgressLines::solutions},
    make<Patterns>};

}  // namespace kusabi::run
