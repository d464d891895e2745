// What somebody probably meant who has written a name that does not exist.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace kusabi::support {

/// The one of `words` that `word` was probably meant to be, for a "did you mean": at most two
/// letters inserted, left out, replaced or swapped with the next, and fewer than half of the word;
/// empty if none is near.
std::string_view nearest(std::string_view word, const std::vector<std::string_view>& words);

/// The end of a message about `word`: "; did you mean ...?", empty if none is near.
std::string did_you_mean(std::string_view word, const std::vector<std::string_view>& words);

}  // namespace kusabi::support
