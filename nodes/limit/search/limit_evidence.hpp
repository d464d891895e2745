// Conversion of the solver's scaled results to a certificate in the units of the problem.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "nodes/limit/search/sign_tree.hpp"
#include "problems/limit/limit_problem.hpp"
#include "verify/limit/limit_certificate.hpp"
#include "verify/limit/limit_proof.hpp"
#include "verify/structure/structure.hpp"

namespace kusabi::limit {

/// @param root_cuts the cuts common to all nodes
/// @param alpha in the unit of force
verify::LimitCertificate limit_certificate(const problems::LimitProblem& problem,
                                           const problems::LimitModel& model, double alpha,
                                           const Worst& worst,
                                           const std::vector<StaticCut>& root_cuts,
                                           const std::vector<ClosedNode>& nodes);

/// A node of a certificate that has these cuts, in this order, all of them the node's.
/// @param node with shares `mu` of `cuts`
verify::LimitNode limit_node(const problems::LimitProblem& problem,
                             const problems::LimitModel& model, double alpha,
                             std::span<const StaticCut> cuts, const ClosedNode& node);

/// The truss with its exact directions and loads, and the half-widths of the certificate. Nothing
/// if the certificate is not one of this truss, so that its claims are not proved: a direction is
/// undefined (a bar of length almost zero).
std::optional<verify::LimitTruss> meant_truss(const verify::LimitCertificate& certificate,
                                              verify::Structure truss);

}  // namespace kusabi::limit
