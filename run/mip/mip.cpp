// `kusabi mip FILE`: optimum of a mixed zero-one linear program and its proved bound (Algorithms
// 4.2 and 5.1 of the limit paper).
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <memory>
#include <optional>
#include <ostream>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "answer/values.hpp"
#include "answer/verdict.hpp"
#include "engine/analysis/analysis.hpp"
#include "engine/options.hpp"
#include "nodes/zero_one/mixed_search.hpp"
#include "run/command/command_run.hpp"
#include "run/command/subcommand.hpp"
#include "run/output/csv.hpp"
#include "run/output/rank_table.hpp"
#include "run/output/terminal_page.hpp"
#include "run/output/values.hpp"
#include "run/session/kept_state.hpp"
#include "solvers/linear/program_file.hpp"
#include "support/fingerprint.hpp"

namespace kusabi::run {
namespace {

using linear::ProgramFile;
using nlohmann::ordered_json;
using zero_one::MixedStatus;

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

struct MipOptions {
  std::string file;  ///< the program, MPS or CPLEX LP
  zero_one::ZeroOneRootOptions root;
  zero_one::ZeroOneBranching branching = zero_one::ZeroOneBranching::paper;
  engine::Options search;
  engine::Limits limits;        ///< limits of the search
  CheckpointChoice checkpoint;  ///< files of its state
};

struct MipReport {
  const MipOptions& options;
  const linear::ProgramFile& program;
  std::uint64_t fingerprint;
  const zero_one::MixedAnswer& found;

  /// No point has a better objective, in the sense of the file.
  [[nodiscard]] double bound() const;
  [[nodiscard]] double objective() const;
  /// |objective - bound| / |objective|; the absolute difference if the objective is zero.
  [[nodiscard]] double gap() const;

  [[nodiscard]] answer::Verdict verdict() const;

  /// The point, rank statistics and times, as text.
  [[nodiscard]] std::string table(const Page& page) const;

  // Members of a result file.
  [[nodiscard]] nlohmann::ordered_json problem_json() const;
  [[nodiscard]] nlohmann::ordered_json result_json() const;
  [[nodiscard]] nlohmann::ordered_json statistics_json() const;

  /// One row per nonzero column at the point found; the header alone without a point.
  void write_csv(std::ostream& out) const;

