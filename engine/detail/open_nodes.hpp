// Nodes that wait to be opened, and how they travel: alone they know their depth and branch number
// only, so the line from the root that they lie on, the *trail*, goes with them.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <iterator>
#include <type_traits>
#include <utility>
#include <vector>

#include <boost/serialization/vector.hpp>

#include "engine/wire.hpp"

namespace kusabi::engine {

/// One node of the trail. `branches` and `share_of_each` are valid only after Frontier::close(),
/// when all of its children are known.
struct Step {
  std::uint32_t branch = 0;    ///< which child of the step above; of no meaning at the root
  std::uint32_t branches = 0;  ///< how many children this node has
  std::uint64_t hash = 0;      ///< of the path that ends here; the children's marks are made of it
  double share_of_each = 0;    ///< of its children, of the whole tree; the first has Work times it

  template <class Archive>
  void serialize(Archive& archive, unsigned /*version*/) {
    archive& branch& branches& hash& share_of_each;
  }
};

/// A node that waits to be opened.
template <class Node>
struct OpenNode {
  Node node;
  std::uint32_t depth = 0;   ///< the root has depth 0
  std::uint32_t branch = 0;  ///< its number among the children of the trail's node above

  OpenNode() = default;
  OpenNode(Node&& waiting, std::uint32_t its_depth, std::uint32_t its_branch)
      : node(std::move(waiting)), depth(its_depth), branch(its_branch) {}
  // Field by field, as GCC 12 does it, a node of six numbers costs five nanoseconds more.
  OpenNode(Node&& waiting, std::uint32_t its_depth,
           std::uint32_t its_branch) requires std::is_trivially_copyable_v<Node>
      : depth(its_depth), branch(its_branch) {
    std::memcpy(&node, &waiting, sizeof node);
  }

  template <class Archive>
  void serialize(Archive& archive, unsigned /*version*/) {
    archive& node& depth& branch;
  }
};

/// Nodes taken out of a frontier or heap, with the part of the trail above them.
template <class Node>
struct Bundle {
  std::vector<Step> trail;            ///< from the root down to the parent of the deepest node
  std::vector<OpenNode<Node>> nodes;  ///< shallowest first

  template <class Archive>
  void serialize(Archive& archive, unsigned /*version*/) {
    archive& trail& nodes;
  }
};

/// Nodes on their way to another rank.
template <class Node>
using Gift = std::vector<Bundle<Node>>;

template <class Node>
std::size_t size_of(const Gift<Node>& gift) {
  std::size_t nodes = 0;
  for (const auto& bundle : gift) nodes += bundle.nodes.size();
  return nodes;
}

/// Open nodes, shallowest first: opened at the deep end, given away at the shallow one.
///
/// A gift costs what is given, however many nodes there are: of those at the shallow end, the ones
/// that stay move up to all the others. The room in front of them is reclaimed as soon as it is as
/// large as what is left, so each node given pays for one that moves.
template <class Node>
class NodeStack {
 public:
  NodeStack() = default;
  explicit NodeStack(std::vector<OpenNode<Node>>&& nodes) : nodes_(std::move(nodes)) {}

  [[nodiscard]] bool empty() const { return begin() == end(); }
  [[nodiscard]] std::size_t size() const { return nodes_.size() - front_; }

  /// The shallowest one.
  [[nodiscard]] auto begin() const { return nodes_.begin() + signed_front(); }
  [[nodiscard]] auto end() const { return nodes_.end(); }

  /// The deepest one. @pre not empty()
  [[nodiscard]] OpenNode<Node>& back() { return nodes_.back(); }
  [[nodiscard]] const OpenNode<Node>& back() const { return nodes_.back(); }
  void pop_back() { nodes_.pop_back(); }
  [[nodiscard]] const OpenNode<Node>& operator[](std::size_t place) const {
    return nodes_[front_ + place];
  }

  /// Keeps the first `size` nodes.
  void shorten(std::size_t size) {
    nodes_.erase(begin() + static_cast<std::ptrdiff_t>(size), nodes_.end());
  }

  void emplace_back(Node&& node, std::uint32_t depth, std::uint32_t branch) {
    nodes_.emplace_back(std::move(node), depth, branch);
  }

  /// Turns the order of all nodes from number `place` on.
  void reverse_from(std::size_t place) {
    std::reverse(nodes_.begin() + static_cast<std::ptrdiff_t>(front_ + place), nodes_.end());
  }

  /// Takes out the first, the third, the fifth ...: `count` of them, or as many as fit into `limit`
  /// bytes, but at least one.
  /// @pre 0 < count and 2 * count <= size() + 1
  std::vector<OpenNode<Node>> give(std::size_t count, std::size_t limit) {
    const auto first = nodes_.begin() + signed_front();
    const auto node = [&](std::size_t place) -> OpenNode<Node>& {
      return first[static_cast<std::ptrdiff_t>(place)];
    };
    std::vector<OpenNode<Node>> given;
    PackedSize<OpenNode<Node>> packed_size;
    std::size_t bytes = 0;
    while (given.size() < count) {
      auto& next = node(2 * given.size());
      bytes += packed_size(next);
      if (!given.empty() && bytes > limit) break;
      given.push_back(std::move(next));
    }
    // Those between, at 1, 3, 5 ..., come to lie just before the one after the last given.
    for (std::size_t kept = given.size() - 1; kept > 0; --kept) {
      node(given.size() + kept - 1) = std::move(node(2 * kept - 1));
    }
    front_ += given.size();
    if (front_ >= size()) reclaim();
    return given;
  }

  /// Takes out all.
  std::vector<OpenNode<Node>> take_all() {
    reclaim();
    return std::exchange(nodes_, {});
  }

 private:
  [[nodiscard]] std::ptrdiff_t signed_front() const { return static_cast<std::ptrdiff_t>(front_); }

  void reclaim() {
    nodes_.erase(nodes_.begin(), nodes_.begin() + signed_front());
    front_ = 0;
  }

  std::vector<OpenNode<Node>> nodes_;
  std::size_t front_ = 0;  // what is before it was given away
};

}  // namespace kusabi::engine
