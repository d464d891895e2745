// The members of a truss at its collapse, as a table.
#pragma once

#include <ostream>

#include "run/limit/limit_report.hpp"

namespace kusabi::run {

/// A row a member, in the order of the problem; what was not asked for or not found is empty.
void write_members_csv(std::ostream& out, const LimitReport& report);

}  // namespace kusabi::run
