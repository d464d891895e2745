// The problem in a table: bodies, material, supports, mesh, candidates, loads, units.
#pragma once

#include "pictures/html/markup.hpp"
#include "run/results/result_reader.hpp"

namespace kusabi::run {

/// @throws WrongInput
void add_problem(pictures::Markup& page, const ResultReader& reader);

}  // namespace kusabi::run
