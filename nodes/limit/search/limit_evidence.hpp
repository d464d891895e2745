// Conversion of the solver's scaled results to theorems in the units of the problem.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "nodes/limit/search/sign_tree.hpp"
#include "problems/limit/limit_problem.hpp"
#include "verify/limit/truss_certificate.hpp"
#include "verify/structure/structure.hpp"

namespace kusabi::limit {

/// The evidence of a theorem on the largest factors, without its truss.
/// @param root_cuts the cuts common to all nodes
/// @param alpha in the unit of force
verify::TrussTheorem theorem_of(const problems::LimitProblem& problem,
                                const problems::LimitModel& model, double alpha, const Worst& worst,
                                const std::vector<StaticCut>& root_cuts,
                                const std::vector<ClosedNode>& nodes);

/// Makes a theorem on the largest factors for the opposite reference load one on least factors.
void of_least_factors(verify::TrussTheorem& theorem);

/// A node of a theorem that has these cuts, in this order, all of them the node's.
/// @param node with shares `mu` of `cuts`
verify::LimitNode limit_node(const problems::LimitProblem& problem,
                             const problems::LimitModel& model, double alpha,
                             std::span<const StaticCut> cuts, const ClosedNode& node);

/// @param zeta m, of which the signs count @param motion n^d, in units
verify::CollapseMotion collapse_of(const problems::LimitProblem& problem, double alpha,
                                   std::vector<std::size_t> lost, const Eigen::VectorXd& zeta,
                                   const Eigen::VectorXd& motion);

/// The truss with the uncertain loads of the problem, in its order, and with the half-widths of the
/// search. Nothing if these loads are not those of the truss.
std::optional<verify::Structure> with_loads(verify::Structure truss,
                                            const problems::LimitProblem& problem, double alpha);

}  // namespace kusabi::limit
