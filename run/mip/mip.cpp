// From the file to the report, on all ranks.
#include "run/mip/mip.hpp"

#include <cstdio>
#include <optional>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

#include "engine/together.hpp"
#include "nodes/zero_one/mixed_search.hpp"
#include "run/mip/mip_report.hpp"
#include "run/output/exit_code.hpp"
#include "run/output/last_steps.hpp"
#include "run/output/outputs.hpp"
#include "run/output/rank_table.hpp"
#include "run/output/result_file.hpp"
#include "run/output/standard_output.hpp"
#include "run/session/restart.hpp"
#include "run/session/supervision.hpp"
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

}  // namespace

int mip(Session& session, const MipOptions& options) {
  std::optional<ResultFile> result_file;
  engine::Campaign campaign(session.transport(), supervision(options.limits, options.quiet));
  const auto program = read_on_first_rank(session, options, result_file);
  const std::uint64_t fingerprint = program_fingerprint(program);

  engine::Options search_options;
  search_options.order = options.order;
  auto& checkpoint = search_options.checkpoint;
  checkpoint.file = options.checkpoint.empty() ? options.restart : options.checkpoint;
  checkpoint.interval = options.checkpoint_interval;
  checkpoint.problem = tree_fingerprint(fingerprint, options);
  checkpoint.resume_from =
      restart_from(session, options.checkpoint, options.restart, checkpoint.problem);
  search_options.warn = warn;
  if (session.speaks()) {
    for (const auto& warning : program.warnings) warn(warning);
    if (!options.quiet) announce(options, program, session.ranks());
  }
  const auto found = zero_one::solve_mixed(
      campaign, program.mixed,
      {.cuts = options.cuts, .tighten = options.tighten, .dive = options.dive}, options.branching,
      search_options, {program.maximise ? -1.0 : 1.0});
  const auto& outcome = found.outcome;

  bool answered = false;
  const bool whole = outcome.status == engine::Status::solved;
  if (session.speaks()) {
    const MipReport report{options, program, fingerprint, found};
    answered = found.answered();
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
