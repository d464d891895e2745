// All states of a verdict: each kind of answer, each bound proved, computed or absent, each end of
// a search.
#pragma once

#include <vector>

#include "run/verdict/verdict.hpp"

namespace kusabi::run::testing {

std::vector<Verdict> all_verdicts();

}  // namespace kusabi::run::testing
