// Loads that can be held, on a page: the chart, and the intervals, grip ranges or pieces.
#pragma once

#include <string>

#include "pictures/html/markup.hpp"
#include "run/results/result_reader.hpp"

namespace kusabi::run {

/// @param sentence headline @throws WrongInput
void add_held_loads(pictures::Markup& page, const ResultReader& reader,
                    const std::string& sentence);

}  // namespace kusabi::run
