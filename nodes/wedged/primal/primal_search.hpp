// A pattern without a tree: which candidates in contact make something wedge at little friction.
// Trials linearise complementarity from many starts and then from the best pattern, at ever lower
// coefficients; large blocks are tried in clusters first. What is found is feasible by its own
// program and bounds the critical coefficient from above; that nothing better exists it never says
// (docs/theory/wedged.md, "Primal heuristic").
//
// Trials come in rounds. The ranks share the trials of a round, and the best of it depends on no
// timing: any number of ranks finds the same, unless the budget ends it.
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
inline constexpr int fewest_to_cluster = 200;

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

struct PrimalQuestion {
  double infeasible = 0;  ///< nothing wedges up to here
  double most = 0;        ///< no coefficient above is of interest
  double enough = 0;      ///< the search ends with a pattern that is feasible here
  double from = 8;        ///< where starts are tried while no pattern is known
  PrimalPattern known;    ///< the best so far
};

struct PrimalFindings {
  PrimalPattern best;  ///< unknown: none was found
  std::uint64_t programs = 0;
};

/// Every rank makes the same call and gets the same.
/// @param block a problem of one block  @param better called for each better pattern, on all ranks
PrimalFindings search_primal(engine::Analysis& analysis, const problems::WedgedProblem& block,
                             const PrimalQuestion& question,
                             const std::function<void(const PrimalPattern&)>& better = {});

}  // namespace kusabi::wedged
