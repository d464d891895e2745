// Sweep on a page: the curve, the requested points, and its breakpoints.
#pragma once

#include "pictures/html/markup.hpp"
#include "run/results/result_reader.hpp"

namespace kusabi::run {

/// @throws WrongInput
void add_sweep(pictures::Markup& page, const ResultReader& reader);

}  // namespace kusabi::run
