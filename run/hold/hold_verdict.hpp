// Verdict of `kusabi hold`.
#pragma once

#include "answer/verdict.hpp"
#include "nodes/wedged/hold/load_program.hpp"
#include "run/hold/hold.hpp"

namespace kusabi::run {

answer::Verdict hold_verdict(const HoldOptions& options, const wedged::LoadedProblem& loaded,
                             const HoldFindings& findings);

}  // namespace kusabi::run
