// Loads that can be held, on a page: the chart, and the intervals, grip ranges or pieces.
#pragma once

#include <string>

#include "pictures/html/markup.hpp"
#include "run/results/result_reader.hpp"

namespace kusabi::run {

/// @param sentence headline @throws WrongInput
void add_held_loads(pictures::Markup& page, const ResultReader& reader,
                    const std::string& sentence);

/// Answers for each of several load cases; nothing if there is one.
void add_load_cases(pictures::Markup& page, const ResultReader& reader);

/// Pictures of the motions by which statics alone excludes loads; nothing if there are none.
void add_exclusions(pictures::Markup& page, const ResultReader& reader);

}  // namespace kusabi::run
