// Results of `kusabi mip`: table and JSON.
#pragma once

#include <cstdint>
#include <ostream>
#include <string>

#include <nlohmann/json.hpp>

#include "answer/verdict.hpp"
#include "nodes/zero_one/mixed_search.hpp"
#include "run/mip/mip.hpp"
#include "run/output/terminal_page.hpp"
#include "solvers/linear/program_file.hpp"

namespace kusabi::run {

struct MipReport {
  const MipOptions& options;
  const linear::ProgramFile& program;
  std::uint64_t fingerprint;
  const zero_one::MixedAnswer& found;

  /// No point has a better objective, in the sense of the file.
  [[nodiscard]] double bound() const;
  [[nodiscard]] double objective() const;
  /// |objective - bound| / |objective|; the absolute difference if the objective is zero.
  [[nodiscard]] double gap() const;

  [[nodiscard]] answer::Verdict verdict() const;

  /// The point, rank statistics and times, as text.
  [[nodiscard]] std::string table(const Page& page) const;

  /// The result file; its schema is in docs/result-files.md.
  [[nodiscard]] nlohmann::ordered_json json() const;

  /// One row per nonzero column at the point found; the header alone without a point.
  void write_csv(std::ostream& out) const;

 private:
  [[nodiscard]] double in_the_files_sense(double objective) const;
  [[nodiscard]] support::Standing standing() const;
  [[nodiscard]] bool has_point() const;  // the result file has a point
};

}  // namespace kusabi::run
