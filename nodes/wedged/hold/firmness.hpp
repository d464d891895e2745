// Firmness of wedged patterns: the load that each can hold per unit of its normal reactions
// (docs/theory/loads.md, "Firmness").
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "engine/analysis/analysis.hpp"
#include "nodes/wedged/hold/hold_search.hpp"
#include "nodes/wedged/hold/load_program.hpp"
#include "nodes/wedged/relaxation/sign_pattern.hpp"

namespace kusabi::wedged {

/// Factors of the reference load alone, without clearances, at which a pattern has a state whose
/// normal reactions add up to 1: all between `low` and `high`, proved, and none from `low_out` down
/// and `high_out` up, proved if they are finite. Infinite `low` and `high`: no end.
struct Firmness {
  double low_out = 0, low = 0;
  double high = 0, high_out = 0;
};

/// Firmness of one pattern after another, on this rank.
class PatternFirmness {
 public:
  /// @pre `analysis` outlives this object. Its limits do not interrupt a pattern.
  PatternFirmness(engine::Analysis& analysis, const LoadedProblem& loaded, double mu);

  /// Nothing for a leaf without margin, and where the load does not act.
  [[nodiscard]] std::optional<Firmness> of(const Configuration& leaf) const;

 private:
  engine::Analysis& analysis_;
  double mu_;
  bool out_of_equilibrium_;
  HoldParameters parameters_;
  std::vector<support::IndexSet> candidates_;  // of each block
  std::vector<LoadedProblem> blocks_;
};

/// Every rank makes the same call. @param leaves on rank 0
/// @returns PatternFirmness::of() each leaf, in their order; empty if the analysis was stopped
std::vector<std::optional<Firmness>> firmness_of_patterns(engine::Analysis& analysis,
                                                          const LoadedProblem& loaded, double mu,
                                                          std::span<const Configuration> leaves);

}  // namespace kusabi::wedged
