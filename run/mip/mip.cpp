// From the file to the report, on all ranks.
#include "run/mip/mip.hpp"

#include <cstdio>
#include <optional>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

#include "engine/budget.hpp"
#include "engine/signals.hpp"
#include "engine/together.hpp"
#include "nodes/zero_one/unboundedness.hpp"
#include "run/mip/mip_report.hpp"
#include "run/output/exit_code.hpp"
#include "run/output/last_steps.hpp"
#include "run/output/outputs.hpp"
#include "run/output/rank_table.hpp"
#include "run/output/result_file.hpp"
#include "run/output/standard_output.hpp"
#include "run/session/restart.hpp"
#include "run/session/shown_search.hpp"
#include "solvers/linear/program_file.hpp"
#include "support/fingerprint.hpp"

namespace kusabi::run {
namespace {

using linear::ProgramFile;

void announce(const MipOptions& options, const ProgramFile& program, int ranks) {
  const auto& [name, constant, columns, rows, entries] = program.mixed.program;
  tell(
      "kusabi {} · mip · {}\n"
      "{}: {} rows, {} columns, {} of them binary, {} entries; {}; {}\n",
      KUSABI_VERSION, options.file, name.empty() ? "a program without a name" : name, rows.size(),
      columns.size(), program.mixed.binaries.size(), entries.size(),
      program.maximise ? "maximise" : "minimise",
      ranks == 1 ? "1 rank" : fmt::format("{} ranks", ranks));
}

// Rank 0 reads; the others get what it read.
ProgramFile read_on_first_rank(Session& session, const MipOptions& options,
                               std::optional<ResultFile>& result_file) {
  return session.from_first_rank([&] {
    auto program = linear::read_program(options.file);
    check_outputs(
        options.file, {{"--output", options.output}},
        {{"--checkpoint", options.checkpoint.empty() ? options.restart : options.checkpoint}});
    result_file.emplace(options.output, options.file);
    return program;
  });
}

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

void tell_what_is_left(const MipOptions& options, const std::string& checkpoint,
                       const engine::Outcome<zero_one::ZeroOneTree>& outcome) {
  tell("stopped early ({}): {} open nodes are left\n", status_name(outcome.status), outcome.open);
  std::string call = fmt::format("kusabi mip {}", options.file);
  if (options.cuts == zero_one::ZeroOneCuts::disjunctive) call += " --cuts disjunctive";
  if (options.branching == zero_one::ZeroOneBranching::look_ahead) {
    call += " --branching look-ahead";
  }
  if (!options.tighten) call += " --no-tighten";
  if (!options.dive) call += " --no-dive";
  tell_how_to_go_on(call, checkpoint, outcome.saved);
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

}  // namespace

int mip(Session& session, const MipOptions& options) {
  std::optional<ResultFile> result_file;
  engine::heed_signals();
  const engine::Budget budget(options.limits, engine::asked_by_signal);
  const auto program = read_on_first_rank(session, options, result_file);
  const std::uint64_t fingerprint = program_fingerprint(program);

  engine::Options search_options;
  search_options.goal = engine::Goal::best;
  search_options.order = options.order;
  auto& checkpoint = search_options.checkpoint;
  checkpoint.file = options.checkpoint.empty() ? options.restart : options.checkpoint;
  checkpoint.interval = options.checkpoint_interval;
  checkpoint.problem = tree_fingerprint(fingerprint, options);
  checkpoint.resume_from =
      restart_from(session, options.checkpoint, options.restart, checkpoint.problem);
  search_options.interrupt = budget.interrupt();
  search_options.warn = warn;
  if (session.speaks()) {
    for (const auto& warning : program.warnings) warn(warning);
    if (!options.quiet) announce(options, program, session.ranks());
  }
  const zero_one::ZeroOneRootOptions root_options{.cuts = options.cuts,
                                                  .tighten = options.tighten,
                                                  .dive = options.dive,
                                                  .stop = budget.stop()};
  auto root = zero_one::prepare_root(program.mixed, root_options);
  const bool unbounded = without_bound(root, program, root_options);
  // One rank that was stopped at the root stops all: their roots differ.
  const auto stopped =
      engine::meet(session.transport(), {.ranks = 1, .found = root.interrupted ? 1U : 0U});
  if (stopped.found == 0) engine::agree(session.transport(), root_fingerprint(root));
  zero_one::ZeroOneTree tree(std::move(root), options.branching);
  const auto outcome = stopped.found != 0
                           ? outcome_of_root(tree, session.ranks(), budget.why())
                           : shown_search(session, tree, search_options, budget.left(),
                                          options.quiet, {program.maximise ? -1.0 : 1.0});

  bool answered = false;
  const bool whole = outcome.status == engine::Status::solved;
  if (session.speaks()) {
    const MipReport report{options, program, fingerprint, tree, outcome, unbounded};
    answered = report.answered();
    do_all({[&] { result_file->write(report.json()); },
            [&] {
              if (!options.quiet) print_answer(report.table());
            }});
    if (!options.quiet) tell_written({options.output});
    if (!whole) tell_what_is_left(options, checkpoint.file, outcome);
  }
  return engine::from_first_rank(session.transport(), [&] { return answered; }) ? solved
                                                                                : stopped_early;
}

}  // namespace kusabi::run
