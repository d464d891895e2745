// Certificates of splitting as static cuts: one for each column of T, whose share is known then;
// what remains of their proof is limit analysis (5) with smaller yield forces.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "nodes/limit/model/static_cut.hpp"
#include "nodes/limit/root/master.hpp"
#include "nodes/limit/splitting/column_blocks.hpp"

namespace kusabi::limit {

/// y_j and k_j of P_j = alpha w_j y_j and kappa_j. Every rank makes the same call.
/// @param point columns 1 to m
std::vector<StaticCut> cuts_of_point(const splitting::ColumnBlocks& point,
                                     const splitting::Sharing& sharing,
                                     const problems::LimitModel& model, double alpha);

/// Whether there is one cut for each column, in their order.
bool is_one_for_each(std::span<const StaticCut> cuts, const problems::LimitModel& model);

/// The proof with no sign decided, for yield forces smaller by `room`; where equilibrium leaves a
/// member no choice it has no room. Nothing if there is none.
/// @param for_all room for those as well
std::optional<StaticProof> proof_of_fixed_shares(const problems::LimitModel& model, double alpha,
                                                 std::span<const StaticCut> cuts, double room,
                                                 bool for_all);

}  // namespace kusabi::limit
