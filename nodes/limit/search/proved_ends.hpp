// Proof of the lower and upper bound of a worst case by the verifier, in exact arithmetic and from
// the evidence of a theorem. All bounds printed as proved come from here.
#pragma once

#include <limits>
#include <optional>
#include <vector>

#include "nodes/limit/root/limit_answer.hpp"
#include "nodes/limit/search/sign_tree.hpp"
#include "problems/limit/limit_problem.hpp"
#include "verify/limit/truss_certificate.hpp"
#include "verify/structure/structure.hpp"

namespace kusabi::limit {

/// Results to be proved.
struct LimitEvidence {
  const verify::Structure& truss;  ///< with exact directions, for the proofs
  const problems::LimitProblem& problem;
  const problems::LimitModel& model;
  double alpha = 0;  ///< in the unit of force
  const Worst& worst;
  const std::vector<StaticCut>& cuts;  ///< common to all nodes
  std::vector<ClosedNode> nodes;       ///< cover all signs
  linear::Basis nominal_basis;         ///< of (5), for states of corners; empty: unknown
  /// The expected lower bound, in the unit of the load factor; no better proof is attempted.
  double lower = std::numeric_limits<double>::infinity();
};

/// The proved bounds with their evidence.
struct ProvedEnds {
  support::Bracket ends;         ///< in the unit of the load factor; what is not proved is open
  verify::TrussTheorem theorem;  ///< on the largest factors, of this truss
};

/// Gap of the scaled factor up to which the result counts as an answer: a margin for a proof costs
/// about its own size.
inline constexpr double answered_gap = 1e-6;

/// Proves each node; where a proof fails for lack of a margin, or its bound is worse than
/// `closed_gap` allows, it is repeated with a larger margin.
/// @param again whether to repeat
ProvedEnds proved_ends(LimitEvidence evidence, bool again);

/// A proved upper bound of lambda_min(alpha), by a motion; nothing if there is none.
/// @param alpha in the unit of force @param zeta m @param motion n^d, scaled as in `model`
std::optional<double> proved_upper(const verify::Structure& truss,
                                   const problems::LimitProblem& problem,
                                   const problems::LimitModel& model, double alpha,
                                   const Eigen::VectorXd& zeta, const Eigen::VectorXd& motion);

/// The theorem that a load has no factor; nothing if the motion does not prove it.
/// @param alpha in the unit of force @param zeta m: zero, or of size alpha each
/// @param motion n^d, scaled as in `model` like zeta
std::optional<verify::TrussTheorem> evidence_of_no_factor(const verify::Structure& truss,
                                                          const problems::LimitProblem& problem,
                                                          const problems::LimitModel& model,
                                                          double alpha, const Eigen::VectorXd& zeta,
                                                          const Eigen::VectorXd& motion);

}  // namespace kusabi::limit
