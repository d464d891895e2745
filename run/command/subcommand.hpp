// Subcommand: the options of a subcommand and its work at each stage of a run. CommandRun does the
// common work between the stages. Each subcommand is registered by a constant below its class.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "answer/verdict.hpp"
#include "run/command/option_table.hpp"
#include "run/session/time_limit.hpp"

namespace kusabi::run {

/// Progress lines of a subcommand, which its help explains.
enum class ProgressLines {
  none,
  solutions,  ///< number of solutions found
  bounds,     ///< best value, bound and gap
};

/// Texts of a subcommand, from which the list of all, help, manual pages and completion are made.
struct SubcommandText {
  std::string_view name{};         ///< in a call: one word, or a group and a word
  std::string_view chapter{};      ///< of the list of all subcommands
  std::string_view purpose{};      ///< in a few words, for lists
  std::string_view description{};  ///< in sentences; empty: none besides the purpose
  /// A call that works from the top of the source tree, without `kusabi` and the name.
  std::string_view example{};
  ProgressLines progress = ProgressLines::none;
};

class CommandRun;

/// A step at the end of a run: a file to write, or the answer to print.
using Step = std::function<void()>;

/// The stages of a run, in order. All ranks run all of them, except for the last two, which run on
/// rank 0.
class Subcommand {
 public:
  Subcommand() = default;
  Subcommand(const Subcommand&) = delete;
  Subcommand& operator=(const Subcommand&) = delete;
  virtual ~Subcommand() = default;

  /// Adds the options to the table; their variables live as long as the subcommand.
  virtual void describe(OptionTable& table) = 0;

  /// Checks combinations of options. @throws WrongInput
  virtual void check() const {}

  /// Reads the input files, on rank 0 for all. Outputs are opened next.
  /// @throws WrongInput on every rank
  virtual void read(CommandRun& /*run*/) {}

  /// Prepares the problem from its text. @throws WrongInput, support::InputError on every rank
  virtual void prepare(CommandRun& /*run*/) {}

  /// Heading line printed before the search; empty: none. @param ranks "1 rank", "8 ranks"
  [[nodiscard]] virtual std::string announcement(const std::string& /*ranks*/) const { return {}; }

  virtual void search(CommandRun& run) = 0;

  /// Upper estimate of the time to write so many solutions.
  [[nodiscard]] virtual double seconds_to_write(std::uint64_t solutions) const {
    return run::seconds_to_write(solutions);
  }

  /// True if --time-limit includes the time to write the results, as --time-limit slurm does.
  [[nodiscard]] virtual bool limit_includes_writing() const { return false; }

  /// Files first, then the answer; each step runs even if an earlier one has failed.
  virtual std::vector<Step> results(CommandRun& run) = 0;

  /// The verdict after the search. Its sentences, the exit code and the key `verdict` of the result
  /// file are made from it.
  [[nodiscard]] virtual answer::Verdict verdict() const { return {}; }

  /// Lines on standard error after all files are written, such as on outputs that were shortened.
  virtual std::vector<std::string> remarks(CommandRun& /*run*/) { return {}; }
};

template <class Command>
std::unique_ptr<Subcommand> make() {
  return std::make_unique<Command>();
}

/// An entry of the list of all subcommands, made of constants.
struct Registration {
  SubcommandText text{};
  std::unique_ptr<Subcommand> (*make)() = nullptr;
};

extern const Registration patterns_subcommand, rays_subcommand, critical_subcommand,
    hold_subcommand, limit_subcommand, sweep_subcommand, mip_subcommand, verify_subcommand,
    show_subcommand, draw_subcommand, report_subcommand, example_space_truss_subcommand,
    example_plane_truss_subcommand, example_grid_subcommand, example_dome_subcommand,
    example_tower_subcommand, import_subcommand, export_mps_subcommand, export_cbf_subcommand,
    export_matrix_subcommand, bench_scaling_subcommand, bench_schedules_subcommand,
    bench_uts_subcommand;

}  // namespace kusabi::run
