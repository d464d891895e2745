// NodeWithBound: an open node and its bound, which is computed at most once on a rank.
#pragma once

#include <limits>
#include <type_traits>
#include <utility>

namespace kusabi::engine {

/// A node of a problem with a `bound`. The bound is not sent to other ranks and not saved.
template <class Node>
struct NodeWithBound {
  Node node;
  /// NaN: not computed yet
  mutable double bound = std::numeric_limits<double>::quiet_NaN();
};

/// The node itself, whether its bound is stored with it or not.
template <class Node>
const Node& node_of(const Node& node) {
  return node;
}
template <class Node>
Node& node_of(Node& node) {
  return node;
}
template <class Node>
const Node& node_of(const NodeWithBound<Node>& stored) {
  return stored.node;
}
template <class Node>
Node& node_of(NodeWithBound<Node>& stored) {
  return stored.node;
}

/// A node type with a bound. (Bounded, in engine/problem.hpp, requires more, and depends on the
/// form in which nodes are stored.)
template <class P>
concept NamesBoundOfNode = requires(const P& problem, const typename P::Node& node) {
  problem.bound(node);
};

template <class P>
struct NodeStorage {
  using Type = typename P::Node;
};
template <NamesBoundOfNode P>
struct NodeStorage<P> {
  using Type = NodeWithBound<typename P::Node>;
};

/// Form in which the open nodes of `P` are stored.
template <class P>
using StoredNode = typename NodeStorage<P>::Type;

/// The node in this form, or a reference to it if it is that form already.
template <class P>
decltype(auto) stored(typename P::Node&& node) {
  if constexpr (std::is_same_v<StoredNode<P>, typename P::Node>) {
    return std::move(node);
  } else {
    return StoredNode<P>{std::move(node)};
  }
}

}  // namespace kusabi::engine
