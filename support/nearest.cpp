// Nearest name by edit distance.
#include "support/nearest.hpp"

#include <algorithm>
#include <cstddef>
#include <numeric>

#include "support/input_error.hpp"

namespace kusabi::support {
namespace {

/// In bytes; longer words are not compared.
constexpr std::size_t longest_name = 64;

/// Optimal string alignment distance (Damerau-Levenshtein, restricted): the number of insertions,
/// deletions, replacements and swaps of neighbours.
std::size_t edit_distance(std::string_view from, std::string_view to) {
  std::vector<std::size_t> before(to.size() + 1);  // row before the last one
  std::vector<std::size_t> last(to.size() + 1);
  std::vector<std::size_t> row(to.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 0; i < from.size(); ++i) {
    before.swap(last);
    last.swap(row);
    row[0] = i + 1;
    for (std::size_t j = 0; j < to.size(); ++j) {
      const std::size_t replaced = last[j] + (from[i] == to[j] ? 0 : 1);
      row[j + 1] = std::min({replaced, last[j + 1] + 1, row[j] + 1});
      if (i > 0 && j > 0 && from[i] == to[j - 1] && from[i - 1] == to[j])
        row[j + 1] = std::min(row[j + 1], before[j - 1] + 1);
    }
  }
  return row.back();
}

}  // namespace

std::string_view nearest(std::string_view word, const std::vector<std::string_view>& words) {
  // At most two edits, and fewer than half of the word: "x" is not near "y".
  std::size_t best = std::min<std::size_t>(3, (word.size() + 1) / 2);
  if (word.size() > longest_name) return {};
  std::string_view found;
  for (const std::string_view candidate : words) {
    const std::size_t distance = edit_distance(word, candidate);
    if (distance >= best) continue;
    best = distance;
    found = candidate;
  }
  return found;
}

std::string did_you_mean(std::string_view word, const std::vector<std::string_view>& words) {
  const std::string_view meant = nearest(word, words);
  return meant.empty() ? "" : "; did you mean " + in_quotes(meant) + "?";
}

}  // namespace kusabi::support
