// The same contact problem with fewer candidates: those that respond alike are one, with the mean
// of their motions and their reactions shared evenly. Its patterns are estimates for the whole
// problem.
#pragma once

#include <vector>

#include "problems/wedged/wedged_problem.hpp"
#include "support/index_set.hpp"

namespace kusabi::wedged {

/// Candidates in clusters.
struct Clusters {
  std::vector<int> cluster_of;      ///< of each candidate
  problems::WedgedProblem problem;  ///< of one block, without a structure

  /// The candidates of these clusters.
  [[nodiscard]] support::IndexSet members(const support::IndexSet& clusters) const;
};

/// Clusters by the correlation of candidates in F_nn, without coordinates.
/// @param block a problem of one block with no fewer candidates than clusters
Clusters clusters_of(const problems::WedgedProblem& block, int count);

}  // namespace kusabi::wedged
