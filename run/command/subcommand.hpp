// A subcommand of `kusabi`: its options, and what it does at each stage of a run. CommandRun does
// what lies between the stages, and main knows which subcommands there are (run/subcommands.cpp).
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

/// A thing to do at the end of a run: a file to write, the answer to print.
using Step = std::function<void()>;

/// The stages of a run, in their order. All ranks go through them, rank 0 alone through the last
/// two.
class Subcommand {
 public:
  Subcommand() = default;
  Subcommand(const Subcommand&) = delete;
  Subcommand& operator=(const Subcommand&) = delete;
  virtual ~Subcommand() = default;

  /// As it is called: one word, or a group and a word.
  [[nodiscard]] virtual std::string_view name() const = 0;
  /// What it does, in a line of the list of all: a few words.
  [[nodiscard]] virtual std::string_view purpose() const = 0;
  /// The same at length, in sentences; empty: there is no more to say.
  [[nodiscard]] virtual std::string_view description() const { return {}; }
  /// A call that works from the top of the source tree, without `kusabi` and its name.
  [[nodiscard]] virtual std::string_view example() const = 0;
  /// What help says below the options; empty: nothing. As it is laid out here.
  [[nodiscard]] virtual std::string notes() const { return {}; }
  /// Its options. What they are stored in lives as long as the subcommand.
  virtual void describe(OptionTable& table) = 0;

  /// Whether the options go together. @throws WrongInput
  virtual void check() const {}

  /// Reads its files, on rank 0 for all. Then CommandRun opens the outputs.
  /// @throws WrongInput on every rank alike
  virtual void read(CommandRun& /*run*/) {}

  /// From what was read to what is searched.
  /// @throws WrongInput, support::InputError on every rank alike
  virtual void prepare(CommandRun& /*run*/) {}

  /// What is going to be done, in a line; empty: nothing is said.
  /// @param ranks "1 rank", "8 ranks"
  [[nodiscard]] virtual std::string announcement(const std::string& /*ranks*/) const { return {}; }

  virtual void search(CommandRun& run) = 0;

  /// Files first, then the answer; each is done even if one before it has failed.
  virtual std::vector<Step> results(CommandRun& run) = 0;

  /// The answer, and what of it is open, once the search has ended. Its sentences, the exit code
  /// and the key `verdict` of the result file are made of it.
  [[nodiscard]] virtual Verdict verdict() const { return {}; }

  /// Lines on standard error after everything is written: the call that goes on, outputs that were
  /// shortened.
  virtual std::vector<std::string> remarks(CommandRun& /*run*/) { return {}; }
};

}  // namespace kusabi::run
