// Timeline of a search in the Trace Event Format (ui.perfetto.dev, chrome://tracing): for each rank
// a track of its activities, one of the reductions, and a curve of its open nodes.
#pragma once

#include <cstddef>
#include <ostream>
#include <vector>

#include "engine/trace.hpp"

namespace kusabi::run {

/// Maximum number of events per rank: a million, and four million over all ranks, which are half a
/// gigabyte of JSON and near the limit of browsers.
std::size_t trace_events_per_rank(int ranks);

/// Writes one JSON object, event by event.
/// @param traces one per rank, on one time axis (Outcome::traces)
void write_trace(std::ostream& out, const std::vector<engine::RankTrace>& traces);

}  // namespace kusabi::run
