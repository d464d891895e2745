// Truncation of doubles to multiples of a power of two.
#include "verify/arithmetic/word_grid.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

namespace kusabi::verify {

long word_bits(std::size_t terms) {
  return (126 - static_cast<long>(std::bit_width(terms))) / 2;
}

WordGrid words_of(std::span<const double> values, std::size_t terms) {
  double largest = 0;
  for (const double value : values) largest = std::max(largest, std::abs(value));
  int above = 0;  // 2^above exceeds all numbers in size
  std::frexp(largest, &above);
  WordGrid grid;
  grid.exponent = above - word_bits(terms);
  grid.words.reserve(values.size());
  for (const double value : values)
    grid.words.push_back(
        static_cast<std::int64_t>(std::trunc(std::ldexp(value, static_cast<int>(-grid.exponent)))));
  return grid;
}

}  // namespace kusabi::verify
