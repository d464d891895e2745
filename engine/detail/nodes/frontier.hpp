// Frontier: the open nodes of one rank in depth-first order.
//
// Every open node of a rank was branched from a node on a single line from the root: the line to
// the node opened last. A node therefore stores only its depth and branch number, and the line
// itself, the *trail*, is stored once. A transfer preserves this on both sides: the giver keeps a
// subset, and the taker, which has no open node, gets a subset together with the trail above it.
#pragma once

#include <algorithm>
#include <compare>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "engine/detail/contract.hpp"
#include "engine/detail/nodes/node_stack.hpp"
#include "engine/detail/nodes/open_nodes.hpp"
#include "engine/detail/nodes/saved_list.hpp"
#include "engine/path.hpp"

namespace kusabi::engine {

/// Progress estimate by default: all children of a node have the same work below them.
struct EqualWork {
  static constexpr double of_first_child = 1;
};

/// A stack of open nodes, shallowest first.
///
/// @pre `branch` is called only between `open` and the next `open`
/// @post nodes are opened in depth-first order, the children of a node in the order in which they
///     were branched; at most depth x branching nodes are open at any time
/// @tparam Work estimate of the work below a first child (engine/problem.hpp)
template <class Node, class Work = EqualWork>
class Frontier {
 public:
  [[nodiscard]] bool empty() const { return nodes_.empty(); }
  [[nodiscard]] std::size_t size() const { return nodes_.size(); }
  [[nodiscard]] std::size_t peak() const { return peak_; }

  /// Adds the root. @pre empty()
  void add_root(Node root) {
    nodes_.take_all();
    nodes_.emplace_back(std::move(root), 0, 0);
    trail_.resize(1);
  }

  /// Removes and returns the next node; the trail then ends at it.
  /// @pre not empty()
  Node open() {
    ensure(!nodes_.empty(), "a node is opened only if one waits");
    auto& next = nodes_.back();
    depth_ = next.depth;
    if (depth_ == 0) {
      mark_ = root_mark;
      share_ = 1;
    } else {
      const TrailStep& parent = trail_[depth_ - 1];
      mark_ = branch_mark(parent.hash, next.branch);
      share_ = parent.share_of_each;
      if (next.branch == 0) share_ *= Work::of_first_child;
    }
    trail_[depth_].branch = next.branch;
    Node node = std::move(next.node);
    nodes_.pop_back();
    return node;
  }

  /// Adds a child of the node opened last; it is opened after the children added before it.
  void branch(Node&& child) { nodes_.emplace_back(std::move(child), depth_ + 1, children_++); }

  /// Calls `look(child)` for the children added so far to the node opened last.
  template <class Look>
  void for_each_child(Look look) const {
    for (std::size_t place = settled(); place < nodes_.size(); ++place) look(nodes_[place].node);
  }

  /// Removes all children added to the node opened last.
  void take_back() {
    nodes_.shorten(settled());
    children_ = 0;
  }

  /// Ends the expansion of the node opened last as if it had not begun: the node is open again.
  void put_back(Node&& node) {
    take_back();
    nodes_.emplace_back(std::move(node), depth_, trail_[depth_].branch);
  }

  /// Ends the expansion of the node opened last: its first child moves to the top of the stack.
  /// @return the closed share of the tree: the share of the node if it has no children, otherwise 0
  double close() {
    if (children_ == 0) return share_;  // the frequent case returns early
    const auto step = trail_.begin() + depth_;
    step->branches = children_;
    step->hash = hash_of_mark(mark_);
    step->share_of_each = share_ / (children_ - 1 + Work::of_first_child);
    // The trail never shrinks, so that it is rarely reallocated.
    if (step + 1 == trail_.end()) trail_.resize(depth_ + std::size_t{2});
    nodes_.reverse_last(children_);
    children_ = 0;
    peak_ = std::max(peak_, nodes_.size());
    return 0;
  }

  /// Calls `look(node)` for every open node.
  template <class Look>
  void for_each(Look look) const {
    for (const auto& open : nodes_) look(open.node);
  }

