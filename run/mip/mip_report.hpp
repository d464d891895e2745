// What `kusabi mip` says: the table for a person and the JSON for a program.
#pragma once

#include <cstdint>
#include <string>

#include <nlohmann/json.hpp>

#include "engine/outcome.hpp"
#include "nodes/zero_one/tree.hpp"
#include "run/mip/mip.hpp"
#include "solvers/linear/program_file.hpp"

namespace kusabi::run {

/// An answer is optimal if objective and bound differ by no more than this part of the objective's
/// size (ObjectiveSteps::size). Objectives are told apart in steps of at most 2^-30, or 9.3e-10, of
/// it, and the bound of a whole search is half a step below the objective: ten steps leave room for
/// that and hide nothing.
inline constexpr double optimality_tolerance = 1e-8;

/// What was found out about the program.
enum class MipAnswer {
  optimal,     ///< a point, and no other is better by more than the tolerance
  feasible,    ///< a point; it is not known whether there is a better one
  infeasible,  ///< no point satisfies all rows, bounds and binaries
  unbounded,   ///< points of any objective, however good
  unknown,     ///< no point was found, and it is not known that there is none
};

struct MipReport {
  const MipOptions& options;
  const linear::ProgramFile& program;
  std::uint64_t fingerprint;
  const zero_one::ZeroOneTree& tree;
  const engine::Outcome<zero_one::ZeroOneTree>& outcome;
  bool unbounded = false;

  [[nodiscard]] MipAnswer answer() const;
  [[nodiscard]] const zero_one::ZeroOnePoint* point() const;
  [[nodiscard]] zero_one::ZeroOneTally total() const;

  /// No point has a better objective, as the file's sense has it.
  [[nodiscard]] double bound() const;
  [[nodiscard]] double objective() const;
  /// Whether the question is answered: not stopped, and nothing left open.
  [[nodiscard]] bool answered() const;
  /// |objective - bound| / |objective|; the difference itself if the objective is zero.
  [[nodiscard]] double gap() const;
  /// Whether the bound holds in spite of rounding.
  [[nodiscard]] bool proved() const;

  /// The answer, the point, the ranks' shares and the times, as text.
  [[nodiscard]] std::string table() const;

  /// The result file; its schema is in docs/result-files.md.
  [[nodiscard]] nlohmann::ordered_json json() const;

 private:
  [[nodiscard]] double in_the_files_sense(double objective) const;
  [[nodiscard]] std::string verdict() const;
  [[nodiscard]] std::string doubts() const;
};

}  // namespace kusabi::run
