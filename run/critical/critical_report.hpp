// What `kusabi critical` says: the table for a person and the JSON for a program.
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "nodes/wedged/sign_pattern.hpp"
#include "problems/wedged/wedged_problem.hpp"
#include "run/critical/critical.hpp"

namespace kusabi::run {

/// A pattern that begins to live within a bracket of the friction coefficient.
struct CriticalEntry {
  std::uint32_t block = 0;
  wedged::SignPattern pattern;
  double lower = 0;                  ///< dead here
  std::optional<double> upper;       ///< alive here; nothing: not known to be anywhere
  std::vector<double> reaction;      ///< of the block at `upper`; empty if it was not asked for
  std::vector<double> displacement;  ///< likewise
};

/// What was found, on rank 0.
struct CriticalFindings {
  std::string status = "solved";        ///< of the searches
  std::vector<CriticalEntry> patterns;  ///< smallest first; of the global search those that live at
                                        ///< the upper end
  double lower = 0;                     ///< nothing lives here, nor below
  std::optional<double> upper;          ///< something does; nothing: not up to the largest
  bool lower_proved = false;            ///< every sign pattern was proved dead at `lower`
  bool upper_proved = false;            ///< a solid cone was proved to live at `upper`
  /// What is left open, a sentence each.
  std::vector<std::string> open;
  nlohmann::ordered_json statistics = {};
  std::string ranks = {};  ///< the table of the ranks

  /// Sorts the patterns and reads the bracket from them and from what is known beside.
  /// @param dead nothing lives below, but for the patterns
  void conclude(double dead);

  [[nodiscard]] bool answered() const { return status == "solved" && open.empty(); }
};

/// The result as text.
std::string critical_table(const CriticalOptions& options, const problems::WedgedProblem& problem,
                           const CriticalFindings& findings);

/// The result file; its schema is in docs/result-files.md.
nlohmann::ordered_json critical_json(const CriticalOptions& options,
                                     const problems::WedgedProblem& problem,
                                     const CriticalFindings& findings);

}  // namespace kusabi::run
