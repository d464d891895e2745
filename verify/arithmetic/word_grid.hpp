// Numbers on a common grid, each in one word, so that sums of products of two are exact in two
// words.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace kusabi::verify {

/// Number i is words[i] * 2^exponent.
struct WordGrid {
  std::vector<std::int64_t> words;
  long exponent = 0;
};

/// Bits of a word, so that a sum of so many products of two words fits into 126 bits.
long word_bits(std::size_t terms);

/// The numbers truncated towards zero. @param terms the largest number of products in a sum
/// @pre all finite
WordGrid words_of(std::span<const double> values, std::size_t terms);

}  // namespace kusabi::verify
