// What `kusabi patterns` says: the table for a person and the JSON for a program.
#pragma once

#include <cstddef>
#include <ostream>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "nodes/wedged/pattern_search.hpp"
#include "problems/wedged/wedged_problem.hpp"
#include "run/patterns/patterns.hpp"
#include "run/wedged/whole_state_json.hpp"

namespace kusabi::run {

/// Everything that the command has to tell.
class PatternsReport {
 public:
  PatternsReport(const PatternsOptions& options, const problems::WedgedProblem& problem,
                 const wedged::PatternFindings& findings)
      : options_(options), problem_(problem), findings_(findings) {}

  /// The patterns, the ranks' shares and the times, as text.
  [[nodiscard]] std::string table() const;

  /// The result file; its schema is in docs/result-files.md. @param whole of the same structure
  [[nodiscard]] nlohmann::ordered_json json(const WholeStateJson& whole) const;

  /// A row a pattern, in the order of the result file.
  void write_csv(std::ostream& out) const;

 private:
  /// The leaves as they are listed.
  [[nodiscard]] std::vector<std::size_t> order() const;
  [[nodiscard]] std::string list() const;
  [[nodiscard]] std::string sentence() const;
  [[nodiscard]] double least_friction_of(const wedged::Configuration& leaf) const;
  [[nodiscard]] std::string candidates() const;
  [[nodiscard]] nlohmann::ordered_json candidates_json() const;
  [[nodiscard]] std::string verdict() const;

  const PatternsOptions& options_;
  const problems::WedgedProblem& problem_;
  const wedged::PatternFindings& findings_;
};

}  // namespace kusabi::run
