// The exact test of a list of patterns in a result file, and as a verdict has it.
#pragma once

#include <optional>

#include <nlohmann/json.hpp>

#include "nodes/wedged/pattern_search.hpp"
#include "run/verdict/verdict.hpp"

namespace kusabi::run {

nlohmann::ordered_json exact_json(const wedged::ExactTest& test);

/// Nothing if the test was not called for, or leaves no doubt.
std::optional<ExactDoubt> doubt_of(const wedged::ExactTest& test);

}  // namespace kusabi::run
