// Expansion: receives the children and the solutions of one node from `expand`.
#pragma once

#include <functional>
#include <optional>
#include <utility>

#include <boost/serialization/vector.hpp>

#include "engine/detail/incumbent.hpp"
#include "engine/detail/nodes/frontier.hpp"
#include "engine/detail/nodes/node_with_bound.hpp"
#include "engine/detail/sense.hpp"
#include "engine/path.hpp"

namespace kusabi::engine {

/// Work below the first child of a node of `P`, relative to that below each other child, for the
/// progress estimate (Uneven in engine/problem.hpp).
template <class P>
struct WorkOf {
  static constexpr double of_first_child = [] {
    if constexpr (requires { P::work_of_first_child; }) {
      return double{P::work_of_first_child};
    } else {
      return 1.0;
    }
  }();
};

/// A solution and the path of the node that reported it.
template <class P>
struct FoundSolution {
  Path path;
  typename P::Solution solution;

  template <class Archive>
  void serialize(Archive& archive, unsigned /*version*/) {
    archive& path& solution;
  }
};

/// The out-parameter of `expand`. It must not be used after `expand` has returned.
template <class P>
class Expansion {
 public:
  using Node = typename P::Node;
  using Solution = typename P::Solution;

  /// @param open receives children @param report receives solutions @param serve see `poll`
  Expansion(Frontier<StoredNode<P>, WorkOf<P>>& open, const Incumbent& incumbent,
            std::function<void(Solution&&)> report, std::function<bool()> serve)
      : open_(open), incumbent_(incumbent), report_(std::move(report)), serve_(std::move(serve)) {}

  /// Adds a child. The first child added is searched first.
  void branch(Node child) { open_.branch(stored<P>(std::move(child))); }

  /// Reports a solution below this node. A node may report several solutions and have children as
  /// well.
  void solution(Solution solution) { report_(std::move(solution)); }

  /// Objective of the incumbent on this rank, with Options::pool that of the worst solution that is
  /// still wanted; infinity if there is none, -infinity if the problem maximises. A child all of
  /// whose solutions are worse (not equal) need not be branched.
  [[nodiscard]] double cutoff() const { return oriented<P>(incumbent_.objective); }

  /// True if no further solution of this node can be the best; it need then not be branched. (Among
  /// equal objectives the first in depth-first order is best.)
  /// @param bound of the objectives of these solutions, as that of a node
  [[nodiscard]] bool ruled_out(double bound) const {
    return incumbent_.rules_out_more(oriented<P>(bound), open_.place());
  }

  /// Answers messages. An `expand` that takes longer than about a millisecond should call it now
  /// and then, so that other ranks do not wait for work.
  /// @return true if the search ends before its tree is complete; an `expand` that takes seconds
  ///   may then put its node back
  bool poll() { return serve_(); }

  /// Leaves the node open for a run that resumes: it is not counted, and its children are removed.
  /// @pre poll() has returned true, and no solution was reported
  void put_back(Node node) { put_back_ = std::move(node); }

  /// The node that was put back, if any; called by the engine.
  [[nodiscard]] std::optional<Node>& unopened() { return put_back_; }

  /// Path of the node being expanded.
  [[nodiscard]] Path path() const { return open_.path(); }

 private:
  Frontier<StoredNode<P>, WorkOf<P>>& open_;
  const Incumbent& incumbent_;
  std::function<void(Solution&&)> report_;
  std::function<bool()> serve_;
  std::optional<Node> put_back_;
};

}  // namespace kusabi::engine
