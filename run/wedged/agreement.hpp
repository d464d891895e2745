// All ranks work a problem out by themselves from the same text; before they search it together
// they compare what they have got, bit by bit: a machine of another kind, or another build on one
// of them, may round differently, and then its part of the tree is that of another problem.
#pragma once

#include "problems/wedged/wedged_problem.hpp"
#include "run/session/session.hpp"

namespace kusabi::run {

/// @throws engine::Disagreement on every rank unless stiffness, compliance and all else of the
/// problem are
///   the same on all of them
void agree(Session& session, const problems::WedgedProblem& problem);

}  // namespace kusabi::run
