// The worst case by the 0-1 program (29) of the limit paper: Algorithms 4.2 and 5.1 and what makes
// them faster, to compare with static cuts.
#pragma once

#include <cstdint>
#include <optional>

#include "engine/budget.hpp"
#include "engine/outcome.hpp"
#include "nodes/limit/worst_case.hpp"
#include "problems/limit/limit_analysis.hpp"
#include "run/limit/limit.hpp"
#include "run/session/session.hpp"

namespace kusabi::run {

/// What came of it, in the scaled units of the model.
struct MixedWorst {
  limit::Worst worst;
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
/// @throws WrongInput if the M of the call is too small for any point
std::optional<MixedWorst> solve_mixed(Session& session, const LimitOptions& options,
                                      const problems::LimitModel& model, double alpha,
                                      const limit::RootResult& root, limit::LoadFactor& load_factor,
                                      const engine::Budget& budget);

}  // namespace kusabi::run
