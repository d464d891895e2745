// Items of greatest value whose weights fit into a knapsack: random items whose values nearly
// follow their weights, half of the total weight as capacity.
//
//   knapsack 40                   40 items
//   mpirun -np 2 knapsack 50 7    50 items, random seed 7
//   knapsack 40 --solutions 5     the five best choices
#include <algorithm>
#include <iostream>
#include <random>
#include <string>
#include <vector>

#include <boost/serialization/vector.hpp>

#include "engine/run.hpp"

namespace engine = kusabi::engine;

struct Knapsack {
  struct Item {
    int value, weight;
  };
  std::vector<Item> items;  // by value per weight, greatest first
  int capacity = 0;

  struct Node {
    std::vector<int> taken;  // of the items decided so far, 0 or 1
    int value = 0, room = 0;
    template <class Archive>
    void serialize(Archive& archive, unsigned /*version*/) {
      archive& taken& value& room;
    }
  };
  using Solution = Node;

  Node root() const { return {{}, 0, capacity}; }

  static constexpr bool maximises = true;
  double objective(const Solution& solution) const { return solution.value; }

  // Value with the rest of the room filled by fractions of items (Dantzig's bound).
  double bound(const Node& node) const {
    double value = node.value, room = node.room;
    for (std::size_t i = node.taken.size(); i < items.size() && room > 0; ++i) {
      const double share = std::min(1.0, room / items[i].weight);
      value += share * items[i].value;
      room -= share * items[i].weight;
    }
    return value;
  }

  void expand(Node&& node, engine::Expansion<Knapsack>& out) {
    if (node.taken.size() == items.size()) return out.solution(std::move(node));
    const auto [value, weight] = items[node.taken.size()];
    for (const int taken : {1, 0}) {
      if (taken * weight > node.room) continue;
      Node child = node;
      child.taken.push_back(taken);
      child.value += taken * value;
      child.room -= taken * weight;
      out.branch(std::move(child));
    }
  }
};

int main(int argc, char** argv) {
  const auto words = engine::own_words(argc, argv);
  std::mt19937 random(words.size() > 1 ? std::stoul(words[1]) : 1);
  Knapsack problem;
  for (int i = words.empty() ? 40 : std::stoi(words[0]); i > 0; --i) {
    const int weight = 100 + static_cast<int>(random() % 900);
    problem.items.push_back({weight + static_cast<int>(random() % 100), weight});
    problem.capacity += weight;
  }
  problem.capacity /= 2;
  std::sort(problem.items.begin(), problem.items.end(), [](const auto& one, const auto& other) {
    return one.value * other.weight > other.value * one.weight;
  });
  return engine::run(argc, argv, problem, [](const auto& outcome) {
    for (const auto& found : outcome.solutions)
      std::cout << "value " << found.solution.value << '\n';
    std::cout << "at most " << outcome.bound << '\n';
  });
}
