// A result as one self-contained HTML page.
#pragma once

#include <string>

#include "run/results/result_reader.hpp"

namespace kusabi::run {

/// @throws WrongInput in one line if it is not a result that can be drawn
std::string report_page(const ResultReader& reader);

}  // namespace kusabi::run
