// Knapsack: the 0-1 knapsack problem as a minimisation, a tree with an objective and a bound.
#pragma once

#include <algorithm>
#include <cstdint>
#include <random>
#include <vector>

#include "engine/search.hpp"

namespace kusabi::examples {

/// Choose items whose weights stay within the capacity, such that minus their value is minimal.
class Knapsack {
 public:
  struct Item {
    int weight = 0;
    int value = 0;
  };
  /// The first `decided` items (in order of value per weight) are decided.
  struct Node {
    int decided = 0;
    int weight = 0;
    int value = 0;
    std::uint64_t chosen = 0;

    template <class Archive>
    void serialize(Archive& archive, unsigned /*version*/) {
      archive& decided& weight& value& chosen;
    }
  };
  using Solution = Node;

  Knapsack(std::vector<Item> items, int capacity) : items_(std::move(items)), capacity_(capacity) {
    std::sort(items_.begin(), items_.end(),
              [](const Item& a, const Item& b) { return a.value * b.weight > b.value * a.weight; });
  }

  /// Values coincide on purpose, so that many choices are equally good.
  static Knapsack random(unsigned seed, int size) {
    std::mt19937 generator(seed);
    std::vector<Item> items;
    int total = 0;
    for (int i = 0; i < size; ++i) {
      const int weight = 1 + static_cast<int>(generator() % 20);
      items.push_back({weight, weight + static_cast<int>(generator() % 3)});
      total += weight;
    }
    return {std::move(items), total / 2};
  }

  Node root() const { return {}; }

  /// @param out engine::Expansion of this type, or of one that wraps it
  template <class Expansion>
  void expand(Node&& node, Expansion& out) {
    if (node.decided == static_cast<int>(items_.size())) {
      out.solution(std::move(node));
      return;
    }
    const Item& item = items_[static_cast<std::size_t>(node.decided)];
    Node without = node;
    ++without.decided;
    if (node.weight + item.weight <= capacity_) {
      Node with = without;
      with.weight += item.weight;
      with.value += item.value;
      with.chosen |= std::uint64_t{1} << static_cast<unsigned>(node.decided);
      out.branch(std::move(with));
    }
    out.branch(std::move(without));
  }

  double objective(const Solution& solution) const { return -solution.value; }

  /// Fills the rest of the knapsack with the next items, the last of them in part.
  double bound(const Node& node) const {
    double value = node.value;
    int room = capacity_ - node.weight;
    for (auto i = static_cast<std::size_t>(node.decided); i < items_.size() && room > 0; ++i) {
      const int part = std::min(room, items_[i].weight);
      value += static_cast<double>(items_[i].value) * part / items_[i].weight;
      room -= part;
    }
    return -value;
  }

 private:
  std::vector<Item> items_;
  int capacity_;
};

}  // namespace kusabi::examples
