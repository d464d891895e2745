// One run of a subcommand, from its options to the exit code, the same for all of them: read on
// rank 0, open the outputs, prepare, announce, search, write, say what is left.
#pragma once

#include <chrono>
#include <exception>
#include <functional>
#include <iosfwd>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "engine/analysis/analysis.hpp"
#include "engine/journal.hpp"
#include "engine/options.hpp"
#include "engine/statistics.hpp"
#include "engine/together.hpp"
#include "run/command/config_file.hpp"
#include "run/command/option_table.hpp"
#include "run/command/subcommand.hpp"
#include "run/output/json_writer.hpp"
#include "run/output/output_file.hpp"
#include "run/output/output_folder.hpp"
#include "run/output/page.hpp"
#include "run/session/restart.hpp"
#include "run/session/session.hpp"
#include "support/stop.hpp"

namespace kusabi::run {

class CommandRun {
 public:
  /// All must outlive it.
  CommandRun(Session& session, Subcommand& command, const OptionTable& table,
             const Defaults& defaults);

  /// Goes through all stages. @return the exit code, the same on every rank
  /// @throws WrongInput, support::InputError, engine::Disagreement on every rank alike; whatever
  ///   else goes wrong on one
  int execute();

  [[nodiscard]] Session& session() { return session_; }
  /// Whether this rank shows what happens: rank 0, unless told to be quiet.
  [[nodiscard]] bool shows() { return session_.speaks() && !quiet_; }
  [[nodiscard]] bool quiet() const { return quiet_; }

  /// Does work before the search that every rank does by itself and that takes long. It is shown,
  /// and ended by the limits and signals of the call: on all ranks, if on one.
  /// @throws support::Stopped on every rank alike
  template <class Work>
  std::invoke_result_t<Work, const support::LongWork&> within_limits(Work work) {
    std::optional<std::invoke_result_t<Work, const support::LongWork&>> result;
    std::exception_ptr wrong;
    bool stopped = false;
    try {
      result.emplace(work(long_work()));
    } catch (const support::Stopped&) {
      stopped = true;
    } catch (...) {  // the others may have been stopped before they came to this
      wrong = std::current_exception();
    }
    const engine::Reduction own{.ranks = 1, .found = stopped ? 1U : 0U};
    if (engine::all_reduce(session_.transport(), own).found != 0) throw support::Stopped();
    if (wrong) std::rethrow_exception(wrong);
    return *std::move(result);
  }

  /// What the engine is to keep and to go on from.
  /// @param tree fingerprint of the tree
  /// @throws WrongInput if there is no such checkpoint, or one is in the way
  engine::CheckpointOptions checkpoint(const CheckpointChoice& choice, std::uint64_t tree);

  /// Opens what --resume names, if it is given: what is finished of the question, for this run and
  /// those that go on with it.
  /// @param problem facts of what is read, beside those of the options
  /// @throws WrongInput if it is in use, damaged or of another call
  void keep_state(const CheckpointChoice& choice, engine::Facts problem);

  /// Whether a search is finished already, or at least one is under way.
  [[nodiscard]] bool has_searched() const { return kept_.searched; }
  [[nodiscard]] bool has_begun_to_search() const { return kept_.searched || kept_.searching; }
  /// Whether all that was asked for was finished in an earlier run.
  [[nodiscard]] bool is_finished() const { return kept_.finished; }

  /// How the command takes part in a question, and where that is kept. Signals are heeded from here
  /// on. @param limits of the call
  engine::Supervision supervision(const engine::Limits& limits);

  /// How a search that stopped early is gone on with, in lines for
  /// Subcommand::remarks. @param saved
  /// whether its last state is in the checkpoint
  [[nodiscard]] std::vector<std::string> how_to_go_on(const CheckpointChoice& choice,
                                                      engine::Status why, bool saved);

  // On rank 0: whether an output is wanted, and what Subcommand::results is made of. What a step
  // writes is made when its turn comes, and only if it is wanted; so one that fails takes nothing
  // from the others.

  [[nodiscard]] bool wants(const std::string& option) const;
  /// @pre wants(option)
  [[nodiscard]] std::ostream& stream(const std::string& option);

  /// Writes the file of --output, if it is wanted.
  Step result(std::function<nlohmann::ordered_json()> make);
  Step result(std::function<void(JsonWriter&)> write);
  /// Writes another output, if it is wanted. @param write may be empty: `stream` has had it all
  Step file(const std::string& option, std::function<void(std::ostream&)> write);
  /// Fills a folder, if it is wanted.
  Step folder(const std::string& option, std::function<void(OutputFolder&)> fill);
  /// What answers are printed on. The standard output of a job is the launcher's, of which it is
  /// not known what becomes: as endless and plain as a file.
  [[nodiscard]] static Page page();
  /// Prints the table and below it the verdict, folded for the page, unless quiet.
  Step answer(std::function<std::string()> make);
  /// Prints even if quiet.
  static Step print(std::string text);

 private:
  [[nodiscard]] support::LongWork long_work();
  [[nodiscard]] double seconds() const;
  int stopped_before_the_search();
  void settle_time_limit();
  void open_outputs();
  void announce();
  void put_in_place(const std::string& option);
  [[nodiscard]] std::string input() const;
  void check() const;
  [[nodiscard]] std::string defaults_told() const;
  [[nodiscard]] nlohmann::ordered_json defaults_json() const;
  [[nodiscard]] Verdict verdict() const;
  [[nodiscard]] nlohmann::ordered_json last_members() const;
  void tell_what_is_open(const Verdict& verdict) const;

  Session& session_;
  Subcommand& command_;
  const OptionTable& table_;
  const Defaults& defaults_;
  bool quiet_ = false;
  std::map<std::string, OutputFile> outputs_;    // by option; on rank 0
  std::map<std::string, OutputFolder> folders_;  // likewise
  std::vector<std::string> written_;
  std::unique_ptr<engine::Journal> journal_;  // on rank 0, if --resume is given
  std::optional<engine::Keeping> keeping_;    // likewise, on every rank
  KeptState kept_;
  std::chrono::steady_clock::time_point started_ = std::chrono::steady_clock::now();
  std::chrono::steady_clock::time_point told_ = started_;
  std::optional<std::chrono::steady_clock::time_point> ends_with_the_job_at_;
};

}  // namespace kusabi::run
