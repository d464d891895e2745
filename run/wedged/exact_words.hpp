// What is said of the exact test of a list of patterns.
#pragma once

#include <string>

#include <nlohmann/json.hpp>

#include "nodes/wedged/pattern_search.hpp"

namespace kusabi::run {

/// Why the list is not to be relied on. @pre test.leaves_doubt()
std::string exact_doubt(const wedged::ExactTest& test);

nlohmann::ordered_json exact_json(const wedged::ExactTest& test);

}  // namespace kusabi::run
