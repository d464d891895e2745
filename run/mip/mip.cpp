// `kusabi mip`: options, stages and results, on all ranks.
#include "run/mip/mip.hpp"

#include <algorithm>
#include <memory>
#include <optional>
#include <vector>

#include <fmt/format.h>

#include "answer/values.hpp"
#include "engine/analysis/analysis.hpp"
#include "nodes/zero_one/mixed_search.hpp"
#include "run/command/command_run.hpp"
#include "run/command/registrations.hpp"
#include "run/mip/mip_report.hpp"
#include "run/output/values.hpp"
#include "run/session/kept_state.hpp"
#include "solvers/linear/program_file.hpp"
#include "support/fingerprint.hpp"

namespace kusabi::run {
namespace {

using linear::ProgramFile;

std::uint64_t program_fingerprint(const ProgramFile& file) {
  const auto& [name, constant, columns, rows, entries] = file.mixed.program;
  support::Fingerprint fingerprint;
  fingerprint.add(constant);
  for (const auto& column : columns) {
    fingerprint.add(column.cost);
    fingerprint.add(column.lower);
    fingerprint.add(column.upper);
  }
  for (const auto& row : rows) {
    fingerprint.add(row.lower);
    fingerprint.add(row.upper);
  }
  for (const auto& [row, column, value] : entries) {
    fingerprint.add(row);
    fingerprint.add(column);
    fingerprint.add(value);
  }
  for (const int column : file.mixed.binaries) fingerprint.add(column);
  return fingerprint.value();
}

class Mip final : public Subcommand {
 public:
  void describe(OptionTable& table) override;
  void read(CommandRun& run) override;
  void prepare(CommandRun& run) override;
  [[nodiscard]] std::string announcement(const std::string& ranks) const override;
  void search(CommandRun& run) override;
  std::vector<Step> results(CommandRun& run) override;
  [[nodiscard]] answer::Verdict verdict() const override;

 private:
  MipOptions options_;
  std::optional<engine::Analysis> analysis_;
  ProgramFile program_;
  std::uint64_t fingerprint_ = 0;
  engine::Options search_options_;
  std::optional<zero_one::MixedAnswer> found_;
};

void Mip::describe(OptionTable& table) {
  using engine::Order;
  table.file("file", options_.file, Role::input, "program file, MPS (.mps) or CPLEX LP (.lp)")
      .required();
  table.choice("--cuts", options_.cuts, root_cuts_words(), "kind of cuts at the root");
  table.choice("--branching", options_.branching, zero_one_branching_words(),
               "branching rule: largest tau (1 - tau), as in the paper, or largest gain of the "
               "children's bounds (fewer nodes, each of higher cost); the optimum is the same");
  table.choice("--order", options_.order,
               {{"depth-first", Order::depth_first},
                {"best-first", Order::best_first},
                {"hybrid", Order::hybrid}},
               "order in which nodes are opened; the optimum is the same");
  table.flag("--no-tighten", options_.tighten, "do not tighten the coefficients M", false);
  table.flag("--no-dive", options_.dive, "omit the dive for a first point before the search",
             false);
  table.output();
  table.further_output("--csv", "CSV file of the best point, one row per nonzero column");
  table.search_limits(options_.limits);
  table
      .number("--gap", &options_.limits.gap, above(0),
              "relative difference of objective and bound at which the search stops")
      .stops(engine::Status::gap_limit)
      .varies();
  table.resume(options_.checkpoint);
  table.former_names_of_resume();
  table.save_on(options_.checkpoint);
  table.quiet_and_serial();
}

void Mip::read(CommandRun& run) {
  program_ = run.session().from_first_rank([&] { return linear::read_program(options_.file); });
}

void Mip::prepare(CommandRun& run) {
  fingerprint_ = program_fingerprint(program_);
  search_options_.order = options_.order;
  run.keep_state(options_.checkpoint, {{"the program", hexadecimal(fingerprint_)}});
  analysis_.emplace(run.session().transport(), run.analysis_options(options_.limits));
  search_options_.warn = warn;
  warn_all(run.session(), program_.warnings);
}

std::string Mip::announcement(const std::string& ranks) const {
  const auto& [name, constant, columns, rows, entries] = program_.mixed.program;
  return fmt::format("{}: {}, {}, {} of them binary, {}; {}; {}",
                     name.empty() ? "unnamed program" : name, answer::counted(rows.size(), "row"),
                     answer::counted(columns.size(), "column"), program_.mixed.binaries.size(),
                     entries.size() == 1 ? "1 entry" : fmt::format("{} entries", entries.size()),
                     program_.maximise ? "maximise" : "minimise", ranks);
}

void Mip::search(CommandRun& /*run*/) {
  found_ = zero_one::solve_mixed(
      *analysis_, program_.mixed,
      {.cuts = options_.cuts, .tighten = options_.tighten, .dive = options_.dive},
      options_.branching, search_options_, {program_.maximise ? -1.0 : 1.0});
}

std::vector<Step> Mip::results(CommandRun& run) {
  const auto report =
      std::make_shared<const MipReport>(MipReport{options_, program_, fingerprint_, *found_});
  return {run.result([report] { return report->json(); }),
          run.file("--csv", [report](std::ostream& out) { report->write_csv(out); }),
          run.answer([report] { return report->table(CommandRun::page()); })};
}

answer::Verdict Mip::verdict() const {
  return MipReport{options_, program_, fingerprint_, *found_}.verdict();
}

}  // namespace

constexpr Registration mip_subcommand{
    {.name = "mip",
     .chapter = "Mixed zero-one programs",
     .purpose = "optimum of a mixed zero-one linear program",
     .description = "The optimum of a mixed zero-one linear program, with a bound that proves it.",
     .example = "tests/programs/assignment.mps",
     .progress = ProgressLines::bounds},
    make<Mip>};

}  // namespace kusabi::run
