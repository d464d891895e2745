// 128-bit integer, in which products of machine words are added exactly.
#pragma once

#include <gmpxx.h>

namespace kusabi::verify {

__extension__ using Wide = __int128;

inline mpz_class integer(Wide value) {
  constexpr unsigned half = 64;
  const bool negative = value < 0;
  __extension__ using Unsigned = unsigned __int128;
  const auto size = negative ? -static_cast<Unsigned>(value) : static_cast<Unsigned>(value);
  mpz_class result(static_cast<unsigned long>(size >> half));
  result <<= half;
  result += static_cast<unsigned long>(size);
  return negative ? mpz_class(-result) : result;
}

}  // namespace kusabi::verify
