// What `kusabi patterns` says: the table for a person and the JSON for a program.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "engine/outcome.hpp"
#include "nodes/wedged/maximal_cones.hpp"
#include "nodes/wedged/sign_pattern.hpp"
#include "problems/wedged/wedged_problem.hpp"
#include "run/patterns/patterns.hpp"

namespace kusabi::run {

/// Everything that the command has to tell.
class PatternsReport {
 public:
  PatternsReport(const PatternsOptions& options, const problems::WedgedProblem& problem,
                 const engine::Outcome<wedged::SignPatternTree>& outcome);

  /// Leaves of which it could not be told whether they are patterns.
  [[nodiscard]] std::size_t open() const { return marginal_ + undecided_; }

  /// The patterns, the ranks' shares and the times, as text.
  [[nodiscard]] std::string table() const;

  /// The result file; its schema is in docs/result-files.md.
  [[nodiscard]] nlohmann::ordered_json json() const;

 private:
  // The candidates of a block and its maximal cones.
  struct Block {
    std::uint64_t candidates = 0;
    std::uint64_t cones = 0;
    std::uint64_t open = 0;

    [[nodiscard]] bool rests() const { return cones == 0 && open == 0; }
  };

  [[nodiscard]] wedged::SignPatternTally total() const;
  [[nodiscard]] std::uint64_t count() const;
  [[nodiscard]] std::uint64_t idle() const;
  [[nodiscard]] std::string list() const;
  [[nodiscard]] std::string verdict() const;

  const PatternsOptions& options_;
  const problems::WedgedProblem& problem_;
  const engine::Outcome<wedged::SignPatternTree>& outcome_;
  std::vector<wedged::Configuration> leaves_;  // the maximal cones, then the open leaves
  std::vector<Block> blocks_;
  std::size_t flat_ = 0, marginal_ = 0, undecided_ = 0;  // of leaves_
};

}  // namespace kusabi::run
