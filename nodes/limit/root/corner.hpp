// Corners of the uncertain loads: nodes of the tree of signs whose signs leave one load only. The
// bound of a corner is the factor of this load, (5), and its proof a stress state under it.
#pragma once

#include <optional>
#include <span>

#include <Eigen/Core>

#include "nodes/limit/root/master.hpp"
#include "nodes/limit/splitting/safe_bound.hpp"

namespace kusabi::limit {

/// The first column of T whose undecided sign changes the load, i.e. alpha w_j > 0; -1: there is
/// none, the node is a corner.
int first_undecided(const problems::LimitModel& model, double alpha, const Signs& signs);

/// Number of such columns.
int undecided_count(const problems::LimitModel& model, double alpha, const Signs& signs);

/// zeta of a corner, m: alpha s_j; zero where the sign is undecided.
Eigen::VectorXd corner_load(double alpha, const Signs& signs);

/// The best state under the load of a corner for yield forces reduced by `room`, as in
/// proof_of_fixed_shares(). Nothing if there is none.
/// @param states of the model @param cuts of the node, which have no share
std::optional<StaticProof> proof_of_corner(splitting::SafeStates& states,
                                           const problems::LimitModel& model, double alpha,
                                           std::span<const StaticCut> cuts, const Signs& signs,
                                           double room, bool for_all);

}  // namespace kusabi::limit
