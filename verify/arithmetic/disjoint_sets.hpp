// Disjoint sets of numbers with union and find, for connected components of a structure.
#pragma once

#include <cstddef>
#include <numeric>
#include <vector>

namespace kusabi::verify {

class DisjointSets {
 public:
  /// The sets {0}, {1}, ..., {count - 1}.
  explicit DisjointSets(std::size_t count) : parent_(count) {
    std::iota(parent_.begin(), parent_.end(), std::size_t{0});
  }

  /// The representative of the set of `number`; it changes when that set is joined with another.
  [[nodiscard]] std::size_t of(std::size_t number) {
    while (parent_[number] != number) number = parent_[number] = parent_[parent_[number]];
    return number;
  }

  void join(std::size_t one, std::size_t other) { parent_[of(one)] = of(other); }

 private:
  std::vector<std::size_t> parent_;
};

}  // namespace kusabi::verify
