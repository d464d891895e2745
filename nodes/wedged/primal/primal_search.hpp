// Primal heuristic: sign patterns that are feasible at small friction coefficients, without a tree
// (docs/theory/wedged.md, "Primal heuristic"). Trials linearise complementarity from many starts
// and then from the best pattern, at decreasing coefficients; large blocks are first reduced to
// clusters of candidates. A pattern found is feasible by its own cone program, which gives an upper
// bound of the critical coefficient; the heuristic proves no lower bound.
//
// The ranks share the trials of a round. Results do not depend on timing: any number of ranks finds
// the same, unless the budget ends the search.
#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <optional>

#include "engine/analysis/analysis.hpp"
#include "problems/wedged/wedged_problem.hpp"
#include "support/index_set.hpp"

namespace kusabi::wedged {

/// Blocks with fewer candidates need no clusters.
inline constexpr int min_candidates_for_clusters = 200;

/// A pattern with these candidates in contact and all others separated.
struct PrimalPattern {
  double factor = std::numeric_limits<double>::infinity();  ///< feasible at and above
  support::IndexSet contact;

  [[nodiscard]] bool is_known() const { return !contact.empty(); }

  template <class Archive>
  void serialize(Archive& archive, unsigned /*version*/) {
    archive& factor& contact;
  }
};

/// Parts of the search: `first` begins with the patterns of clusters, `later` with modes of all
/// candidates. Blocks without clusters have a first part only.
enum class PrimalPart { first, later, both };

struct PrimalParameters {
  double infeasible = 0;  ///< no pattern is feasible up to this coefficient
  double maximum = 0;     ///< no coefficient above is of interest
  double enough = 0;      ///< the search ends with a pattern that is feasible at this coefficient
  double from = 8;        ///< coefficient of the first trials while no pattern is known
  PrimalPattern known;    ///< best known pattern
  PrimalPart part = PrimalPart::both;
};

struct PrimalFindings {
  PrimalPattern best;  ///< unknown: none was found
  std::uint64_t programs = 0;
};

/// Every rank makes the same call and gets the same result.
/// @param block a problem of one block  @param better called for each better pattern, on all ranks
PrimalFindings search_primal(engine::Analysis& analysis, const problems::WedgedProblem& block,
                             const PrimalParameters& parameters,
                             const std::function<void(const PrimalPattern&)>& better = {});

}  // namespace kusabi::wedged
