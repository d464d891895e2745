// NodeStack: open nodes of one line from the root.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "engine/detail/nodes/open_nodes.hpp"
#include "engine/detail/nodes/saved_list.hpp"

namespace kusabi::engine {

/// Open nodes, shallowest first. Nodes are opened at the deep end and given away at the shallow
/// end.
///
/// The cost of giving is proportional to the number of nodes given: those at the shallow end that
/// stay are moved up to the others. The free space in front is reclaimed when it is as large as the
/// remaining part, which amortises to one move per node given.
template <class Node>
class NodeStack {
 public:
  NodeStack() = default;
  explicit NodeStack(std::vector<OpenNode<Node>>&& nodes) : nodes_(std::move(nodes)) {}

  [[nodiscard]] bool empty() const { return begin() == end(); }
  [[nodiscard]] std::size_t size() const { return nodes_.size() - front_; }

  /// Shallowest node.
  [[nodiscard]] auto begin() const { return nodes_.begin() + signed_front(); }
  [[nodiscard]] auto end() const { return nodes_.end(); }

  /// Deepest node. @pre not empty()
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
    if (nodes_.size() == nodes_.capacity()) [[unlikely]]
      return grow(std::move(node), depth, branch);
    nodes_.emplace_back(std::move(node), depth, branch);
  }

  /// Reverses the order of the last `count` nodes.
  void reverse_last(std::uint32_t count) {
    std::reverse(nodes_.end() - static_cast<std::ptrdiff_t>(count), nodes_.end());
  }

  /// Removes and returns the nodes 0, 2, 4, ...: `count` of them, or as many as fit into `limit`
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
    // The nodes between, 1, 3, 5, ..., are moved up to the one after the last given.
    for (std::size_t kept = given.size() - 1; kept > 0; --kept) {
      node(given.size() + kept - 1) = std::move(node(2 * kept - 1));
    }
    front_ += given.size();
    if (front_ >= size()) reclaim();
    return given;
  }

  /// All nodes, as long as this stack does not change.
  [[nodiscard]] SavedList<OpenNode<Node>> all() const {
    return {size(), [this](const auto& look) { std::for_each(begin(), end(), look); }};
  }

  /// Removes and returns all nodes.
  std::vector<OpenNode<Node>> take_all() {
    reclaim();
    return std::exchange(nodes_, {});
  }

 private:
  // Apart, so that the frequent case needs no registers for a reallocation.
  [[gnu::noinline]] void grow(Node&& node, std::uint32_t depth, std::uint32_t branch) {
    nodes_.emplace_back(std::move(node), depth, branch);
  }

  [[nodiscard]] std::ptrdiff_t signed_front() const { return static_cast<std::ptrdiff_t>(front_); }

  void reclaim() {
    nodes_.erase(nodes_.begin(), nodes_.begin() + signed_front());
    front_ = 0;
  }

  std::vector<OpenNode<Node>> nodes_;
  std::size_t front_ = 0;  // nodes before this index were given away
};

}  // namespace kusabi::engine
