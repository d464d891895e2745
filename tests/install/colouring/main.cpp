// Search of a tree outside Kusabi: all ways to give the ten vertices of the Petersen graph one of
// a few colours each, so that no edge joins two vertices of one colour.
//
//   colouring                 three colours, in this process
//   colouring 4               four
//   mpirun -np 2 colouring    the same answer, on two ranks
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <iostream>
#include <utility>
#include <vector>

#include <boost/serialization/vector.hpp>

#include "engine/search.hpp"
#include "engine/transport/mpi.hpp"

namespace {

namespace engine = kusabi::engine;

// A pentagon 0 ... 4, a pentagram 5 ... 9, and five spokes.
constexpr std::size_t vertices = 10;
constexpr std::array<std::pair<std::size_t, std::size_t>, 15> edges{{{0, 1},
                                                                     {1, 2},
                                                                     {2, 3},
                                                                     {3, 4},
                                                                     {0, 4},
                                                                     {0, 5},
                                                                     {1, 6},
                                                                     {2, 7},
                                                                     {3, 8},
                                                                     {4, 9},
                                                                     {5, 7},
                                                                     {7, 9},
                                                                     {6, 9},
                                                                     {6, 8},
                                                                     {5, 8}}};

// The problem: two types and two functions, and a tally if it likes. What is not in the right shape
// the compiler refuses in one sentence; Options::check_expand tries whether `expand` depends on its
// node alone. Each rank has an object of its own, which may hold
// whatever is expensive to set up.
class Colouring {
 public:
  // A subproblem: the colours of the vertices 0, 1, ... coloured so far. Nodes travel between
  // ranks, so Boost.Serialization must be able to write and read them; a struct of your own says
  // how with the four lines of `serialize` below.
  struct Node {
    std::vector<int> colours;

    template <class Archive>
    void serialize(Archive& archive, unsigned /*version*/) {
      archive& colours;
    }
  };
  // Result of a leaf, sent to rank 0 at the end.
  using Solution = std::vector<int>;
  // Counts of this problem: nodes that no colour could be found for. Outcome::tally()
  // is the sum over all ranks.
  using Tally = std::uint64_t;

  explicit Colouring(int colours) : colours_(colours) {}

  Node root() const { return {}; }

  // Opens a node: hands over its children, from left to right, and its solutions. What it does must
  // depend on the node alone; then the outcome is the same on any number of ranks.
  void expand(Node&& node, engine::Expansion<Colouring>& out) {
    if (node.colours.size() == vertices) {
      out.solution(std::move(node.colours));
      return;
    }
    bool dead = true;
    for (int colour = 0; colour < colours_; ++colour) {
      if (!allowed(node, colour)) continue;
      Node child = node;
      child.colours.push_back(colour);
      out.branch(std::move(child));
      dead = false;
    }
    if (dead) ++dead_ends_;
  }

  Tally tally() const { return dead_ends_; }

 private:
  // True if the next vertex may have the colour.
  static bool allowed(const Node& node, int colour) {
    const std::size_t next = node.colours.size();
    for (const auto& [lower, upper] : edges) {
      if (upper == next && node.colours[lower] == colour) return false;
    }
    return true;
  }

  int colours_;
  std::uint64_t dead_ends_ = 0;
};

int report(const engine::Outcome<Colouring>& outcome, int colours) {
  const std::size_t ranks = outcome.ranks.size();
  std::cout << outcome.solutions.size() << " colourings of the Petersen graph with " << colours
            << " colours; " << outcome.opened() << " nodes opened by " << ranks
            << (ranks == 1 ? " rank\n" : " ranks\n");
  std::cout << "dead ends: " << outcome.tally() << '\n';
  // Solutions come in the order of a depth-first search on one rank, whoever found them.
  if (!outcome.solutions.empty()) {
    std::cout << "the first:";
    for (const int colour : outcome.solutions.front().solution) std::cout << ' ' << colour;
    std::cout << '\n';
  }
  return std::cout.flush() ? EXIT_SUCCESS : EXIT_FAILURE;
}

}  // namespace

int main(int argc, char** argv) {
  const bool together = engine::MpiEnvironment::launched();
  const int colours = argc > 1 ? std::atoi(argv[1]) : 3;
  Colouring colouring(colours);

  // Alone: no call of MPI, so it runs under a debugger as it is.
  if (!together) return report(engine::search(colouring), colours);

  // On every rank of an MPI job. Rank 0 has the outcome.
  const engine::MpiEnvironment mpi(argc, argv);
  engine::MpiTransport transport;
  const auto outcome = engine::search(colouring, transport);
  return transport.rank() == 0 ? report(outcome, colours) : EXIT_SUCCESS;
}
