// A result as a page of HTML that needs nothing else.
#pragma once

#include <string>

#include "run/results/result_reader.hpp"

namespace kusabi::run {

/// @throws WrongInput in one line, if it is no result that can be drawn
std::string report_page(const ResultReader& reader);

}  // namespace kusabi::run
