// One run of a subcommand, from its options to the exit code, the same for all of them: read on
// rank 0, open the outputs, prepare, announce, search, write, say what is left.
#pragma once

#include <functional>
#include <iosfwd>
#include <map>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "engine/options.hpp"
#include "engine/statistics.hpp"
#include "run/command/config_file.hpp"
#include "run/command/option_table.hpp"
#include "run/command/subcommand.hpp"
#include "run/output/json_writer.hpp"
#include "run/output/output_file.hpp"
#include "run/output/output_folder.hpp"
#include "run/output/page.hpp"
#include "run/session/session.hpp"

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

  /// What the engine is to keep and to go on from.
  /// @param tree fingerprint of the tree
  /// @throws WrongInput if there is no such checkpoint, or one is in the way
  engine::CheckpointOptions checkpoint(const CheckpointChoice& choice, std::uint64_t tree);

  /// How a search that stopped early is gone on with, in lines for Verdict::remarks. @param saved
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
  /// Prints the answer, folded for the page, unless quiet.
  Step answer(std::function<std::string()> make);
  /// Prints even if quiet.
  static Step print(std::string text);

 private:
  void open_outputs();
  void announce();
  void put_in_place(const std::string& option);
  [[nodiscard]] std::string input() const;
  void check() const;
  [[nodiscard]] std::string defaults_told() const;
  [[nodiscard]] nlohmann::ordered_json defaults_json() const;

  Session& session_;
  Subcommand& command_;
  const OptionTable& table_;
  const Defaults& defaults_;
  bool quiet_ = false;
  std::map<std::string, OutputFile> outputs_;    // by option; on rank 0
  std::map<std::string, OutputFolder> folders_;  // likewise
  std::vector<std::string> written_;
};

}  // namespace kusabi::run
