// Options of an analysis (engine/analysis/analysis.hpp) by the command: limits of the call,
// signals, and progress shown on rank 0.
#pragma once

#include "engine/analysis/analysis.hpp"

namespace kusabi::run {

/// Catches signals from here on. @param quiet no progress is shown
engine::AnalysisOptions analysis_options(const engine::Limits& limits, bool quiet);

}  // namespace kusabi::run
