// A maximum clique of a graph in a DIMACS file (lines "e I J").
//
//   clique GRAPH                  mpirun -np 4 clique GRAPH --resume state
//   clique GRAPH --within 0       all of them
#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <fstream>
#include <iostream>
#include <set>
#include <string>
#include <vector>

#include <boost/serialization/vector.hpp>

#include "engine/run.hpp"

namespace engine = kusabi::engine;

struct Clique {
  std::set<std::pair<int, int>> edges;
  std::vector<int> vertices;

  struct Node {
    std::vector<int> clique, candidates;  // candidates are joined to all of the clique
    int colours = 0;                      // at most so many of them belong to one clique
    template <class Archive>
    void serialize(Archive& archive, unsigned /*version*/) {
      archive& clique& candidates& colours;
    }
  };
  using Solution = std::vector<int>;

  bool joined(int one, int other) const { return edges.count(std::minmax(one, other)) > 0; }

  // Colours the candidates greedily, and orders them by colour.
  Node coloured(Node node) const {
    std::vector<std::vector<int>> classes;
    for (const int vertex : node.candidates) {
      const auto fits = std::find_if(classes.begin(), classes.end(), [&](const auto& others) {
        return std::none_of(others.begin(), others.end(),
                            [&](int other) { return joined(vertex, other); });
      });
      (fits == classes.end() ? classes.emplace_back() : *fits).push_back(vertex);
    }
    node.candidates.clear();
    for (const auto& some : classes)
      node.candidates.insert(node.candidates.end(), some.begin(), some.end());
    node.colours = static_cast<int>(classes.size());
    return node;
  }

  // The file name does not determine the graph.
  std::uint64_t fingerprint() const {
    std::uint64_t sum = 1;
    for (const auto& [one, other] : edges) sum = sum * 0x9E3779B97F4A7C15U + 65536U * one + other;
    return sum;
  }

  Node root() const { return coloured({{}, vertices, 0}); }
  static constexpr bool maximises = true;
  double objective(const Solution& clique) const { return static_cast<double>(clique.size()); }
  double bound(const Node& node) const {
    return static_cast<double>(node.clique.size()) + node.colours;
  }

  // The last candidate belongs to the clique or not.
  void expand(Node&& node, engine::Expansion<Clique>& out) {
    if (node.candidates.empty()) return out.solution(std::move(node.clique));
    const int vertex = node.candidates.back();
    node.candidates.pop_back();
    Node with = node;
    with.clique.push_back(vertex);
    std::erase_if(with.candidates, [&](int other) { return !joined(vertex, other); });
    out.branch(coloured(std::move(with)));
    out.branch(coloured(std::move(node)));
  }
};

int main(int argc, char** argv) {
  Clique problem;
  const auto words = engine::own_words(argc, argv);
  std::ifstream file(words.empty() ? "" : words[0]);
  std::set<int> vertices;
  for (std::string line; std::getline(file, line);) {
    int one = 0, other = 0;
    if (std::sscanf(line.c_str(), "e %d %d", &one, &other) != 2) continue;
    problem.edges.insert(std::minmax(one, other));
    vertices.insert({one, other});
  }
  problem.vertices.assign(vertices.begin(), vertices.end());
  if (problem.edges.empty()) {
    std::cerr << "expected a DIMACS file with lines \"e I J\"\n";
    return 2;
  }
  return engine::run(argc, argv, problem, [](const auto& outcome) {
    for (const auto& found : outcome.solutions) {
      std::cout << "clique of " << found.solution.size() << ":";
      for (const int vertex : found.solution) std::cout << ' ' << vertex;
      std::cout << '\n';
    }
  });
}
