// nodes_along: the nodes from the root to a solution, to show how it came about.
//
//   for (const auto& found : outcome.solutions) {
//     for (const auto& node : engine::nodes_along(problem, found)) std::cout << label(node) <<
//     '\n';
//   }
#pragma once

#include <algorithm>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "engine/expansion.hpp"
#include "engine/problem.hpp"
#include "engine/wire.hpp"

namespace kusabi::engine {

/// Nodes of the path of a solution, the root first, and the node that reported it last. They are
/// expanded again, without a best known solution.
///
/// @throws std::invalid_argument if the path does not lead to this solution: `expand` must add the
///     same children whatever the best known solution is. (A child that `cutoff` or `ruled_out`
///     exclude can be added nevertheless; with a `bound`, the engine prunes it.)
template <Problem P>
std::vector<typename P::Node> nodes_along(P& problem, const FoundSolution<P>& found) {
  using Node = typename P::Node;
  Frontier<StoredNode<P>, WorkOf<P>> frontier;
  const Incumbent none;
  const Bytes expected = pack(found.solution);
  bool reported = false;
  Expansion<P> out(
      frontier, none,
      [&](typename P::Solution&& solution) { reported = reported || pack(solution) == expected; },
      [] { return false; });
  frontier.add_root(stored<P>(std::as_const(problem).root()));
  std::vector<Node> nodes;
  const auto open = [&] {
    auto node = frontier.open();
    nodes.push_back(node_of(node));
    reported = false;
    problem.expand(std::move(node_of(node)), out);
    frontier.close();
  };
  open();
  for (const auto branch : found.path) {
    const auto children = frontier.branches();
    if (branch >= children) break;
    for (auto before = branch; before > 0; --before) frontier.open();
    open();
  }
  if (nodes.size() == found.path.size() + 1 && reported) return nodes;
  throw std::invalid_argument("node " + to_string(found.path) +
                              ": does not report this solution without a best known one; expected "
                              "that expand adds the same children with any best known solution");
}

}  // namespace kusabi::engine
