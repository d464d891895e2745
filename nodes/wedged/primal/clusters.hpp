// Reduced contact problem: candidates with similar response form a cluster, a single candidate with
// the mean of their displacements, whose reaction is shared evenly. Its patterns are estimates for
// the whole problem.
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
