// `kusabi critical`: options, stages and results, on all ranks.
#include "run/critical/critical.hpp"

#include <algorithm>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "nodes/wedged/critical/bound_record.hpp"
#include "nodes/wedged/critical_search.hpp"
#include "problems/wedged/wedged_problem.hpp"
#include "run/command/command_run.hpp"
#include "run/command/subcommand.hpp"
#include "run/evidence/certificate_file.hpp"
#include "run/output/standard_output.hpp"
#include "run/output/wrong_input.hpp"
#include "run/pictures/vtu_series.hpp"
#include "run/session/session.hpp"
#include "run/wedged/configuration_files.hpp"
#include "run/wedged/contact_problem.hpp"
#include "run/wedged/problem_summary.hpp"
#include "support/fingerprint.hpp"

namespace kusabi::run {
namespace {

/// Certificates of both bounds, NAME.lower and NAME.upper.
struct BoundCertificates {
  std::string name;    ///< without its ending; empty: none is written
  std::string input;   ///< problem file
  bool quiet = false;  ///< file names are not printed
};

/// True for the bounds whose certificates exist.
struct WrittenCertificates {
  bool lower = false;
  bool upper = false;
};

class BoundCertificate final : public wedged::BoundRecord {
 public:
  BoundCertificate(Session& session, const BoundCertificates& certificates, const std::string& name,
                   std::uint64_t tree, const problems::WedgedProblem& problem,
                   std::span<const double> friction, bool& written)
      : session_(session),
        written_(written),
        quiet_(certificates.quiet),
        name_(name),
        problem_(problem),
        friction_(friction.begin(), friction.end()),
        file_(session, name, certificates.input, tree, false) {}

  void add(const wedged::Evidence& evidence) override { file_.add(evidence); }

  void end(std::span<const wedged::ProvedBound> bounds, wedged::BoundClaim claim,
           bool holds) override {
    file_.close();
    written_ = holds;
    if (!session_.is_first()) return;
    if (holds) {
      const bool one = claim == wedged::BoundClaim::one_pattern;
      file_.put_in_place(certificate_header(
          problem_, friction_, one ? std::vector<std::string>() : list_theorems(problem_),
          one ? std::span<const wedged::ProvedBound>() : bounds));
      if (!quiet_) print_written({name_});
    }
  }

 private:
  Session& session_;
  bool& written_;
  bool quiet_;
  std::string name_;
  const problems::WedgedProblem& problem_;
  std::vector<double> friction_;
  CertificateFile file_;
};

// Recorder of both bounds. Session, problem and `written` must outlive it.
wedged::BoundRecorder bound_recorder(Session& session, BoundCertificates certificates,
                                     const problems::WedgedProblem& problem,
                                     WrittenCertificates& written) {
  if (certificates.name.empty()) return {};
  return [&session, &problem, &written, certificates = std::move(certificates)](
             wedged::BracketSide side, double factor,
             std::span<const double> friction) -> std::unique_ptr<wedged::BoundRecord> {
    support::Fingerprint fingerprint;
    fingerprint.add(problem.provenance.fingerprint);
    fingerprint.add(factor);
    const bool lower = side == wedged::BracketSide::lower;
    return std::make_unique<BoundCertificate>(
        session, certificates, certificates.name + (lower ? ".lower" : ".upper"),
        fingerprint.value(), problem, friction, lower ? written.lower : written.upper);
  };
}

class Critical final : public Subcommand {
 public:
  void describe(OptionTable& table) override;
  void check() const override;
  void read(CommandRun& run) override { options_.input.read(run); }
  void prepare(CommandRun& run) override;
  [[nodiscard]] std::string announcement(const std::string& ranks) const override;
  void search(CommandRun& run) override;
  std::vector<Step> results(CommandRun& run) override;
  [[nodiscard]] answer::Verdict verdict() const override;

 private:
  void draw(OutputFolder& folder, const WholeStates& states) const;

