// The two ends of a worst case, put to the verifier: what is printed as proved has been proved
// here, in exact arithmetic, from the evidence that a certificate holds.
#pragma once

#include <limits>
#include <optional>
#include <vector>

#include "nodes/limit/root/limit_answer.hpp"
#include "nodes/limit/search/sign_tree.hpp"
#include "problems/limit/limit_problem.hpp"
#include "verify/limit/limit_certificate.hpp"
#include "verify/limit/limit_proof.hpp"
#include "verify/structure/structure.hpp"

namespace kusabi::limit {

/// What was found and is to be proved.
struct LimitEvidence {
  const verify::Structure& truss;  ///< the proofs are of this one, with its true directions
  const problems::LimitProblem& problem;
  const problems::LimitModel& model;
  double alpha = 0;  ///< in the unit of force
  const Worst& worst;
  const std::vector<StaticCut>& cuts;  ///< those that all nodes share
  std::vector<ClosedNode> nodes;       ///< which cover all signs
  /// What the nodes are thought to show, in the unit of the load factor; a proof of more is not
  /// looked for.
  double lower = std::numeric_limits<double>::infinity();
};

/// What is shown, with its evidence.
struct ProvedEnds {
  LimitEnds ends;  ///< in the unit of the load factor; an end that is not proved says nothing
  verify::LimitCertificate certificate;
};

/// Ends farther apart than this, in the scaled factor, do not answer the question: room made for a
/// proof costs about as much as it is wide.
inline constexpr double answered_gap = 1e-6;

/// Proves each node; where a proof fails for want of room, or shows less than `closed_gap` allows,
/// makes more room and tries again.
/// @param again whether to try again
ProvedEnds proved_ends(LimitEvidence evidence, bool again);

/// A number that lambda_min(alpha) is not above, by a motion; nothing if it shows none.
/// @param alpha in the unit of force @param zeta m @param motion n^d, scaled as in `model`
std::optional<double> proved_upper(const verify::Structure& truss,
                                   const problems::LimitProblem& problem,
                                   const problems::LimitModel& model, double alpha,
                                   const Eigen::VectorXd& zeta, const Eigen::VectorXd& motion);

/// The evidence that a load is carried at no factor; nothing if the motion does not show it.
/// @param alpha in the unit of force @param zeta m: zero, or of size alpha each
/// @param motion n^d, scaled as in `model` like zeta
std::optional<verify::LimitCertificate> evidence_of_no_factor(const verify::Structure& truss,
                                                              const problems::LimitProblem& problem,
                                                              const problems::LimitModel& model,
                                                              double alpha,
                                                              const Eigen::VectorXd& zeta,
                                                              const Eigen::VectorXd& motion);

}  // namespace kusabi::limit
