// From the file to the report, on all ranks.
#include "run/limit/limit.hpp"

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "engine/together.hpp"
#include "nodes/limit/limit_loads.hpp"
#include "problems/files/problem_text.hpp"
#include "problems/files/structure_file.hpp"
#include "problems/limit/limit_problem.hpp"
#include "run/command/command_run.hpp"
#include "run/limit/curve_load.hpp"
#include "run/limit/curve_report.hpp"
#include "run/limit/limit_pictures.hpp"
#include "run/limit/limit_report.hpp"
#include "run/limit/members_csv.hpp"
#include "run/output/standard_output.hpp"
#include "run/output/values.hpp"
#include "run/output/wrong_input.hpp"
#include "run/session/progress_text.hpp"
#include "run/session/restart.hpp"
#include "support/fingerprint.hpp"
#include "verify/limit_certificate.hpp"

namespace kusabi::run {
namespace {

class Limit final : public Subcommand {
 public:
  [[nodiscard]] std::string_view name() const override { return "limit"; }
  [[nodiscard]] std::string_view purpose() const override {
    return "the worst-case limit load of a truss";
  }
  [[nodiscard]] std::string_view description() const override {
    return "The load factor at which a truss collapses, and its worst case under loads that are "
           "not known "
           "exactly.";
  }
  [[nodiscard]] std::string_view example() const override {
    return "examples/paper/limit-3x3.toml --alpha 40";
  }
  [[nodiscard]] std::string notes() const override { return progress_explained(true); }
  void describe(OptionTable& table) override;
  void check() const override;
  void read(CommandRun& run) override;
  void prepare(CommandRun& run) override;
  [[nodiscard]] std::string announcement(const std::string& ranks) const override;
  void search(CommandRun& run) override;
  std::vector<Step> results(CommandRun& run) override;
  Verdict verdict(CommandRun& run) override;

 private:
  [[nodiscard]] const char* why_no_certificate() const;

