// Queens: the n-queens problem, the smallest complete use of the engine, with known counts.
#pragma once

#include <cstdlib>
#include <vector>

#include <boost/serialization/vector.hpp>

#include "engine/search.hpp"

namespace kusabi::examples {

/// All placements of n queens on an n x n board such that none attacks another.
class Queens {
 public:
  /// Columns of the queens in the rows filled so far.
  struct Node {
    std::vector<int> columns;

    template <class Archive>
    void serialize(Archive& archive, unsigned /*version*/) {
      archive& columns;
    }
  };
  using Solution = Node;

  explicit Queens(int size) : size_(size) {}

  Node root() const { return {}; }

  void expand(Node&& node, engine::Expansion<Queens>& out) {
    if (static_cast<int>(node.columns.size()) == size_) {
      out.solution(std::move(node));
      return;
    }
    for (int column = 0; column < size_; ++column) {
      if (attacked(node, column)) continue;
      Node child = node;
      child.columns.push_back(column);
      out.branch(std::move(child));
    }
  }

 private:
  static bool attacked(const Node& node, int column) {
    int distance = static_cast<int>(node.columns.size());
    for (const int other : node.columns) {
      if (other == column || std::abs(other - column) == distance) return true;
      --distance;
    }
    return false;
  }

  int size_;
};

}  // namespace kusabi::examples
