// Exact test of a list of patterns: JSON, and its part of a verdict.
#pragma once

#include <optional>

#include <nlohmann/json.hpp>

#include "answer/verdict.hpp"
#include "nodes/wedged/pattern_search.hpp"

namespace kusabi::run {

nlohmann::ordered_json exact_json(const wedged::ExactTest& test);

/// Nothing if the test was not called or has decided everything.
std::optional<answer::ExactRemainder> remainder_of(const wedged::ExactTest& test);

}  // namespace kusabi::run
