// From the file to the report, on all ranks.
#include "run/mip/mip.hpp"

#include <optional>
#include <utility>

#include <fmt/format.h>

#include "engine/budget.hpp"
#include "engine/signals.hpp"
#include "engine/together.hpp"
#include "nodes/zero_one/unboundedness.hpp"
#include "run/command/command_run.hpp"
#include "run/mip/mip_report.hpp"
#include "run/output/rank_table.hpp"
#include "run/session/restart.hpp"
#include "run/session/shown_search.hpp"
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

// A checkpoint belongs to a tree, and the tree depends on the options as well.
std::uint64_t tree_fingerprint(std::uint64_t program, const MipOptions& options) {
  support::Fingerprint fingerprint;
  fingerprint.add(program);
  fingerprint.add(static_cast<int>(options.cuts));
  fingerprint.add(static_cast<int>(options.branching));
  fingerprint.add(static_cast<int>(options.tighten));
  fingerprint.add(static_cast<int>(options.dive));
  return fingerprint.value();
}

// What the search starts from, which every rank has worked out by itself.
std::uint64_t root_fingerprint(const zero_one::ZeroOneRoot& root) {
  support::Fingerprint fingerprint;
  const auto& program = root.relaxation.program();
  for (const auto& column : program.columns) {
    fingerprint.add(column.lower);
    fingerprint.add(column.upper);
  }
  for (const auto& row : program.rows) {
    fingerprint.add(row.lower);
    fingerprint.add(row.upper);
  }
  for (const auto& entry : program.entries) fingerprint.add(entry.value);
  fingerprint.add(root.bound);
  fingerprint.add(root.point ? root.point->objective : linear::infinity);
  return fingerprint.value();
}

// The outcome if the work at the root was stopped: its bound and its point, and one open node.
engine::Outcome<zero_one::ZeroOneTree> outcome_of_root(const zero_one::ZeroOneTree& tree, int ranks,
                                                       engine::Status why) {
  engine::Outcome<zero_one::ZeroOneTree> outcome;
  outcome.status = why;
  outcome.open = 1;
  outcome.bound = tree.prepared().bound;
  if (const auto& point = tree.prepared().point) outcome.solutions.push_back({{}, *point});
  outcome.ranks.resize(static_cast<std::size_t>(ranks));
  return outcome;
}

// If the relaxation has no lower bound, neither has the program, if it has a point at all: the
// direction in which the objective falls leaves the binaries alone. So a point is all there is to
// look for.
bool without_bound(zero_one::ZeroOneRoot& root, const ProgramFile& program,
                   const zero_one::ZeroOneRootOptions& options) {
  if (root.status != linear::LinearStatus::unbounded ||
      !zero_one::falls_for_ever(program.mixed, options.stop)) {
    return false;
  }
  auto any_point = program.mixed;
  for (auto& column : any_point.program.columns) column.cost = 0;
  root = zero_one::prepare_root(std::move(any_point), options);
  return true;
}

class Mip final : public Subcommand {
 public:
  [[nodiscard]] std::string_view name() const override { return "mip"; }
  [[nodiscard]] std::string_view purpose() const override {
    return "the optimum of a mixed zero-one linear program, with its bound";
  }
  void describe(OptionTable& table) override;
  void read(CommandRun& run) override;
  void prepare(CommandRun& run) override;
  [[nodiscard]] std::string announcement(const std::string& ranks) const override;
  void search(CommandRun& run) override;
  std::vector<Step> results(CommandRun& run) override;
  Verdict verdict(CommandRun& run) override;

 private:
  MipOptions options_;
  std::optional<engine::Budget> budget_;  // from the reading of the file on
  ProgramFile program_;
  std::uint64_t fingerprint_ = 0;
  engine::Options search_options_;
  bool unbounded_ = false;
  std::optional<zero_one::ZeroOneTree> tree_;
  std::optional<engine::Outcome<zero_one::ZeroOneTree>> outcome_;
  std::optional<MipReport> report_;  // on rank 0
};

