// How long one node of the wedged problem takes: microseconds and iterations of the cone solver per
// node program, for a certified sign and for the full accuracy of the value.
//
// Random problems stand in for condensed structures; the nodes are those of random walks down
// the tree. Run it on a quiet machine; the best of several rounds counts.
#include <algorithm>
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <random>
#include <vector>

#include <Eigen/Dense>

#include "nodes/conic/node_solver.hpp"

namespace {

using namespace kusabi::conic;

constexpr int dimension = 3;
constexpr int node_count = 200;
constexpr int rounds = 15;
constexpr double sliding = 0.5;  // friction that leaves both signs frequent

struct Node {
  std::uint64_t contact, separated;
};

// The compliance of a random spring network on the candidates, weakly held.
Eigen::MatrixXd random_compliance(int m, std::mt19937_64& generator) {
  std::normal_distribution<double> normal;
  const int size = dimension * m;
  Eigen::MatrixXd stiffness = Eigen::MatrixXd::Identity(size, size) * 0.05;
  for (int member = 0; member < 3 * size; ++member) {
    Eigen::VectorXd row = Eigen::VectorXd::Zero(size);
    const int at = static_cast<int>(generator() % static_cast<unsigned>(m));
    const int other = static_cast<int>(generator() % static_cast<unsigned>(m));
    for (int i = 0; i < dimension; ++i) {
      row[dimension * at + i] += normal(generator);
      row[dimension * other + i] -= normal(generator);
    }
    stiffness += row * row.transpose();
  }
  Eigen::MatrixXd compliance = stiffness.inverse();
  compliance = (0.5 * (compliance + compliance.transpose())).eval();
  double mean = 0;
  for (int i = 0; i < m; ++i) mean += compliance(dimension * i, dimension * i) / m;
  return compliance / mean;
}

// Nodes of random walks from the root: a walk ends at a node that is proved dead, or at a leaf. It
// branches where u_n r_n is largest (the wedged paper, Remark 5.5) and takes a random child.
std::vector<Node> walked_nodes(NodeSolver<dimension>& solver, int m, std::mt19937_64& generator) {
  const std::uint64_t all = (std::uint64_t{1} << m) - 1;
  std::vector<Node> nodes;
  Node node{0, 0};
  while (nodes.size() < node_count) {
    nodes.push_back(node);
    if (solver.solve(node.contact, node.separated).sign == Sign::dead ||
        (node.contact | node.separated) == all) {
      node = {0, 0};
      continue;
    }
    int branching = -1;
    double most = -1;
    for (int i = 0; i < m; ++i) {
      if (((node.contact | node.separated) >> i & 1) != 0) continue;
      const double product =
          solver.displacement()[dimension * i] * solver.reaction()[dimension * i];
      if (product > most || branching < 0) {
        most = product;
        branching = i;
      }
    }
    const std::uint64_t bit = std::uint64_t{1} << branching;
    (generator() % 2 == 0 ? node.contact : node.separated) |= bit;
  }
  return nodes;
}

struct Figures {
  double microseconds = 1e300, iterations = 0;
  int alive = 0, dead = 0, marginal = 0;
};

Figures measure(NodeSolver<dimension>& solver, const std::vector<Node>& nodes, StopEarly stop) {
  Figures best;
  for (int round = 0; round < rounds; ++round) {
    Figures figures;
    const auto start = std::chrono::steady_clock::now();
    for (const Node& node : nodes) {
      const Answer answer = solver.solve(node.contact, node.separated, stop);
      figures.iterations += answer.iterations;
      ++(answer.sign == Sign::alive  ? figures.alive
         : answer.sign == Sign::dead ? figures.dead
                                     : figures.marginal);
    }
    const std::chrono::duration<double, std::micro> elapsed =
        std::chrono::steady_clock::now() - start;
    figures.microseconds = elapsed.count() / static_cast<double>(nodes.size());
    figures.iterations /= static_cast<double>(nodes.size());
    if (figures.microseconds < best.microseconds) best = figures;
  }
  return best;
}

}  // namespace

int main() {
  std::printf("  m | full: us  iterations | sign: us  iterations | alive dead marginal\n");
  for (const int m : {10, 20, 30}) {
    std::mt19937_64 generator(static_cast<std::uint64_t>(m));
    const std::vector<double> friction(static_cast<std::size_t>(m), sliding);
    NodeSolver<dimension> solver(random_compliance(m, generator), friction);
    const std::vector<Node> nodes = walked_nodes(solver, m, generator);
    const Figures full = measure(solver, nodes, {.when_dead = false, .when_alive = false});
    const Figures sign = measure(solver, nodes, {});
    std::printf("%3d | %8.1f %11.1f | %8.1f %11.1f | %5d %4d %8d\n", m, full.microseconds,
                full.iterations, sign.microseconds, sign.iterations, sign.alive, sign.dead,
                sign.marginal);
  }
}
