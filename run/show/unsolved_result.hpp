// A structure in the form of a result file, without an answer, for pictures.
#pragma once

#include <string>

#include "problems/structure/model/structure.hpp"
#include "run/results/result_reader.hpp"

namespace kusabi::run {

/// @param file its name in the call
ResultReader unsolved_result(const problems::Structure& structure, const std::string& file);

}  // namespace kusabi::run
