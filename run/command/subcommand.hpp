// Subcommand: the options of a subcommand and its work at each stage of a run. CommandRun does the
// common work between the stages; run/subcommands.cpp lists all subcommands.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "run/command/option_table.hpp"
#include "run/verdict/verdict.hpp"

namespace kusabi::run {

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

  /// Name in a call: one word, or a group and a word.
  [[nodiscard]] virtual std::string_view name() const = 0;
  /// Purpose in a few words, for the list of all subcommands.
  [[nodiscard]] virtual std::string_view purpose() const = 0;
  /// Description in sentences; empty: none besides the purpose.
  [[nodiscard]] virtual std::string_view description() const { return {}; }
  /// A call that works from the top of the source tree, without `kusabi` and the name.
  [[nodiscard]] virtual std::string_view example() const = 0;
  /// Text below the options in help; empty: none. Its line breaks are kept.
  [[nodiscard]] virtual std::string notes() const { return {}; }
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

  /// Files first, then the answer; each step runs even if an earlier one has failed.
  virtual std::vector<Step> results(CommandRun& run) = 0;

  /// The verdict after the search. Its sentences, the exit code and the key `verdict` of the result
  /// file are made from it.
  [[nodiscard]] virtual Verdict verdict() const { return {}; }

  /// Lines on standard error after all files are written: the call that resumes the search, outputs
  /// that were shortened.
  virtual std::vector<std::string> remarks(CommandRun& /*run*/) { return {}; }
};

}  // namespace kusabi::run
