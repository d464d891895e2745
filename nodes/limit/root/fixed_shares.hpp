// Certificates of splitting as static cuts: one for each column of T with a known share; the rest
// of their proof is limit analysis (5) with reduced yield forces.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "nodes/limit/model/static_cut.hpp"
#include "nodes/limit/root/master.hpp"
#include "nodes/limit/splitting/column_blocks.hpp"
#include "nodes/limit/splitting/safe_bound.hpp"

namespace kusabi::limit {

/// y_j and k_j of P_j = alpha w_j y_j and kappa_j. Every rank makes the same call.
/// @param point columns 1 to m
std::vector<StaticCut> cuts_of_point(const splitting::ColumnBlocks& point,
                                     const splitting::Sharing& sharing,
                                     const problems::LimitModel& model, double alpha);

/// True if there is one cut for each column, in their order.
bool is_one_for_each(std::span<const StaticCut> cuts, const problems::LimitModel& model);

/// The proof without decided signs, for yield forces reduced by `room`; members whose force is
/// determined by equilibrium are not reduced. Nothing if there is none.
/// @param states of the model @param for_all reduction for those as well
std::optional<StaticProof> proof_of_fixed_shares(splitting::SafeStates& states,
                                                 const problems::LimitModel& model, double alpha,
                                                 std::span<const StaticCut> cuts, double room,
                                                 bool for_all);

}  // namespace kusabi::limit
