// What a page says of a sweep: the curve, the points that were asked for, and where it changes.
#pragma once

#include "pictures/html/markup.hpp"
#include "run/results/result_reader.hpp"

namespace kusabi::run {

/// @throws WrongInput
void add_sweep(pictures::Markup& page, const ResultReader& reader);

}  // namespace kusabi::run
