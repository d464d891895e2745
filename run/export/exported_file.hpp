// ExportedFile: common part of `kusabi export`, which reads a problem file and writes a file, by
// default to standard output.
#pragma once

#include <iosfwd>
#include <string>
#include <vector>

#include "problems/files/problem_text.hpp"
#include "run/command/subcommand.hpp"

namespace kusabi::run {

class ExportedFile : public Subcommand {
 public:
  void read(CommandRun& run) final;
  /// Most exports need no search.
  void search(CommandRun& /*run*/) override {}
  std::vector<Step> results(CommandRun& run) final;

 protected:
  /// Rows common to all: the problem file first, options of the run last.
  void describe_input(OptionTable& table);
  static void describe_output(OptionTable& table);

  [[nodiscard]] const std::string& file() const { return file_; }
  [[nodiscard]] const problems::ProblemText& text() const { return text_; }

  /// Writes the file, on rank 0, after the search.
  virtual void write(std::ostream& out) const = 0;

 private:
  std::string file_;
  problems::ProblemText text_;
};

}  // namespace kusabi::run
