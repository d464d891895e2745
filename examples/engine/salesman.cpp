// The shortest round trip through random towns, at most 64, of the unit square.
//
//   salesman 12                   mpirun -np 4 salesman 14 7 --order best
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iostream>
#include <limits>
#include <random>
#include <string>
#include <vector>

#include <boost/serialization/vector.hpp>

#include "engine/run.hpp"

namespace engine = kusabi::engine;

struct Salesman {
  std::vector<std::vector<double>> distance;

  struct Node {
    std::vector<int> tour{0};
    std::uint64_t visited = 1;  // a bit for each town
    double length = 0;
    template <class Archive>
    void serialize(Archive& archive, unsigned /*version*/) {
      archive& tour& visited& length;
    }
  };
  using Solution = Node;

  Node root() const { return {}; }

  bool visited(const Node& node, int town) const { return (node.visited >> town & 1U) != 0; }

  double objective(const Solution& solution) const {
    return solution.length + distance[solution.tour.back()][0];
  }

  // From the last town and from each that is not visited, at least the way to the nearest that may
  // follow.
  double bound(const Node& node) const {
    double length = node.length;
    const int towns = static_cast<int>(distance.size());
    for (int from = 0; from < towns; ++from) {
      if (from != node.tour.back() && visited(node, from)) continue;
      double nearest = std::numeric_limits<double>::infinity();
      for (int to = 0; to < towns; ++to) {
        if (to != from && (to == 0 || !visited(node, to)))
          nearest = std::min(nearest, distance[from][to]);
      }
      length += nearest;
    }
    return length;
  }

  void expand(Node&& node, engine::Expansion<Salesman>& out) {
    if (node.tour.size() == distance.size()) return out.solution(std::move(node));
    for (int town = 1; town < static_cast<int>(distance.size()); ++town) {
      if (visited(node, town)) continue;
      Node child = node;
      child.length += distance[node.tour.back()][town];
      child.tour.push_back(town);
      child.visited |= std::uint64_t{1} << town;
      out.branch(std::move(child));
    }
  }
};

int main(int argc, char** argv) {
  const auto words = engine::own_words(argc, argv);
  const int towns = words.empty() ? 10 : std::stoi(words[0]);
  std::mt19937 random(words.size() > 1 ? std::stoul(words[1]) : 1);
  std::vector<double> x, y;
  for (int i = 0; i < towns; ++i) {
    x.push_back(random() / 4294967296.0);
    y.push_back(random() / 4294967296.0);
  }
  Salesman problem;
  for (int i = 0; i < towns; ++i) {
    problem.distance.emplace_back();
    for (int j = 0; j < towns; ++j)
      problem.distance[i].push_back(std::hypot(x[i] - x[j], y[i] - y[j]));
  }
  return engine::run(argc, argv, problem, [&](const auto& outcome) {
    for (const auto& found : outcome.solutions)
      std::cout << "length " << problem.objective(found.solution) << '\n';
  });
}
