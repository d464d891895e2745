// What can be swept: friction coefficients of a wedged problem, or the uncertainty of a truss's
// loads. Each has the stages of a subcommand that hang on which it is.
#pragma once

#include <memory>
#include <optional>
#include <ostream>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "engine/options.hpp"
#include "problems/structure/model/structure.hpp"
#include "run/command/command_run.hpp"

namespace kusabi::run {

/// As the call has them.
struct SweepOptions {
  std::string file;
  std::string mu;                ///< points of the friction coefficient; empty: none
  std::optional<double> mu_max;  ///< the largest coefficient
  double width = 1e-8;           ///< of the brackets of friction coefficients
  std::string alpha;             ///< points of the uncertainty; empty: friction is swept
  std::string load_case;         ///< of a truss; empty: the file has one
  std::string group_alpha;       ///< of a truss: half-widths of some groups, which are not swept
  bool prove = false;            ///< whether the counts are held against proved lists of patterns
  engine::Limits limits;
  CheckpointChoice checkpoint;
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

  // Of the answer, on rank 0.
  [[nodiscard]] virtual nlohmann::ordered_json json() const = 0;
  virtual void write_csv(std::ostream& out) const = 0;
  [[nodiscard]] virtual std::string table() const = 0;
  [[nodiscard]] virtual Verdict verdict() const = 0;
};

/// @param structure of the file @param points increasing; may be empty @param most the largest
std::unique_ptr<Swept> swept_friction(const SweepOptions& options, problems::Structure structure,
                                      std::vector<double> points, double most);

/// @param points increasing, at least one
std::unique_ptr<Swept> swept_loads(const SweepOptions& options, problems::Structure truss,
                                   std::vector<double> points);

}  // namespace kusabi::run
