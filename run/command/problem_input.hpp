// ProblemInput: the problem file of a subcommand, read on rank 0 for all. Each rank parses it by
// itself, since the same text gives the same bits everywhere.
#pragma once

#include <string>

#include "problems/files/problem_text.hpp"
#include "problems/files/structure_file.hpp"

namespace kusabi::run {

class CommandRun;

struct ProblemInput {
  std::string file;  ///< name in the call
  problems::ProblemText text;

  /// @throws support::InputError on every rank
  void read(CommandRun& run);
  /// The structure of the file, whose warnings are printed.
  /// @throws support::InputError on every rank
  [[nodiscard]] problems::CheckedStructure structure(CommandRun& run) const;
  [[nodiscard]] problems::StructureAndFacets structure_and_facets(CommandRun& run) const;
};

}  // namespace kusabi::run
