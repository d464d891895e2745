// Contradiction by the equilibrium of rigid bodies alone, at nodes with wedged configurations,
// whose multipliers cannot all be strict (docs/theory/loads.md, "The node program").
#pragma once

#include <optional>
#include <span>

#include <Eigen/Core>

#include "nodes/wedged/hold/load_program.hpp"
#include "nodes/wedged/relaxation/contact_solver.hpp"
#include "support/index_set.hpp"

namespace kusabi::wedged {

/// Candidates of C, those with a reaction.
struct ReactingCandidates {
  /// Those whose reactions may be of any size, and loads whose amounts may be, numbered after the
  /// candidates.
  support::IndexSet wedged;
  support::IndexSet others;
};

/// Coefficients beta of the modes of the block with w = G beta = 0 at the wedged candidates,
/// w_n + mu ||w_t|| < 0 at the others and beta'b < 0 for every other load: below the node the
/// others have no reaction, and these loads do not act. Displacements below the rounding of the
/// file count as zero. @returns nothing if there are none
std::optional<Eigen::VectorXd> rigid_contradiction(const LoadedProblem& block,
                                                   std::span<const LoadShare> shares, double mu,
                                                   Precision precision,
                                                   const ReactingCandidates& candidates);

}  // namespace kusabi::wedged
