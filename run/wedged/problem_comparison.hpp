// The same problem on all ranks. Each rank prepares it from the same text; machines of different
// kinds may round differently, and a part of the tree would then belong to another problem.
#pragma once

#include "problems/wedged/wedged_problem.hpp"
#include "run/session/session.hpp"

namespace kusabi::run {

/// Replaces stiffness and compliance by those of rank 0 if they differ in a single bit. (The
/// displacements under unit reactions are used on rank 0 only.)
/// @throws engine::RankMismatch on every rank unless all have the same input
void make_equal_on_all_ranks(Session& session, problems::WedgedProblem& problem);

}  // namespace kusabi::run
