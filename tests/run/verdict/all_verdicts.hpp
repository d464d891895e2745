// Every state a verdict can be in: each kind of answer, each bound proved, computed or absent, each
// way a search ends.
#pragma once

#include <vector>

#include "run/verdict/verdict.hpp"

namespace kusabi::run::testing {

std::vector<Verdict> all_verdicts();

}  // namespace kusabi::run::testing