  LimitOptions options_;
  std::string certificate_;
  std::string curve_csv_;
  std::string vtu_;
  problems::ProblemText text_;
  std::string load_text_;
  problems::Structure truss_;
  std::optional<problems::LimitProblem> problem_;
  limit::LimitFindings found_;
};

void Limit::describe(OptionTable& table) {
  constexpr double most_samples = 1e8;
  table.file("file", options_.file, Role::input, "the problem, a TOML file").required();
  table
      .number("--alpha", &options_.question.alpha, at_least(0),
              "the uncertain parts of the dead load are known up to +- this")
      .unit("in the file's unit of force");
  table
      .choice("--cuts", options_.question.method,
              {{"none", limit::LimitMethod::fixed},
               {"disjunctive", limit::LimitMethod::disjunctive},
               {"tighten", limit::LimitMethod::tightened},
               {"static", limit::LimitMethod::static_cuts},
               {"all", limit::LimitMethod::all}},
              "how the worst case is found: by static cuts, or by the 0-1 program (29) with none, "
              "disjunctive ones (the paper's method), a tightened M, or all of these. With none or "
              "disjunctive and --big-m: as printed in the paper")
      .needs("--alpha");
  table
      .number("--big-m", &options_.question.big_m, above(0),
              "M of (29), where motions have f_R'u = 1 in the unit of force; 5 in the paper. "
              "Without it a safe one is derived")
      .needs("--cuts");
  table
      .number(
          "--samples", &options_.question.samples, between(1, most_samples),
          "compare with so many random dead loads; --cuts none and disjunctive start from the best")
      .needs("--alpha");
  table.number("--seed", &options_.question.seed, at_least(0), "of the random dead loads");
  table
      .flag("--curve", options_.question.curve,
            "how the load factor falls as the critical load, or alpha, grows from zero")
      .needs("--alpha");
  table.file("--curve-load", options_.curve_load, Role::input,
             "how it falls as the load in this file grows: [[loads]] of nodes and force, or an "
             "earlier result, of which it is the critical part");
  table.number("--curve-to", &options_.question.curve_to, between(1e-9, 1e9),
               "how far curves go, in multiples of that load or of alpha");
  table.file("--curve-csv", curve_csv_, Role::output,
             "write the curves to this file, a line a breakpoint");
  table.time_limit(options_.limits);
  table.node_limit(options_.limits);
  table.resume(options_.checkpoint);
  table.save_on(options_.checkpoint);
  table.output();
  table.output("--csv", "write the members to this file, a line each: forces, utilisation, yield");
  table
      .file("--vtu", vtu_, Role::folder,
            "write pictures of the collapse, nominal and in the worst case, to this folder, for "
            "ParaView: limit.pvd opens them")
      .ends_in({"/limit.pvd"});
  table
      .file("--certificate", certificate_, Role::output,
            "write the evidence to this file, for kusabi verify")
      .needs("--alpha")
      .matters();
  table.quiet();
  table.serial();
}

void Limit::check() const {
  if (options_.question.curve || !options_.curve_load.empty()) return;
  if (!curve_csv_.empty()) {
    throw WrongInput("--curve-csv: no curve is asked for; expected --curve or --curve-load, too");
  }
  if (options_.question.curve_to != limit::LimitQuestion{}.curve_to) {
    throw WrongInput("--curve-to: no curve is asked for; expected --curve or --curve-load, too");
  }
}

void Limit::read(CommandRun& run) {
  text_ = run.session().from_first_rank([&] { return problems::problem_text(options_.file); });
  if (options_.curve_load.empty()) return;
  load_text_ = run.session().from_first_rank(
      [&] { return problems::file_text(options_.curve_load, "a result file in JSON"); });
}

void Limit::prepare(CommandRun& run) {
  // Every rank works the problem out by itself: the same text gives the same bits everywhere.
  truss_ = problems::read_structure(text_, options_.file);
  warn_all(run.session(), truss_.warnings);
  problem_ = problems::limit_problem(truss_);
  engine::agree(run.session().transport(), problem_->fingerprint);
  if (!options_.curve_load.empty()) {
    options_.question.curve_load = curve_load(load_text_, options_.curve_load, *problem_);
  }
  engine::Facts facts{{"the problem", hexadecimal(problem_->fingerprint)}};
  if (!options_.curve_load.empty()) {
    support::Fingerprint load;
    load.add(load_text_);
    facts.emplace_back("--curve-load", hexadecimal(load.value()));
  }
  run.keep_state(options_.checkpoint, std::move(facts));
}

std::string Limit::announcement(const std::string& ranks) const {
  return fmt::format("{}: {}, {} nodes, {} members, {} free displacements; {}", problem_->name,
                     problem_->dimension == 2 ? "in the plane" : "in space",
                     problem_->node_names.size(), problem_->member_count(), problem_->free_count(),
                     ranks);
}

void Limit::search(CommandRun& run) {
  options_.question.evidence = !certificate_.empty();
  engine::Campaign campaign(run.session().transport(), run.supervision(options_.limits));
  try {
    found_ = limit::limit_loads(campaign, truss_, *problem_, options_.question);
  } catch (const limit::BigMTooSmall&) {
    throw WrongInput(
        "--cuts: (29) has no point, its M is too small; expected a larger --big-m, or none");
  }
  if (run.shows() && found_.answer.worst && found_.answer.worst->no_safe_m) {
    tell(
        "--cuts: no safe M was found, and (29) was not tried; the ends are those of static "
        "cuts\n");
  }
}

std::vector<Step> Limit::results(CommandRun& run) {
  const auto report = std::make_shared<const LimitReport>(
      LimitReport{options_, truss_, *problem_, found_.answer, run.session().ranks()});
  std::vector<Step> steps{run.result([report] { return report->json(); })};
  steps.push_back(
      run.file("--csv", [report](std::ostream& out) { write_members_csv(out, *report); }));
  steps.push_back(run.file("--curve-csv", [report](std::ostream& out) {
    CurveReport{report->options, report->problem, report->answer}.write_csv(out);
  }));
  steps.push_back(run.folder("--vtu", [report](auto& folder) { draw_collapses(folder, *report); }));
  if (found_.certificate) {
    steps.push_back(run.file("--certificate", [this](std::ostream& out) {
      out << limit_certificate_text(*found_.certificate);
    }));
  }
  steps.push_back(run.answer([report] { return report->table(CommandRun::page()); }));
  return steps;
}

const char* Limit::why_no_certificate() const {
  const auto& worst = found_.answer.worst;
  if (!worst) return "it would be of a worst case; expected --alpha";
  if (worst->as_printed) return "the search was stopped before the two ends were proved";
  return worst->status == limit::RootStatus::not_carried
             ? "they hold load factors, and here a load is carried at none"
             : "the two ends are not proved";
}

Verdict Limit::verdict(CommandRun& run) {
  Verdict verdict{.remarks = {}, .code = found_.answer.whole() ? solved : stopped_early};
  if (run.wants("--certificate") && !found_.certificate) {
    verdict.code = stopped_early;
    if (!run.quiet()) {
      verdict.remarks.push_back(
          fmt::format("no certificate ({} is as it was): {}", certificate_, why_no_certificate()));
    }
  }
  const auto& worst = found_.answer.worst;
  const auto stopped =
      worst && worst->search != engine::Status::solved ? worst->search : found_.answer.rest;
  if (stopped != engine::Status::solved)
    verdict.remarks = run.how_to_go_on(options_.checkpoint, stopped, false);
  const bool whole_tree = worst && worst->as_printed && worst->search == engine::Status::solved;
  if (whole_tree && !worst->proved && !run.quiet()) {
    verdict.remarks.emplace_back(
        "not proved: the ends of (29) are those of the worst case if its M is large enough; "
        "--certificate FILE has them proved by static cuts");
  }
  return verdict;
}

}  // namespace

std::unique_ptr<Subcommand> limit_subcommand() {
  return std::make_unique<Limit>();
}

}  // namespace kusabi::run
