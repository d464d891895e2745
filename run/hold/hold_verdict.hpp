// Verdict of `kusabi hold`.
#pragma once

#include "nodes/wedged/hold/load_program.hpp"
#include "run/hold/hold.hpp"
#include "run/verdict/verdict.hpp"

namespace kusabi::run {

Verdict hold_verdict(const HoldOptions& options, const wedged::LoadedProblem& loaded,
                     const HoldFindings& findings);

}  // namespace kusabi::run
