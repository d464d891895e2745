// From what the solver found, in its scaled units, to the certificate that verify/ can prove, in
// those of the problem.
#pragma once

#include <vector>

#include "nodes/limit/sign_tree.hpp"
#include "problems/limit/limit_problem.hpp"
#include "verify/limit_certificate.hpp"

namespace kusabi::run {

/// @param root_cuts the cuts that all nodes share
/// @param alpha in the unit of force
verify::LimitCertificate limit_certificate(const problems::LimitProblem& problem,
                                           const problems::LimitModel& model, double alpha,
                                           const limit::Worst& worst,
                                           const std::vector<limit::StaticCut>& root_cuts,
                                           const std::vector<limit::ClosedNode>& nodes);

}  // namespace kusabi::run
