// The search that was under way in a question that is kept (engine/recording.hpp), looked at before
// the question is asked again: a checkpoint that cannot be used should be told of at once.
#pragma once

#include <cstdint>

#include "engine/journal.hpp"

namespace kusabi::engine {

/// @param question fingerprint of the facts, as in Keeping
/// @throws CheckpointError if there is a checkpoint of the search that comes next, and neither it
///   nor the one before it is good
void expect_usable_search(const Journal& journal, std::uint64_t question);

}  // namespace kusabi::engine
