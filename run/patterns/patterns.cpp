// `kusabi patterns`: stages and results, on all ranks.
#include "run/patterns/patterns.hpp"

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
#include "nodes/wedged/sweep/pattern_brackets.hpp"
#include "problems/structure/model/load_cases.hpp"
#include "run/command/command_run.hpp"
#include "run/command/registrations.hpp"
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
#include "run/wedged/configuration_grid.hpp"
#include "run/wedged/contact_problem.hpp"
#include "run/wedged/problem_summary.hpp"
#include "run/wedged/whole_state_json.hpp"
#include "support/fingerprint.hpp"

namespace kusabi::run {
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
  void describe(OptionTable& table) override {
    table_ = &table;
    options_.describe(table);
  }
  void check() const override { options_.check(*table_); }
  void read(CommandRun& run) override { options_.input.read(run); }
  void prepare(CommandRun& run) override;
  [[nodiscard]] std::string announcement(const std::string& ranks) const override;
  void search(CommandRun& run) override;
  std::vector<Step> results(CommandRun& run) override;
  [[nodiscard]] answer::Verdict verdict() const override;
  [[nodiscard]] double seconds_to_write(std::uint64_t solutions) const override;
  std::vector<std::string> remarks(CommandRun& run) override;

 private:
  [[nodiscard]] std::uint64_t tree_fingerprint() const;
  [[nodiscard]] bool whole() const { return findings_->whole(); }
  void record_nodes(CommandRun& run);
  Step result_lines(CommandRun& run);
  [[nodiscard]] PatternsReport report() const;
  void end_certificate();
  void draw(OutputFolder& folder, const WholeStates& states) const;
  [[nodiscard]] std::string certificate_remark() const;

  const OptionTable* table_ = nullptr;
  PatternsOptions options_;
  std::ostringstream node_records_;
  ContactProblem contact_;
  std::vector<double> friction_;
  wedged::PatternParameters parameters_;
  std::optional<CertificateFile> certificate_;
  std::optional<PatternLines> lines_;
  std::optional<wedged::PatternFindings> findings_;
  PatternNumbers numbers_;                       // on rank 0
  std::optional<wedged::LoadedProblem> loaded_;  // if the file has a reference load
  std::optional<engine::Analysis> unlimited_;    // of the firmness of lines
  std::optional<wedged::PatternFirmness> firmness_;
  bool can_resume_ = false;  // a state is kept from which the search can be resumed
};

// Fingerprint of the tree: a checkpoint belongs to a tree, which depends on friction and tolerance.
std::uint64_t Patterns::tree_fingerprint() const {
  support::Fingerprint fingerprint;
  fingerprint.add(contact_.problem.provenance.fingerprint);
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
  parameters_.tree = {.tolerances = {.sign = options_.tolerance},
                      .branching = options_.branching,
                      .tightening = options_.tightening,
                      .probes = options_.probes,
                      .facets = options_.facets_in_use(),
                      .thorough = !options_.certificate.empty()};
  parameters_.structure = &contact_.structure;
  if (options_.prove) parameters_.proving = wedged::Proving::always;
  parameters_.exists = options_.exists;
  auto& search = parameters_.search;
  search.order = options_.order;
  engine::Facts facts{{"the problem", hexadecimal(contact_.problem.provenance.fingerprint)}};
  if (loaded_)
    facts.emplace_back("the loads", hexadecimal(fingerprint_of_loads(contact_.structure)));
  run.keep_state(options_.checkpoint, std::move(facts));
  // If an earlier run has finished, no further evidence is recorded.
  certificate_.emplace(run.session(), run.has_searched() ? std::string() : options_.certificate,
                       file, tree_fingerprint(), run.has_begun_to_search(),
                       options_.checkpoint.state);
  if (certificate_->wanted())
    parameters_.recorder = [this](const auto& evidence) { certificate_->add(evidence); };
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
    parameters_.kept = [this](const auto& leaf) { lines_->add(leaf); };
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
  parameters_.search.record = [this](std::size_t depth, double seconds) {
    engine::write_node_record(node_records_, depth, seconds);
  };
}

std::string Patterns::announcement(const std::string& ranks) const {
  return fmt::format("{}; friction coefficient {}; {}", problem_line(contact_.problem),
                     friction_text(contact_.problem, options_.friction), ranks);
}

void Patterns::search(CommandRun& run) {
  auto analysis_options = run.analysis_options(options_.limits);
  if (analysis_options.watch && !options_.lines && !options_.exists)
    report_memory(analysis_options);
  engine::Analysis analysis(run.session().transport(), std::move(analysis_options));
  findings_ = wedged::find_patterns(analysis, contact_.problem, friction_, parameters_);
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

void Patterns::end_certificate() {
  if (!certificate_->wanted() && !options_.certificate.empty()) {
    put_earlier_certificate_in_place(
        options_.certificate, options_.input.file, tree_fingerprint(),
        certificate_header(contact_.problem, friction_, findings_->bounds));
  }
  if (!certificate_->wanted()) return;
  if (whole()) {
    certificate_->put_in_place(certificate_header(contact_.problem, friction_, findings_->bounds));
  } else if (can_resume_) {
    certificate_->require_parts();
  }
}

std::string Patterns::certificate_remark() const {
  if (whole()) return fmt::format("wrote {}", options_.certificate);
  if (can_resume_) return fmt::format("the proofs so far are in {}.part.*", options_.certificate);
  return "no certificate was written, since the search ended early; --resume keeps its parts";
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
                   leaf.block, leaf.pattern, findings_->inactive(), leaf.reaction,
                   leaf.displacement));
  }
  series.finish("patterns.pvd", problem_line(contact_.problem));
}

Step Patterns::result_lines(CommandRun& run) {
  return run.result_lines(
      [this](std::ostream& out) {
        return lines_->write(out, report().head_line(contact_.structure), *findings_);
      },
      [this] { lines_->end(can_resume_ && !whole()); });
}

std::vector<Step> Patterns::results(CommandRun& run) {
  const auto report = std::make_shared<const PatternsReport>(this->report());
  can_resume_ = !options_.checkpoint.state.empty();
  const auto states = std::make_shared<const WholeStates>(contact_.structure, contact_.problem);
  return {lines_ ? result_lines(run) : run.result([report, states](JsonWriter& json) {
            report->write(json, WholeStateJson(*states));
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
