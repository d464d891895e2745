// Numbers in sets that grow together: which pieces a structure falls into.
#pragma once

#include <cstddef>
#include <numeric>
#include <vector>

namespace kusabi::verify {

class DisjointSets {
 public:
  /// 0 to count - 1, each in a set of its own.
  explicit DisjointSets(std::size_t count) : parent_(count) {
    std::iota(parent_.begin(), parent_.end(), std::size_t{0});
  }

  /// The number that stands for the set of `number`, until that is joined with another.
  [[nodiscard]] std::size_t of(std::size_t number) {
    while (parent_[number] != number) number = parent_[number] = parent_[parent_[number]];
    return number;
  }

  void join(std::size_t one, std::size_t other) { parent_[of(one)] = of(other); }

 private:
  std::vector<std::size_t> parent_;
};

}  // namespace kusabi::verify
