// Spelling suggestions for unknown names.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace kusabi::support {

/// The nearest of `words` for a "did you mean": at most two insertions, deletions, replacements or
/// swaps, and fewer than half of the word; empty if none is near.
std::string_view nearest(std::string_view word, const std::vector<std::string_view>& words);

/// Suffix of a message about `word`: "; did you mean ...?", empty if no name is near.
std::string did_you_mean(std::string_view word, const std::vector<std::string_view>& words);

}  // namespace kusabi::support
