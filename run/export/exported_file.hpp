// ExportedFile: common part of `kusabi export`, which reads a problem file and writes a file, by
// default to standard output.
#pragma once

#include <iosfwd>
#include <string>
#include <vector>

#include "run/command/problem_input.hpp"
#include "run/command/subcommand.hpp"

namespace kusabi::run {

class ExportedFile : public Subcommand {
 public:
  void read(CommandRun& run) final { input_.read(run); }
  /// Most exports need no search.
  void search(CommandRun& /*run*/) override {}
  std::vector<Step> results(CommandRun& run) final;

 protected:
  /// Rows common to all: the problem file first, options of the run last.
  void describe_input(OptionTable& table);
  static void describe_output(OptionTable& table);

  [[nodiscard]] const ProblemInput& input() const { return input_; }

  /// Writes the file, on rank 0, after the search.
  virtual void write(std::ostream& out) const = 0;

 private:
  ProblemInput input_;
};

}  // namespace kusabi::run
