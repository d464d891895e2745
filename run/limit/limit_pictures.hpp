// What --vtu DIR of `kusabi limit` writes: the collapse under the nominal load, and in the worst
// case.
#pragma once

#include "run/limit/limit_report.hpp"
#include "run/output/output_folder.hpp"

namespace kusabi::run {

/// Writes nominal.vtu and worst-case.vtu, those of them that there are, and limit.pvd.
void draw_collapses(OutputFolder& folder, const LimitReport& report);

}  // namespace kusabi::run
