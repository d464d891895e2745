// Check of the checkpoint of an interrupted search before the analysis resumes
// (engine/analysis/recording.hpp), so that an unusable checkpoint is reported at once.
#pragma once

#include <cstdint>

#include "engine/journal.hpp"

namespace kusabi::engine {

/// @param question fingerprint of the facts, as in Keeping
/// @throws CheckpointError if the next search has a checkpoint, and neither it nor the one before
///     it is valid
void expect_usable_search(const Journal& journal, std::uint64_t question);

}  // namespace kusabi::engine
