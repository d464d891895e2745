// All placements of N queens on an N x N board such that none attacks another.
//
//   queens 8                      92
//   mpirun -np 4 queens 12        14200
#include <cstdlib>
#include <iostream>
#include <string>
#include <vector>

#include <boost/serialization/vector.hpp>

#include "engine/run.hpp"

namespace engine = kusabi::engine;

struct Queens {
  int size;

  using Node = std::vector<int>;  // columns of the queens in the rows filled so far
  using Solution = Node;

  Node root() const { return {}; }

  void expand(Node&& node, engine::Expansion<Queens>& out) {
    if (static_cast<int>(node.size()) == size) return out.solution(std::move(node));
    for (int column = 0; column < size; ++column) {
      if (attacked(node, column)) continue;
      Node child = node;
      child.push_back(column);
      out.branch(std::move(child));
    }
  }

  static bool attacked(const Node& node, int column) {
    int distance = static_cast<int>(node.size());
    for (const int other : node) {
      if (other == column || std::abs(other - column) == distance) return true;
      --distance;
    }
    return false;
  }
};

int main(int argc, char** argv) {
  const auto words = engine::own_words(argc, argv);
  Queens queens{words.empty() ? 8 : std::stoi(words[0])};
  return engine::run(argc, argv, queens, [](const auto& outcome) {
    std::cout << outcome.solutions.size() << " placements\n";
  });
}
