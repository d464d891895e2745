// CommandRun: one run of a subcommand, from options to exit code: read on rank 0, open outputs,
// prepare, announce, search, write, report.
#pragma once

#include <chrono>
#include <exception>
#include <functional>
#include <iosfwd>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "engine/analysis/analysis.hpp"
#include "engine/collectives.hpp"
#include "engine/journal.hpp"
#include "engine/options.hpp"
#include "engine/statistics.hpp"
#include "run/command/command_list.hpp"
#include "run/command/config_file.hpp"
#include "run/command/option_table.hpp"
#include "run/command/output_set.hpp"
#include "run/command/subcommand.hpp"
#include "run/output/json_writer.hpp"
#include "run/output/terminal_page.hpp"
#include "run/session/kept_state.hpp"
#include "run/session/session.hpp"
#include "run/session/time_limit.hpp"
#include "support/stop.hpp"

namespace kusabi::run {

class CommandRun {
 public:
  /// All arguments must outlive it.
  CommandRun(Session& session, const CommandList::Entry& entry, const Defaults& defaults);

  /// Runs all stages.
  /// @return the exit code, the same on every rank
  /// @throws WrongInput, support::InputError, engine::RankMismatch on every rank; any other error
  /// on one rank
  int execute();

  /// Name of the subcommand.
  [[nodiscard]] std::string_view name() const { return name_; }
  [[nodiscard]] Session& session() { return session_; }
  /// True on the rank that prints: rank 0, unless --quiet is given.
  [[nodiscard]] bool shows() { return session_.is_first() && !quiet_; }
  [[nodiscard]] bool quiet() const { return quiet_; }

  /// Runs long work that every rank does by itself before the search. Its progress is shown; limits
  /// and signals end it on all ranks.
  /// @throws support::Stopped on every rank
  template <class Work>
  std::invoke_result_t<Work, const support::LongWork&> within_limits(Work work) {
    std::optional<std::invoke_result_t<Work, const support::LongWork&>> result;
    std::exception_ptr wrong;
    bool stopped = false;
    try {
      result.emplace(work(long_work()));
    } catch (const support::Stopped&) {
      stopped = true;
    } catch (...) {  // the others may have been stopped earlier
      wrong = std::current_exception();
    }
    const engine::Reduction own{.ranks = 1, .found = stopped ? 1U : 0U};
    if (engine::all_reduce(session_.transport(), own).found != 0) throw support::Stopped();
    if (wrong) std::rethrow_exception(wrong);
    return *std::move(result);
  }

  /// Opens the state file of --resume, if given: everything finished so far, for this run and later
  /// ones.
  /// @param problem facts of the input, in addition to those of the options
  /// @throws WrongInput if it is in use, damaged or belongs to another call
  void keep_state(const CheckpointChoice& choice, engine::Facts problem);

  /// True if a search is finished or under way.
  [[nodiscard]] bool has_searched() const { return kept_.searched; }
  [[nodiscard]] bool has_begun_to_search() const { return kept_.searched || kept_.searching; }
  /// True if an earlier run has finished everything.
  [[nodiscard]] bool is_finished() const { return kept_.finished; }

  /// Options of an analysis and the file that keeps its state. Catches signals from here on.
  /// @param limits of the call
  engine::AnalysisOptions analysis_options(const engine::Limits& limits);

  // Outputs and Steps of Subcommand::results, on rank 0. A step makes its content when its turn
  // comes, and only if the output is requested, so an error in one step does not affect the others.

  [[nodiscard]] bool wants(const std::string& option) const { return outputs_.wants(option); }
  /// @param files which the input file names @throws WrongInput if an output is one of them
  void keep(const std::vector<std::string>& files) { outputs_.keep(session_, files); }
  /// @pre wants(option)
  [[nodiscard]] std::ostream& stream(const std::string& option) { return outputs_.stream(option); }

  /// First members of a result file: command, version, problem, options, status and, in `result`,
  /// the counts and bounds of the answer.
  [[nodiscard]] nlohmann::ordered_json head(nlohmann::ordered_json problem) const;
  /// A result file up to its verdict.
  /// @param result what else was found; its lists of objects complete those of the answer
  [[nodiscard]] nlohmann::ordered_json result_json(nlohmann::ordered_json problem,
                                                   nlohmann::ordered_json result,
                                                   nlohmann::ordered_json statistics) const;

  /// Writes the file of --output, if requested.
  Step result(std::function<nlohmann::ordered_json()> make);
  Step result(std::function<void(JsonWriter&)> write);
  /// Writes the file of --output as lines of JSON, if requested: those of `write`, and one with the
  /// verdict. @param write returns false if the file in place is this one already
  /// @param done called when the file is in place
  Step result_lines(std::function<bool(std::ostream&)> write, std::function<void()> done);
  /// Writes another output, if requested.
  /// @param write may be empty if `stream` has received everything
  Step file(const std::string& option, std::function<void(std::ostream&)> write) {
    return outputs_.file(option, std::move(write));
  }
  /// Fills a folder, if requested.
  Step folder(const std::string& option, std::function<void(OutputFolder&)> fill) {
    return outputs_.folder(option, std::move(fill));
  }
  /// Page of the answer. The standard output of an MPI job belongs to the launcher, so it is
  /// treated as a file: no folding, no colours.
  [[nodiscard]] static Page page();
  /// Prints the table, and the verdict below it, folded for the page; nothing with --quiet.
  Step answer(std::function<std::string()> make);
  /// Prints even with --quiet.
  static Step print(std::string text);

 private:
  [[nodiscard]] support::LongWork long_work();
  [[nodiscard]] double seconds() const;
  int stopped_before_the_search();
  void write_status() const;
  void announce();
  [[nodiscard]] std::string input() const;
  void check() const;
  [[nodiscard]] std::string defaults_text() const;
  [[nodiscard]] nlohmann::ordered_json defaults_json() const;
  [[nodiscard]] answer::Verdict verdict() const;
  [[nodiscard]] nlohmann::ordered_json last_members() const;
  [[nodiscard]] bool shows_both_streams() const;
  void print_open_reservations(const answer::Verdict& verdict) const;
  [[nodiscard]] std::string how_to_go_on(engine::Status why) const;

  Session& session_;
  std::string_view name_;
  Subcommand& command_;
  const OptionTable& table_;
  const Defaults& defaults_;
  bool quiet_ = false;
  OutputSet outputs_;
  std::unique_ptr<engine::Journal> journal_;               // on rank 0, if --resume is given
  std::optional<engine::JournalOptions> journal_options_;  // with --resume, on every rank
  KeptState kept_;
  std::chrono::steady_clock::time_point started_ = std::chrono::steady_clock::now();
  std::chrono::steady_clock::time_point last_line_ = started_;
  JobEnd job_end_;
};

}  // namespace kusabi::run