 private:
  [[nodiscard]] double in_the_files_sense(double objective) const;
  [[nodiscard]] support::Standing standing() const;
  [[nodiscard]] bool has_point() const;  // the result file has a point
};

double MipReport::in_the_files_sense(double objective) const {
  return program.maximise ? 0 - objective : objective;
}

double MipReport::objective() const {
  return in_the_files_sense(found.point()->objective);
}

double MipReport::bound() const {
  return in_the_files_sense(found.bound());
}

double MipReport::gap() const {
  const double difference = std::abs(objective() - bound());
  return objective() == 0 ? difference : difference / std::abs(objective());
}

// Of a point that is not known to be optimal, its own; an optimum requires the bound as well, and a
// program without points the bounds that exclude them.
support::Standing MipReport::standing() const {
  const bool point = found.point() == nullptr || found.point()->proved;
  const bool proved = point && (found.status() == MixedStatus::feasible || found.proved());
  return support::proved_if(proved);
}

answer::Verdict MipReport::verdict() const {
  using State = answer::MixedOptimum::State;
  answer::MixedOptimum answer{.standing = standing(),
                              .maximise = program.maximise,
                              .unproved = found.outcome.tally().unproved};
  switch (found.status()) {
    case MixedStatus::optimal:
      answer.state = State::optimal;
      break;
    case MixedStatus::feasible:
      answer.state = State::feasible;
      break;
    case MixedStatus::infeasible:
      answer.state = State::infeasible;
      break;
    case MixedStatus::unbounded:
      answer.state = State::unbounded;
      break;
    case MixedStatus::unknown:
      break;
  }
  if (has_point()) answer.objective = objective();
  if (std::isfinite(bound())) {
    answer.bound = support::Bound{bound(), support::proved_if(found.proved())};
    if (has_point()) answer.gap = gap();
  }
  return {.ended = found.outcome.status, .nodes_left = found.outcome.open, .answer = answer};
}

std::string MipReport::table(const Page& page) const {
  std::string text;
  auto out = std::back_inserter(text);
  if (found.point() != nullptr && found.status() != MixedStatus::unbounded) {
    std::size_t width = std::string_view("column").size();
    const auto& columns = program.mixed.program.columns;
    const auto& values = found.point()->values;
    for (std::size_t j = 0; j < columns.size(); ++j) {
      if (values[j] != 0) width = std::max(width, columns[j].name.size());
    }
    fmt::format_to(out, "\n{:<{}}  {:>14}\n", "column", width, "value");
    for (std::size_t j = 0; j < columns.size(); ++j) {
      if (values[j] == 0) continue;
      fmt::format_to(out, "{:<{}}  {:>14.8g}\n", columns[j].name, width, values[j]);
    }
  }
  text += '\n';
  const auto tally = found.outcome.tally();
  const auto& counts = found.tree.prepared().counts;
  fmt::format_to(out, "{}; {}, {} of them at the root; {} in {}; {} reduced\n",
                 answer::counted(found.outcome.opened(), "node"),
                 answer::counted(tally.programs + counts.programs, "linear program"),
                 counts.programs, answer::counted(counts.cuts, "cut"),
                 answer::counted(counts.cut_rounds, "round"),
                 answer::counted(counts.tightened, "coefficient"));
  RankTable ranks({"branched", "infeasible", "above", "leaves", "programs", "iterations"});
  const auto own = [](const zero_one::ZeroOneTally& its) {
    return std::vector<std::uint64_t>{its.branched, its.infeasible + its.unproved,
                                      its.above,    its.leaves,
                                      its.programs, its.iterations};
  };
  ranks.add_all(found.outcome, own);
  text += '\n' + ranks.text(page.width);
  return text;
}

bool MipReport::has_point() const {
  return found.status() == MixedStatus::optimal || found.status() == MixedStatus::feasible;
}

void MipReport::write_csv(std::ostream& out) const {
  CsvWriter csv(out);
  csv.word("column").word("value").end_row();
  if (!has_point()) return;
  const auto& columns = program.mixed.program.columns;
  for (std::size_t j = 0; j < columns.size(); ++j) {
    const double value = found.point()->values[j];
    if (value != 0) csv.text(columns[j].name).number(value).end_row();
  }
}

ordered_json MipReport::result_json() const {
  const auto& given = program.mixed.program;
  const auto& counts = found.tree.prepared().counts;
  ordered_json result;
  if (has_point()) {
    ordered_json columns = ordered_json::object();
    for (std::size_t j = 0; j < given.columns.size(); ++j) {
      const double value = found.point()->values[j];
      if (value != 0) columns[given.columns[j].name] = value;
    }
    result["columns"] = std::move(columns);
  }
  // Those of an unbounded program are of the program without costs.
  const auto root_bound = [&](double bound) {
    return found.unbounded ? ordered_json() : answer::number_or_null(in_the_files_sense(bound));
  };
  result["root"] = {{"first_bound", root_bound(counts.first_bound)},
                    {"last_bound", root_bound(counts.last_bound)},
                    {"programs", counts.programs},
                    {"cut_rounds", counts.cut_rounds},
                    {"cut_programs", counts.cut_programs},
                    {"cuts", counts.cuts},
                    {"tighten_programs", counts.tighten_programs},
                    {"tightened", counts.tightened},
                    {"fixed", counts.fixed}};
  return result;
}

ordered_json MipReport::problem_json() const {
  const auto& given = program.mixed.program;
  return {{"file", options.file},
          {"name", given.name},
          {"sense", program.maximise ? "maximise" : "minimise"},
          {"rows", given.rows.size()},
          {"columns", given.columns.size()},
          {"binaries", program.mixed.binaries.size()},
          {"entries", given.entries.size()},
          {"fingerprint", hexadecimal(fingerprint)}};
}

ordered_json MipReport::statistics_json() const {
  return {
      {"opened", found.outcome.opened()},
      {"open", found.outcome.open},
      {"ranks", rank_reports(found.outcome.ranks, counts_json<zero_one::ZeroOneTally>)},
      {"earlier_runs", rank_reports(found.outcome.earlier, counts_json<zero_one::ZeroOneTally>)}};
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
  std::optional<zero_one::MixedAnswer> found_;
};

void Mip::describe(OptionTable& table) {
  using engine::Order;
  table.file("file", options_.file, Role::input, "program file, MPS (.mps) or CPLEX LP (.lp)")
      .required();
  using zero_one::ZeroOneBranching;
  using zero_one::ZeroOneCuts;
  table.choice("--cuts", options_.root.cuts,
               {{"none", ZeroOneCuts::none}, {"disjunctive", ZeroOneCuts::disjunctive}},
               "kind of cuts at the root");
  table.choice("--branching", options_.branching,
               {{"paper", ZeroOneBranching::paper}, {"look-ahead", ZeroOneBranching::look_ahead}},

               "branching rule: largest tau (1 - tau), as in the paper, or largest gain of the "
               "children's bounds (fewer nodes, each of higher cost); the optimum is the same");
  table.choice("--order", options_.search.order,
               {{"depth-first", Order::depth_first},
                {"best-first", Order::best_first},
                {"hybrid", Order::hybrid}},
               "order in which nodes are opened; the optimum is the same");
  table.flag("--no-tighten", options_.root.tighten, "do not tighten the coefficients M", false);
  table.flag("--no-dive", options_.root.dive, "omit the dive for a first point before the search",
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
  table.save_on(options_.checkpoint);
  table.quiet_and_serial();
}

void Mip::read(CommandRun& run) {
  program_ = run.session().from_first_rank([&] { return linear::read_program(options_.file); });
}

void Mip::prepare(CommandRun& run) {
  fingerprint_ = program_fingerprint(program_);
  run.keep_state(options_.checkpoint, {{"the program", hexadecimal(fingerprint_)}});
  analysis_.emplace(run.session().transport(), run.analysis_options(options_.limits));
  options_.search.warn = warn;
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
  found_ = zero_one::solve_mixed(*analysis_, program_.mixed, options_.root, options_.branching,
                                 options_.search, {program_.maximise ? -1.0 : 1.0});
}

std::vector<Step> Mip::results(CommandRun& run) {
  const auto report =
      std::make_shared<const MipReport>(MipReport{options_, program_, fingerprint_, *found_});
  return {run.result([report, &run] {
            return run.result_json(report->problem_json(), report->result_json(),
                                   report->statistics_json());
          }),
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
