// What `expand` writes to: the children and the solutions of one node.
#pragma once

#include <functional>
#include <utility>

#include "engine/path.hpp"

namespace kusabi::engine {

template <class P>
class Explorer;

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

  Expansion(Explorer<P>& explorer, std::function<void()> serve)
      : explorer_(explorer), serve_(std::move(serve)) {}

  /// Adds a subproblem. The first one added is searched first.
  void branch(Node child);

  /// Reports a solution. A node may yield several, and have children as well.
  void solution(Solution solution);

  /// The objective of the best solution known on this rank, infinity if there is none. A child all
  /// of whose solutions are worse (greater, not equal) need not be branched.
  [[nodiscard]] double cutoff() const;

  /// Whether nothing that this node may still yield, with objectives of `bound` or more, can be the
  /// best: then it need not be branched. (Of equal ones the first in depth-first order is.)
  [[nodiscard]] bool ruled_out(double bound) const;

  /// Lets the rank answer its messages. For an `expand` that takes longer than about a
  /// millisecond: call it now and then, so that others need not wait for work.
  void poll() { serve_(); }

  /// The path of the node being expanded.
  [[nodiscard]] Path path() const;

 private:
  Explorer<P>& explorer_;
  std::function<void()> serve_;
};

}  // namespace kusabi::engine