  OptionTable* table_ = nullptr;
  CriticalOptions options_;
  std::string vtu_;
  ContactProblem contact_;
  wedged::CriticalGrid grid_;
  wedged::CriticalFindings findings_;
};

void Critical::describe(OptionTable& table) {
  using Strategy = wedged::CriticalStrategy;
  table_ = &table;
  table.problem(options_.input.file);
  table.choice(
      "--method", options_.parameters.strategy,
      {{"auto", Strategy::automatic},
       {"descent", Strategy::descent},
       {"global", Strategy::global},
       {"newton", Strategy::newton},
       {"bisection", Strategy::bisection}},

      "for the smallest coefficient: search from --mu-max downwards (descent), one search over all "
      "coefficients from zero (global), or both in turn (auto). For the coefficients of all "
      "patterns "
      "that stick at --mu-max: Newton's method (newton), or bisection (Algorithm 6.1)");
  table.number("--mu-max", &options_.parameters.maximum, above(0),
               "largest friction coefficient of the search");
  table.number("--width", &options_.parameters.width, above(0),
               "width of the bracket of each coefficient. Default: 1e-8; with more than 100 "
               "candidates 1e-6, since their cone programs are solved in double precision only");
  table.choice(
      "--cuts", options_.parameters.tightening, cuts_words(),
      "cuts from bounds of the reaction and the gap of each candidate, added to every node: "
      "for large constrained bodies (auto), never (none), or always (always)");
  table.flag(
      "--list", options_.parameters.list,
      "list all patterns that stick at the upper bound, in addition to the one that proves it");
  table
      .number("--list-nodes", &options_.parameters.list_nodes, above(0),
              "maximum number of nodes that are opened for --list")
      .needs("--list");
  table.top(options_.top, ", smallest coefficients first");
  table.output();
  table.csv_of("patterns");
  table.pictures(vtu_, "listed pattern", "critical.pvd");
  table
      .file("--certificate", options_.certificate, Role::evidence,
            "certificates of both bounds, NAME.lower and NAME.upper, for kusabi verify")
      .ends_in({".lower", ".upper"});
  table.whole_states(options_.whole, "patterns",
                     fmt::format("the first {}", whole_unless_requested));
  table.search_limits(options_.limits);
  table.resume(options_.checkpoint, ". With --certificate both bounds are proved again");
  table.save_on(options_.checkpoint);
  table.quiet_and_serial();
}

void Critical::check() const {
  if (!finds_smallest_only(options_.parameters.strategy) && !options_.parameters.maximum) {
    throw WrongInput(
        "--mu-max is missing; expected the friction coefficient of the list of patterns, or "
        "--method auto");
  }
  if (!finds_smallest_only(options_.parameters.strategy) && !vtu_.empty()) {
    throw WrongInput(
        "--vtu: this method stores no configurations; expected --method auto, descent or global");
  }
  if (!finds_smallest_only(options_.parameters.strategy) && options_.parameters.list) {
    throw WrongInput(
        "--list: this method lists all patterns that stick at --mu-max; expected --method auto, "
        "descent or global");
  }
  const double maximum = options_.parameters.maximum.value_or(wedged::default_max_friction);
  const double width = options_.parameters.width.value_or(wedged::default_width);
  if (width >= maximum || maximum > wedged::max_multiples * width) {
    throw WrongInput(fmt::format("--width {}: expected a number below --mu-max {} and above {}",
                                 width, maximum, maximum / wedged::max_multiples));
  }
}

void Critical::prepare(CommandRun& run) {
  contact_ = contact_problem(run, options_.input);
  if (options_.parameters.maximum)
    friction_at(contact_.problem, *options_.parameters.maximum, options_.input.file);
  keep_state(run, options_.checkpoint, contact_.problem);
  grid_ = wedged::grid_of(contact_.problem, options_.parameters);
  table_->use_default("--mu-max", grid_.maximum);
  table_->use_default("--width", grid_.width);
}

std::string Critical::announcement(const std::string& ranks) const {
  return fmt::format("{}; up to {}; {}", problem_line(contact_.problem),
                     friction_text(contact_.problem, grid_.maximum), ranks);
}

void Critical::search(CommandRun& run) {
  engine::Analysis analysis(run.session().transport(), run.analysis_options(options_.limits));
  WrittenCertificates written;
  findings_ = wedged::find_critical_friction(
      analysis, contact_.structure, contact_.problem, options_.parameters,
      bound_recorder(run.session(), {options_.certificate, options_.input.file, run.quiet()},
                     contact_.problem, written));
  findings_.lower_recorded = written.lower;
  findings_.upper_recorded = written.upper;
  if (!run.session().is_first()) return;
  const auto& [lower, upper] = findings_.bracket;
  warn_of_facets(run, options_.input, contact_.facets, (upper ? upper : lower)->value);
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
        grids.grid({fmt::format("configuration that becomes feasible at {}",
                                friction_text(contact_.problem, entry.upper.value_or(entry.lower))),
                    entry.upper.value_or(entry.lower)},
                   entry.block, entry.pattern, {}, entry.reaction, entry.displacement));
  }
  series.finish("critical.pvd", problem_line(contact_.problem));
}

std::vector<Step> Critical::results(CommandRun& run) {
  const auto states = std::make_shared<const WholeStates>(contact_.structure, contact_.problem);
  return {
      run.result([this, states, &run] {
        return run.result_json(
            problem_json(contact_.structure, contact_.problem, options_.input.file),
            critical_json(options_, contact_.problem, findings_, WholeStateJson(*states)),
            critical_statistics(findings_));
      }),
      run.file("--csv",
               [this](std::ostream& out) { write_critical_csv(out, contact_.problem, findings_); }),
      run.folder("--vtu", [this, states](auto& folder) { draw(folder, *states); }),
      run.answer([this] {
        return critical_table(options_, contact_.problem, grid_, findings_, CommandRun::page());
      })};
}

answer::Verdict Critical::verdict() const {
  return critical_verdict(options_, contact_.problem, grid_, findings_);
}

}  // namespace

constexpr Registration critical_subcommand{
    {.name = "critical",
     .chapter = "Wedged configurations",
     .purpose = "smallest friction coefficient with a wedged configuration",
     .description =
         "The smallest friction coefficient at which the structure can stick, with a proved "
         "lower and upper bound.",
     .example = "examples/wedge-in-groove.toml",
     .progress = ProgressLines::bounds},
    make<Critical>};

}  // namespace kusabi::run