void Mip::describe(OptionTable& table) {
  using engine::Order;
  using zero_one::ZeroOneBranching;
  using zero_one::ZeroOneCuts;
  table
      .file("file", options_.file, Role::input,
            "the program, in MPS (.mps) or CPLEX LP (.lp) format")
      .required();
  table.choice("--cuts", options_.cuts,
               {{"none", ZeroOneCuts::none}, {"disjunctive", ZeroOneCuts::disjunctive}},
               "cuts at the root");
  table.choice("--branching", options_.branching,
               {{"paper", ZeroOneBranching::paper}, {"look-ahead", ZeroOneBranching::look_ahead}},
               "split nodes by the largest tau (1 - tau) as the paper does, or by what the "
               "children's bounds gain: the same optimum from fewer nodes that cost more");
  table.choice("--order", options_.order,
               {{"depth-first", Order::depth_first},
                {"best-first", Order::best_first},
                {"hybrid", Order::hybrid}},
               "which node is opened next: the same optimum");
  table.flag("--no-tighten", options_.tighten, "leave big Ms as they are", false);
  table.flag("--no-dive", options_.dive, "do not look for points before the search", false);
  table.output();
  table.time_limit(options_.limits);
  table.node_limit(options_.limits);
  table
      .number("--gap", &options_.limits.gap, above(0),
              "stop when objective and bound differ by so much, relative to the objective")
      .stops(engine::Status::gap_limit);
  table.checkpoints(options_.checkpoint);
  table.quiet();
  table.serial();
}

void Mip::read(CommandRun& run) {
  engine::heed_signals();
  budget_.emplace(options_.limits, engine::asked_by_signal);
  program_ = run.session().from_first_rank([&] { return linear::read_program(options_.file); });
}

void Mip::prepare(CommandRun& run) {
  fingerprint_ = program_fingerprint(program_);
  search_options_.goal = engine::Goal::best;
  search_options_.order = options_.order;
  search_options_.checkpoint =
      run.checkpoint(options_.checkpoint, tree_fingerprint(fingerprint_, options_));
  search_options_.warn = warn;
  search_options_.interrupt = budget_->interrupt();
  if (!run.session().speaks()) return;
  for (const auto& warning : program_.warnings) warn(warning);
}

std::string Mip::announcement(const std::string& ranks) const {
  const auto& [name, constant, columns, rows, entries] = program_.mixed.program;
  return fmt::format("{}: {} rows, {} columns, {} of them binary, {} entries; {}; {}",
                     name.empty() ? "a program without a name" : name, rows.size(), columns.size(),
                     program_.mixed.binaries.size(), entries.size(),
                     program_.maximise ? "maximise" : "minimise", ranks);
}

void Mip::search(CommandRun& run) {
  auto& session = run.session();
  const zero_one::ZeroOneRootOptions root_options{.cuts = options_.cuts,
                                                  .tighten = options_.tighten,
                                                  .dive = options_.dive,
                                                  .stop = budget_->stop()};
  auto root = zero_one::prepare_root(program_.mixed, root_options);
  unbounded_ = without_bound(root, program_, root_options);
  // One rank that was stopped at the root stops all: their roots differ.
  const auto stopped =
      engine::meet(session.transport(), {.ranks = 1, .found = root.interrupted ? 1U : 0U});
  if (stopped.found == 0) engine::agree(session.transport(), root_fingerprint(root));
  tree_.emplace(std::move(root), options_.branching);
  outcome_ = stopped.found != 0 ? outcome_of_root(*tree_, session.ranks(), budget_->why())
                                : shown_search(session, *tree_, search_options_, budget_->left(),
                                               run.quiet(), {program_.maximise ? -1.0 : 1.0});
}

std::vector<Step> Mip::results(CommandRun& run) {
  report_.emplace(MipReport{options_, program_, fingerprint_, *tree_, *outcome_, unbounded_});
  return {run.result(report_->json()), run.answer(report_->table())};
}

Verdict Mip::verdict(CommandRun& run) {
  Verdict verdict{.remarks = {}, .code = report_->answered() ? solved : stopped_early};
  if (outcome_->status != engine::Status::solved) {
    verdict.remarks = run.how_to_go_on(options_.checkpoint, outcome_->status, outcome_->saved);
    verdict.remarks.insert(verdict.remarks.begin(),
                           fmt::format("stopped early ({}): {} open nodes are left",
                                       status_name(outcome_->status), outcome_->open));
  }
  return verdict;
}

}  // namespace

std::unique_ptr<Subcommand> mip_subcommand() {
  return std::make_unique<Mip>();
}

}  // namespace kusabi::run
