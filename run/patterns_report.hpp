// What `kusabi patterns` says: the table for a person and the JSON for a program.
#pragma once

#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "engine/outcome.hpp"
#include "nodes/sign_pattern.hpp"
#include "problems/wedged_problem.hpp"
#include "run/patterns.hpp"

namespace kusabi::run {

/// As the result file calls it: "solved", "time-limit", ...
const char* status_name(engine::Status status);

/// What became of the nodes of a tree of sign patterns.
nlohmann::ordered_json tally_json(const nodes::SignPatternTally& tally);

/// Everything that the command has to tell.
struct PatternsReport {
  const PatternsOptions& options;
  const problems::WedgedProblem& problem;
  const engine::Outcome<nodes::SignPatternTree>& outcome;

  /// Living patterns first, then marginal, then undecided ones; each in the lexicographic order of
  /// their contact sets, whatever the tree looked like.
  std::vector<const nodes::Configuration*> sorted;

  PatternsReport(const PatternsOptions& options_, const problems::WedgedProblem& problem_,
                 const engine::Outcome<nodes::SignPatternTree>& outcome_);

  [[nodiscard]] nodes::SignPatternTally total() const;

  /// The patterns, the ranks' shares and the times, as text.
  [[nodiscard]] std::string table() const;

  /// The result file; its schema is in docs/result-files.md.
  [[nodiscard]] nlohmann::ordered_json json() const;

 private:
  [[nodiscard]] std::vector<std::string> names(std::uint64_t candidates) const;
};

}  // namespace kusabi::run
