// The open nodes of one rank, searched depth first.
//
// Every node that is open on a rank was branched off from one of the nodes on a single line from
// the root: the line of the node opened last. So a node need not carry its path; its depth and its
// branch number suffice, and the line itself, the *trail*, is stored once. Giving nodes away keeps
// this true on both sides: the giver keeps a subset, and the taker, which has nothing open, gets a
// subset together with the trail above it.
#pragma once

#include <algorithm>
#include <compare>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "engine/detail/contract.hpp"
#include "engine/detail/open_nodes.hpp"
#include "engine/path.hpp"

namespace kusabi::engine {

/// For the progress estimate: all children of a node have the same amount of work below them.
struct EqualWork {
  static constexpr double of_first_child = 1;
};

/// A stack of open nodes, shallowest first.
///
/// Requires: `branch` is called only between `open` and the next `open`.
/// Guarantees: nodes are opened in depth-first order, the children of a node in the order in which
/// they were branched; at most depth x branching nodes are open at any time.
///
/// @tparam Work says how much is guessed to be below a first child (problem.hpp)
template <class Node, class Work = EqualWork>
class Frontier {
 public:
  [[nodiscard]] bool empty() const { return nodes_.empty(); }
  [[nodiscard]] std::size_t size() const { return nodes_.size(); }
  [[nodiscard]] std::size_t peak() const { return peak_; }

  /// Puts the root in, as the only open node.
  void plant(Node root) {
    nodes_.take_all();
    nodes_.emplace_back(std::move(root), 0, 0);
    trail_.resize(1);
  }

  /// Takes the next node out; from now on the trail ends in it.
  /// @pre not empty()
  Node open() {
    ensure(!nodes_.empty(), "a node is opened only if one waits");
    auto& next = nodes_.back();
    depth_ = next.depth;
    branches_ = 0;
    if (depth_ == 0) {
      mark_ = root_mark;
      share_ = 1;
    } else {
      const Step& parent = trail_[depth_ - 1];
      mark_ = branch_mark(parent.hash, next.branch);
      share_ = parent.share_of_each;
      if (next.branch == 0) share_ *= Work::of_first_child;
    }
    trail_[depth_].branch = next.branch;
    Node node = std::move(next.node);
    nodes_.pop_back();
    first_child_ = nodes_.size();
    return node;
  }

  /// Adds a child of the node opened last, to be opened after the children already added.
  void branch(Node&& child) { nodes_.emplace_back(std::move(child), depth_ + 1, branches_++); }

  /// Calls `look(child)` for the children added so far to the node opened last.
  template <class Look>
  void for_each_child(Look look) const {
    for (std::size_t place = first_child_; place < nodes_.size(); ++place) look(nodes_[place].node);
  }

  /// Takes back all children added to the node opened last.
  void take_back() {
    nodes_.shorten(first_child_);
    branches_ = 0;
  }

  /// Ends the expansion of the node opened last as if it had not begun: it waits again.
  void put_back(Node&& node) {
    take_back();
    nodes_.emplace_back(std::move(node), depth_, trail_[depth_].branch);
    first_child_ = nodes_.size();
  }

  /// Ends the expansion of the node opened last: its first child comes to the top of the stack.
  /// @return the share of the whole tree that this closes: the node's own, if it has no children
  double close() {
    if (branches_ == 0) return share_;  // most nodes: nothing more is spent on them
    Step& step = trail_[depth_];
    step.branches = branches_;
    step.hash = hash_of_mark(mark_);
    step.share_of_each = share_ / (branches_ - 1 + Work::of_first_child);
    // The trail never shrinks: most nodes find their place in it made.
    if (trail_.size() < depth_ + std::size_t{2}) trail_.resize(depth_ + std::size_t{2});
    nodes_.reverse_from(first_child_);
    first_child_ = nodes_.size();
    peak_ = std::max(peak_, nodes_.size());
    return 0;
  }

  /// Calls `look(node)` for every open node.
  template <class Look>
  void for_each(Look look) const {
    for (const auto& open : nodes_) look(open.node);
  }

  /// A copy of all open nodes, with the trail above them.
  /// @pre not empty()
  [[nodiscard]] Bundle<Node> all() const {
    const auto deepest = static_cast<std::ptrdiff_t>(nodes_.back().depth);
    return {{trail_.begin(), trail_.begin() + deepest}, {nodes_.begin(), nodes_.end()}};
  }

  /// Takes out all that is open. @pre not empty(); no node is being expanded
  Bundle<Node> take_all() {
    const auto deepest = static_cast<std::ptrdiff_t>(nodes_.back().depth);
    first_child_ = 0;
    return {{trail_.begin(), trail_.begin() + deepest}, nodes_.take_all()};
  }

  /// What the node opened last adds to the mark sum of the search.
  [[nodiscard]] std::uint64_t mark() const { return mark_; }

  /// How many children the node opened last has so far.
  [[nodiscard]] std::uint32_t branches() const { return branches_; }

  /// The path of the node opened last.
  [[nodiscard]] Path path() const {
    Path path;
    path.reserve(depth_);
    for (std::size_t depth = 1; depth <= depth_; ++depth) path.push_back(trail_[depth].branch);
    return path;
  }

  /// The same to be compared with paths, which does not build it.
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

  /// Whether a node can be given away such that one is left here. Children that the current
  /// expansion is still adding cannot be given yet.
  [[nodiscard]] bool can_give() const { return first_child_ >= 2; }

  /// Takes out every other node from the shallowest on, so half of what there is; fewer if they
  /// would take more than `limit` bytes together, but at least one. (Giving the older half instead
  /// needs ten times as many steals on deep trees: the two sides swap the same few subtrees back
  /// and forth.)
  /// @pre can_give()
  Bundle<Node> give(std::size_t limit) {
    ensure(can_give(), "a frontier gives only if a node is left");
    Bundle<Node> gift;
    gift.nodes = nodes_.give(first_child_ / 2, limit);
    first_child_ -= gift.nodes.size();
    const auto deepest = static_cast<std::ptrdiff_t>(gift.nodes.back().depth);
    gift.trail.assign(trail_.begin(), trail_.begin() + deepest);
    return gift;
  }

  /// Puts the nodes of a bundle in.
  /// @pre empty()
  void take(Bundle<Node>&& bundle) {
    ensure(nodes_.empty(), "a frontier takes nodes of one line from the root only");
    trail_ = std::move(bundle.trail);
    nodes_ = NodeStack<Node>(std::move(bundle.nodes));
    trail_.resize(nodes_.back().depth + std::size_t{1});
    first_child_ = nodes_.size();
    peak_ = std::max(peak_, nodes_.size());
  }

 private:
  NodeStack<Node> nodes_;
  std::vector<Step> trail_;  // of use down to depth_ only
  // Of the node opened last:
  std::uint32_t depth_ = 0;
  std::uint32_t branches_ = 0;
  std::uint64_t mark_ = 0;
  double share_ = 0;

  std::size_t first_child_ = 0;  // nodes_ from here on are children still being branched
  std::size_t peak_ = 0;
};

}  // namespace kusabi::engine
