// Heap: the open nodes of one rank in the order of their bounds, least first.
//
// The nodes come from all over the tree, so each needs the trail above it. Nodes inserted together,
// in particular the children of one node, share one trail; it continues that of the node taken last
// (engine/detail/nodes/shared_trail.hpp), so that memory grows with the number of nodes, not with
// their depths.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <utility>
#include <vector>

#include "engine/detail/contract.hpp"
#include "engine/detail/nodes/open_nodes.hpp"
#include "engine/detail/nodes/saved_list.hpp"
#include "engine/detail/nodes/shared_trail.hpp"
#include "engine/wire.hpp"

namespace kusabi::engine {

/// @post nodes are taken in the order of their bounds; among equal bounds the last inserted comes
///     first, so that equal bounds give depth-first order
template <class Node>
class Heap {
 public:
  /// @param max_nodes, max_bytes the heap is full from either on; one insertion may exceed them
  explicit Heap(std::size_t max_nodes = no_limit, std::size_t max_bytes = no_limit)
      : max_nodes_(max_nodes), max_bytes_(max_bytes) {}
  Heap(const Heap&) = delete;
  Heap& operator=(const Heap&) = delete;

  [[nodiscard]] bool empty() const { return keys_.empty(); }
  [[nodiscard]] std::size_t size() const { return keys_.size(); }

  /// Bytes of the trails and, if there is a limit of bytes, of the nodes.
  [[nodiscard]] std::size_t bytes() const { return trail_bytes_ + node_bytes_; }
  [[nodiscard]] bool full() const { return size() >= max_nodes_ || bytes() >= max_bytes_; }

  /// The next node: none has a smaller bound.
  /// @pre not empty()
  [[nodiscard]] const Node& best() const { return entries_[keys_.front().slot].open.node; }

  /// Inserts the nodes of a bundle.
  /// @param bound_of function of a node: its lower bound
  /// @throws std::domain_error if a bound is NaN
  template <class BoundOf>
  void put(Bundle<Node>&& bundle, BoundOf bound_of) {
    const auto trail =
        SharedTrail::of(std::move(bundle.trail), taken_.trail, taken_.depth, trail_bytes_);
    for (auto& open : bundle.nodes) {
      const double bound = bound_of(std::as_const(open.node));
      if (std::isnan(bound)) throw std::domain_error("a bound is not a number");
      const auto bytes =
          max_bytes_ == no_limit ? 0 : sizeof(Key) + sizeof(Entry) + packed_size_(open);
      insert({bound, ++puts_, 0}, {trail, bytes, std::move(open)});
    }
  }

  /// Removes and returns the best node, with its trail.
  /// @pre not empty()
  Bundle<Node> take() {
    auto best = remove_best().second;
    taken_ = {best.trail, best.open.depth};
    return bundle_of(best);
  }

  /// True if a node can be given away and one is left here.
  [[nodiscard]] bool can_transfer() const { return size() >= 2; }

  /// Removes and returns the second, fourth, sixth … best node: at most half of the nodes, and at
  /// most `limit` bytes, but at least one node. Both sides thus continue with equally good nodes.
  /// @pre can_transfer()
  Transfer<Node> give(std::size_t limit) {
    ensure(can_transfer(), "a heap gives nodes only if one is left");
    Transfer<Node> transfer;
    std::vector<std::pair<Key, Entry>> kept;
    PackedSize<Bundle<Node>> packed_size;
    std::size_t bytes = 0;
    for (auto left = size() / 2; left > 0; --left) {
      kept.push_back(remove_best());
      auto [key, entry] = remove_best();
      auto bundle = bundle_of(entry);
      bytes += packed_size(bundle);
      if (!transfer.empty() && bytes > limit) {
        entry.open = std::move(bundle.nodes.front());
        kept.emplace_back(key, std::move(entry));
        break;
      }
      transfer.push_back(std::move(bundle));
    }
    for (auto& [key, entry] : kept) insert(key, std::move(entry));
    return transfer;
  }

