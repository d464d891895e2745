// Swept: quantity of a sweep, friction coefficients of a wedged problem or uncertainty of the loads
// of a truss, with the stages of a subcommand that depend on it.
#pragma once

#include <memory>
#include <optional>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

#include "engine/options.hpp"
#include "run/command/command_run.hpp"
#include "run/command/problem_input.hpp"
#include "run/output/output_file.hpp"

namespace kusabi::run {

/// Options as in the call.
struct SweepOptions {
  ProblemInput input;
  std::vector<double> mu;        ///< friction coefficients; may be empty
  std::optional<double> mu_max;  ///< the largest coefficient
  double width = 1e-8;           ///< of the brackets of friction coefficients
  std::vector<double> alpha;     ///< half-widths; none: friction is swept
  std::string load_case;         ///< load case of a truss; empty: the file has one
  /// Half-widths of groups of loads of a truss, which are not swept.
  std::vector<std::pair<std::string, double>> group_alpha;
  std::string certificates;  ///< their folder; empty: none
  bool prove = false;        ///< comparison of the counts with proved lists of patterns
  engine::Limits limits;
  CheckpointChoice checkpoint;

  /// The largest friction coefficient.
  [[nodiscard]] double maximum() const { return mu_max.value_or(mu.empty() ? 0 : mu.back()); }
};

class Swept {
 public:
  Swept() = default;
  Swept(const Swept&) = delete;
  Swept& operator=(const Swept&) = delete;
  virtual ~Swept() = default;

  virtual void prepare(CommandRun& run) = 0;
  [[nodiscard]] virtual std::string announcement(const std::string& ranks) const = 0;
  virtual void search(CommandRun& run) = 0;

  // JSON of the answer, on rank 0.
  [[nodiscard]] virtual nlohmann::ordered_json json(CommandRun& run) const = 0;
  virtual void write_csv(std::ostream& out) const = 0;
  // Writes certificates that the search has not written, on rank 0.
  virtual void write_certificates(OutputFolder& /*folder*/) const {}
  [[nodiscard]] virtual std::string table() const = 0;
  [[nodiscard]] virtual answer::Verdict verdict() const = 0;
};

/// The options must outlive it.
std::unique_ptr<Swept> swept_friction(const SweepOptions& options);
std::unique_ptr<Swept> swept_loads(const SweepOptions& options);

}  // namespace kusabi::run
