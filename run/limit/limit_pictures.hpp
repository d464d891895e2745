// VTU files of `kusabi limit --vtu DIR`: collapse under the nominal load, and in the worst case.
#pragma once

#include "run/limit/limit_report.hpp"
#include "run/output/output_folder.hpp"

namespace kusabi::run {

/// Writes nominal.vtu and worst-case.vtu, as far as they are known, and limit.pvd.
void draw_collapses(OutputFolder& folder, const LimitReport& report);

}  // namespace kusabi::run
