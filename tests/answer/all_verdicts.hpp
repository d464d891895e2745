// All states of a verdict: each kind of answer, each bound proved, computed or absent, each end of
// a search.
#pragma once

#include <vector>

#include "answer/verdict.hpp"

namespace kusabi::answer::testing {

std::vector<Verdict> all_verdicts();

}  // namespace kusabi::answer::testing
