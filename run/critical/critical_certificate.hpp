// The certificates of both ends of a critical friction coefficient: NAME.lower and NAME.upper.
#pragma once

#include "nodes/wedged/critical_ends.hpp"
#include "problems/wedged/wedged_problem.hpp"
#include "run/critical/critical.hpp"
#include "run/session/session.hpp"

namespace kusabi::run {

/// Nothing is recorded if no certificate is asked for. All must outlive what is returned.
wedged::EndRecorder end_recorder(Session& session, const CriticalOptions& options,
                                 const problems::WedgedProblem& problem);

}  // namespace kusabi::run
