// What `kusabi mip` says: the table for a person and the JSON for a program.
#pragma once

#include <cstdint>
#include <ostream>
#include <string>

#include <nlohmann/json.hpp>

#include "nodes/zero_one/mixed_search.hpp"
#include "run/mip/mip.hpp"
#include "run/output/page.hpp"
#include "run/verdict/verdict.hpp"
#include "solvers/linear/program_file.hpp"

namespace kusabi::run {

struct MipReport {
  const MipOptions& options;
  const linear::ProgramFile& program;
  std::uint64_t fingerprint;
  const zero_one::MixedAnswer& found;

  /// No point has a better objective, as the file's sense has it.
  [[nodiscard]] double bound() const;
  [[nodiscard]] double objective() const;
  /// |objective - bound| / |objective|; the difference itself if the objective is zero.
  [[nodiscard]] double gap() const;

  [[nodiscard]] Verdict verdict() const;

  /// The point, the ranks' shares and the times, as text.
  [[nodiscard]] std::string table(const Page& page) const;

  /// The result file; its schema is in docs/result-files.md.
  [[nodiscard]] nlohmann::ordered_json json() const;

  /// A row a column of the program that is not zero at the point found; the header alone if the
  /// result file has no point.
  void write_csv(std::ostream& out) const;

 private:
  [[nodiscard]] double in_the_files_sense(double objective) const;
  [[nodiscard]] bool has_point() const;  // that is told
};

}  // namespace kusabi::run