  /// All open nodes, with the trail above them, as long as this frontier does not change.
  /// @pre not empty()
  [[nodiscard]] SavedBundle<Node> all() const {
    return {std::span(trail_).first(nodes_.back().depth), nodes_.all()};
  }

  /// Removes and returns all open nodes. @pre not empty(); no node is being expanded
  Bundle<Node> take_all() {
    const auto deepest = static_cast<std::ptrdiff_t>(nodes_.back().depth);
    return {{trail_.begin(), trail_.begin() + deepest}, nodes_.take_all()};
  }

  /// Contribution of the node opened last to the mark sum of the search.
  [[nodiscard]] std::uint64_t mark() const { return mark_; }

  /// Depth of the node opened last; 0 for the root.
  [[nodiscard]] std::size_t depth() const { return depth_; }

  /// Number of children of the node opened last.
  /// @pre its expansion has ended, and all of them are open
  [[nodiscard]] std::uint32_t branches() const {
    return empty() || nodes_.back().depth <= depth_ ? 0 : trail_[depth_].branches;
  }

  /// The path of the node opened last.
  [[nodiscard]] Path path() const {
    Path path;
    path.reserve(depth_);
    for (std::size_t depth = 1; depth <= depth_; ++depth) path.push_back(trail_[depth].branch);
    return path;
  }

  /// The path of the node opened last, comparable with a Path without being built.
  class Place {
   public:
    explicit Place(const Frontier& frontier) : frontier_(frontier) {}

    friend std::strong_ordering operator<=>(const Path& path, const Place& place) {
      return place.order_of(path);
    }

   private:
    [[nodiscard]] std::strong_ordering order_of(const Path& path) const {
      const std::size_t depth = frontier_.depth_;
      const std::size_t common = std::min(path.size(), depth);
      for (std::size_t above = 0; above < common; ++above) {
        const auto order = path[above] <=> frontier_.trail_[above + 1].branch;
        if (std::is_neq(order)) return order;
      }
      return path.size() <=> depth;
    }

    const Frontier& frontier_;
  };
  [[nodiscard]] Place place() const { return Place(*this); }

  /// True if a node can be given away and one is left here. Children that the current expansion is
  /// still adding cannot be given away.
  [[nodiscard]] bool can_transfer() const { return settled() >= 2; }

  /// Removes and returns every other node from the shallowest on, hence half of them; fewer if they
  /// would exceed `limit` bytes, but at least one. (Giving the older half needs ten times as many
  /// transfers on deep trees, since the same few subtrees move back and forth.)
  /// @pre can_transfer()
  Bundle<Node> give(std::size_t limit) {
    ensure(can_transfer(), "a frontier gives nodes only if one is left");
    Bundle<Node> transfer;
    transfer.nodes = nodes_.give(settled() / 2, limit);
    const auto deepest = static_cast<std::ptrdiff_t>(transfer.nodes.back().depth);
    transfer.trail.assign(trail_.begin(), trail_.begin() + deepest);
    return transfer;
  }

  /// Adds the nodes of a bundle.
  /// @pre empty()
  void take(Bundle<Node>&& bundle) {
    ensure(nodes_.empty(), "a frontier takes nodes of one line from the root only");
    trail_ = std::move(bundle.trail);
    nodes_ = NodeStack<Node>(std::move(bundle.nodes));
    trail_.resize(nodes_.back().depth + std::size_t{1});
    peak_ = std::max(peak_, nodes_.size());
  }

 private:
  // Number of open nodes without the children that the current expansion has added.
  [[nodiscard]] std::size_t settled() const { return nodes_.size() - children_; }

  NodeStack<Node> nodes_;
  std::vector<TrailStep> trail_;  // used down to depth_ only
  // Of the node opened last:
  std::uint32_t depth_ = 0;
  std::uint32_t children_ = 0;  // so far; 0 when its expansion has ended
  std::uint64_t mark_ = 0;
  double share_ = 0;

  std::size_t peak_ = 0;
};

}  // namespace kusabi::engine
