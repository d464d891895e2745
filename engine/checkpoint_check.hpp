// Check of the checkpoint of an interrupted search before the analysis resumes
// (engine/analysis/recording.hpp), so that an unusable checkpoint is reported at once.
#pragma once

#include <cstdint>

#include "engine/journal.hpp"

namespace kusabi::engine {

/// @param facts_fingerprint fingerprint of the facts, as in JournalOptions
/// @throws CheckpointError if the next search has a checkpoint, and neither it nor the one before
///     it is valid
void expect_usable_checkpoint(const Journal& journal, std::uint64_t facts_fingerprint);

}  // namespace kusabi::engine
