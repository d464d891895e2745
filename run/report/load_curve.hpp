// A curve of load factors on a page: its linear pieces and its end.
#pragma once

#include <string>

#include "pictures/html/markup.hpp"
#include "run/results/result_reader.hpp"

namespace kusabi::run {

/// Table of the pieces under `key` of the result, with all digits and the standing of each; nothing
/// if there are none. @param variable heading of the first column: "α, kN"
/// @param load that is carried at no factor beyond the end: "some admissible load"
/// @throws WrongInput
void add_load_curve(pictures::Markup& page, const ResultReader& reader, const std::string& key,
                    const std::string& variable, const std::string& load);

}  // namespace kusabi::run
