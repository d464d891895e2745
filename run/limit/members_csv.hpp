// Members of a truss at collapse, as CSV.
#pragma once

#include <ostream>

#include "run/limit/limit_report.hpp"

namespace kusabi::run {

/// One row per member, in the order of the problem; values not requested or not found are empty.
void write_members_csv(std::ostream& out, const LimitReport& report);

}  // namespace kusabi::run
