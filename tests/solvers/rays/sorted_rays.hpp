// The order of rays in which lists are compared.
#pragma once

#include <algorithm>
#include <vector>

#include "solvers/rays/zero_set.hpp"

namespace kusabi::rays::test {

inline std::vector<ZeroSet> sorted(std::vector<ZeroSet> zeros) {
  std::ranges::sort(zeros, comes_before);
  return zeros;
}

}  // namespace kusabi::rays::test
