// What all of `kusabi export` have alike: a problem file is read, and a file is written, to
// standard output unless it is given a name.
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
  /// Most have nothing to search for.
  void search(CommandRun& /*run*/) override {}
  std::vector<Step> results(CommandRun& run) final;

 protected:
  /// The rows that all have: first the problem file, last the options of the run.
  void describe_input(OptionTable& table);
  static void describe_output(OptionTable& table);

  [[nodiscard]] const std::string& file() const { return file_; }
  [[nodiscard]] const problems::ProblemText& text() const { return text_; }

  /// On rank 0, when all is known.
  virtual void write(std::ostream& out) const = 0;

 private:
  std::string file_;
  problems::ProblemText text_;
};

}  // namespace kusabi::run
