// What `kusabi patterns` says: the table for a person and the JSON for a program.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "engine/outcome.hpp"
#include "nodes/faces.hpp"
#include "nodes/sign_pattern.hpp"
#include "problems/wedged_problem.hpp"
#include "run/patterns.hpp"

namespace kusabi::run {

/// What became of the nodes of a tree of sign patterns.
nlohmann::ordered_json tally_json(const nodes::SignPatternTally& tally);

/// Everything that the command has to tell.
struct PatternsReport {
  const PatternsOptions& options;
  const problems::WedgedProblem& problem;
  const engine::Outcome<nodes::SignPatternTree>& outcome;

  /// A leaf that is listed, and, if it is degenerate, the living pattern that contains it.
  struct Entry {
    const nodes::Configuration* leaf;
    std::optional<nodes::Face> face;
  };

  /// Living patterns first, then degenerate, marginal and undecided ones; each in the lexicographic
  /// order of their contact sets, whatever the tree looked like.
  std::vector<Entry> sorted;
  std::size_t degenerate = 0;  ///< of the marginal leaves

  PatternsReport(const PatternsOptions& options_, const problems::WedgedProblem& problem_,
                 std::span<const double> friction,
                 const engine::Outcome<nodes::SignPatternTree>& outcome_);

  [[nodiscard]] nodes::SignPatternTally total() const;

  /// The patterns, the ranks' shares and the times, as text.
  [[nodiscard]] std::string table() const;

  /// The result file; its schema is in docs/result-files.md.
  [[nodiscard]] nlohmann::ordered_json json() const;

 private:
  [[nodiscard]] std::size_t place_of(std::uint64_t contact) const;
};

}  // namespace kusabi::run
