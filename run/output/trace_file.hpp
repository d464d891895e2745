// The timeline of a search in the Trace Event Format, which ui.perfetto.dev and chrome://tracing
// show: for each rank a track of what it does, one of the reductions, and its open nodes as a
// curve.
#pragma once

#include <cstddef>
#include <ostream>
#include <vector>

#include "engine/trace.hpp"

namespace kusabi::run {

/// Events that a rank may keep: a million, but no more than four million on all ranks together,
/// which take half a gigabyte as JSON and all that a browser can show.
std::size_t trace_events_a_rank(int ranks);

/// Writes one JSON object, event by event.
/// @param traces one a rank, on one time axis (Outcome::traces)
void write_trace(std::ostream& out, const std::vector<engine::RankTrace>& traces);

}  // namespace kusabi::run
