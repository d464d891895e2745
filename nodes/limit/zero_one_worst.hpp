// The worst case by the 0-1 program (29) of the limit paper: Algorithms 4.2 and 5.1 and what makes
// them faster, to compare with static cuts.
#pragma once

#include <cstdint>
#include <optional>

#include "engine/campaign.hpp"
#include "nodes/limit/limit_question.hpp"
#include "nodes/limit/worst_case.hpp"
#include "problems/limit/limit_analysis.hpp"

namespace kusabi::limit {

/// What came of it, in the scaled units of the model.
struct ZeroOneWorst {
  Worst worst;
  double lower = 0;  ///< as the 0-1 tree has it: not proved
  std::uint64_t nodes = 0;
  std::uint64_t programs = 0;  ///< linear programs, at the root and in the tree
  std::uint64_t cuts = 0;      ///< disjunctive ones kept, and static ones
  std::uint64_t cut_programs = 0;
  engine::Status status = engine::Status::solved;  ///< why the search ended
};

/// Solves (29) on all ranks; the same on each.
/// @param alpha scaled
/// @param root what static cuts have found: they say which M is safe, and know a collapse
/// @return nothing if no safe M is found
/// @throws BigMTooSmall on every rank if the question's M leaves no point
std::optional<ZeroOneWorst> zero_one_worst(engine::Campaign& campaign,
                                           const LimitQuestion& question,
                                           const problems::LimitModel& model, double alpha,
                                           const RootResult& root, LoadFactor& load_factor);

}  // namespace kusabi::limit
