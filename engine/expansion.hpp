// What `expand` writes to: the children and the solutions of one node.
#pragma once

#include <functional>
#include <utility>
#include <vector>

#include "engine/frontier.hpp"
#include "engine/path.hpp"

namespace kusabi::engine {

/// A solution and the path of the node that yielded it.
template <class P>
struct Found {
  Path path;
  typename P::Solution solution;

  template <class Archive>
  void serialize(Archive& archive, unsigned /*version*/) {
    archive& path& solution;
  }
};

/// The out-parameter of `expand`; of no use after it has returned.
template <class P>
class Expansion {
 public:
  using Node = typename P::Node;
  using Solution = typename P::Solution;

  Expansion(Frontier<Node>& frontier, std::vector<Found<P>>& found, std::function<void()> serve)
      : frontier_(frontier), found_(found), serve_(std::move(serve)) {}

  /// Adds a subproblem. The first one added is searched first.
  void branch(Node child) { frontier_.branch(std::move(child)); }

  /// Reports a solution. A node may yield several, and have children as well.
  void solution(Solution solution) { found_.push_back({frontier_.path(), std::move(solution)}); }

  /// Lets the rank answer its messages. For an `expand` that takes longer than about a
  /// millisecond: call it now and then, so that others need not wait for work.
  void poll() { serve_(); }

  /// The path of the node being expanded.
  [[nodiscard]] Path path() const { return frontier_.path(); }

 private:
  Frontier<Node>& frontier_;
  std::vector<Found<P>>& found_;
  std::function<void()> serve_;
};

}  // namespace kusabi::engine
