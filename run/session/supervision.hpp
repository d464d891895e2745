// How the command takes part in a question (engine/analysis/analysis.hpp): the limits of the call,
// stopped by signals, and its progress shown on rank 0.
#pragma once

#include "engine/analysis/analysis.hpp"

namespace kusabi::run {

/// Signals are heeded from here on. @param quiet whether to show nothing
engine::Supervision supervision(const engine::Limits& limits, bool quiet);

}  // namespace kusabi::run