  /// All nodes, as long as this heap does not change. Nodes inserted together stay together, in the
  /// same order.
  [[nodiscard]] SavedList<SavedBundle<Node>> all() const {
    std::vector<const Key*> keys;
    keys.reserve(size());
    for (const auto& key : keys_) keys.push_back(&key);
    std::sort(keys.begin(), keys.end(), [](const Key* a, const Key* b) { return a->age < b->age; });
    const auto ends_bundle = [this](const Key* a, const Key* b) {
      return entries_[a->slot].trail != entries_[b->slot].trail;
    };
    std::size_t bundles = keys.empty() ? 0 : 1;
    for (std::size_t i = 1; i < keys.size(); ++i) {
      if (ends_bundle(keys[i - 1], keys[i])) ++bundles;
    }
    return {bundles, [this, keys = std::move(keys), ends_bundle](const auto& look) {
              for (auto begin = keys.begin(); begin != keys.end();) {
                auto end = std::adjacent_find(begin, keys.end(), ends_bundle);
                if (end != keys.end()) ++end;
                const auto& above = *entries_[(*begin)->slot].trail;
                const auto trail = above.first(above.size());
                const auto for_each = [&](const auto& see) {
                  std::for_each(begin, end, [&](const Key* key) { see(entries_[key->slot].open); });
                };
                look({trail, {static_cast<std::size_t>(end - begin), for_each}});
                begin = end;
              }
            }};
  }

 private:
  // The heap orders small keys: to move whole entries takes several times as long.
  struct Key {
    double bound;
    std::uint64_t age;
    std::size_t slot;  // place of the entry
  };
  struct Entry {
    SharedTrail::Pointer trail;  // down to the deepest node that shares it
    std::size_t bytes;
    OpenNode<Node> open;
  };
  // Trail above the node taken last, which has that depth.
  struct Taken {
    SharedTrail::Pointer trail;
    std::size_t depth = 0;
  };
  static constexpr std::size_t no_limit = std::numeric_limits<std::size_t>::max();

  // Comparison for std::push_heap, which keeps the greatest element in front; here that is the
  // best.
  static bool worse(const Key& a, const Key& b) {
    return a.bound != b.bound ? a.bound > b.bound : a.age < b.age;
  }

  void insert(Key key, Entry&& entry) {
    node_bytes_ += entry.bytes;
    if (free_.empty()) {
      key.slot = entries_.size();
      entries_.push_back(std::move(entry));
    } else {
      key.slot = free_.back();
      free_.pop_back();
      entries_[key.slot] = std::move(entry);
    }
    keys_.push_back(key);
    std::push_heap(keys_.begin(), keys_.end(), worse);
  }

  std::pair<Key, Entry> remove_best() {
    std::pop_heap(keys_.begin(), keys_.end(), worse);
    const auto key = keys_.back();
    keys_.pop_back();
    free_.push_back(key.slot);
    auto& entry = entries_[key.slot];
    node_bytes_ -= entry.bytes;
    return {key, std::move(entry)};
  }

  // Moves the node only: the entry keeps its trail.
  static Bundle<Node> bundle_of(Entry& entry) {
    Bundle<Node> bundle{entry.trail->first(entry.open.depth), {}};
    bundle.nodes.push_back(std::move(entry.open));
    return bundle;
  }

  std::size_t max_nodes_;
  std::size_t max_bytes_;
  std::size_t trail_bytes_ = 0;
  std::size_t node_bytes_ = 0;
  PackedSize<OpenNode<Node>> packed_size_;
  Taken taken_;
  std::vector<Key> keys_;          // a heap
  std::vector<Entry> entries_;     // in no order
  std::vector<std::size_t> free_;  // slots without an entry
  std::uint64_t puts_ = 0;
};

}  // namespace kusabi::engine
