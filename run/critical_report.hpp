// What `kusabi critical` says: the table for a person and the JSON for a program.
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "nodes/critical_friction.hpp"
#include "nodes/sign_pattern.hpp"
#include "problems/wedged_problem.hpp"
#include "run/critical.hpp"

namespace kusabi::run {

/// A pattern that begins to live within a bracket of the friction coefficient.
struct CriticalEntry {
  nodes::SignPattern pattern;
  double lower = 0;                  ///< dead here
  double upper = 0;                  ///< alive here
  std::vector<double> reaction;      ///< at `upper`; empty if it was not asked for
  std::vector<double> displacement;  ///< likewise
};

/// What was found, on rank 0.
struct CriticalFindings {
  std::string status = "solved";
  std::vector<CriticalEntry> patterns;  ///< smallest first; of the global search, one or none
  double lower = 0;                     ///< nothing lives here
  std::optional<double> upper;          ///< something does; nothing: not up to the largest
  std::uint64_t doubtful = 0;           ///< patterns of which nothing is proved from `lower` on
  nlohmann::ordered_json statistics;
  std::string ranks;  ///< the table of the ranks

  /// Sorts the patterns and reads the bracket from them and from what is known beside.
  /// @param dead nothing lives below, but for the patterns
  void conclude(double dead);
};

/// The result as text.
std::string critical_table(const CriticalOptions& options, const problems::WedgedProblem& problem,
                           const CriticalFindings& findings);

/// The result file; its schema is in docs/result-files.md.
nlohmann::ordered_json critical_json(const CriticalOptions& options,
                                     const problems::WedgedProblem& problem,
                                     const CriticalFindings& findings);

}  // namespace kusabi::run
