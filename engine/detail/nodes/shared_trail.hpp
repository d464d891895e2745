// SharedTrail: the trail above some nodes of a heap, which shares its upper part with others.
//
// In best-first order, each node that is opened adds one step to the trail above it. A trail of its
// own for each node would need memory quadratic in the depth of the tree. A trail therefore
// continues that of an ancestor; a short continuation is copied instead, so that trails of usual
// depth are one array.
#pragma once

#include <algorithm>
#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

#include "engine/detail/nodes/open_nodes.hpp"

namespace kusabi::engine {

class SharedTrail {
 public:
  using Pointer = std::shared_ptr<SharedTrail>;

  /// @param total sum of the bytes of all trails, which outlives them
  SharedTrail(Pointer above, std::size_t start, std::vector<TrailStep>&& steps, std::size_t& total)
      : above_(std::move(above)), start_(start), steps_(std::move(steps)), total_(total) {
    total_ += bytes();
  }
  SharedTrail(const SharedTrail&) = delete;
  SharedTrail& operator=(const SharedTrail&) = delete;
  ~SharedTrail() {
    total_ -= bytes();
    // A loop, since a recursion over a long chain of trails would overflow the stack.
    auto next = std::move(above_);
    while (next && next.use_count() == 1) next = std::exchange(next->above_, nullptr);
  }

  /// The trail `steps`. It shares its first `depth` steps with `known`, if both agree there.
  static Pointer of(std::vector<TrailStep>&& steps, Pointer known, std::size_t depth,
                    std::size_t& total) {
    while (known && known->start_ >= depth) known = known->above_;
    if (!known || depth > steps.size() || !(known->last_of(depth).hash == steps[depth - 1].hash)) {
      return std::make_shared<SharedTrail>(nullptr, 0, std::move(steps), total);
    }
    if (steps.size() - known->start_ <= longest_copy) {
      depth = known->start_;
      known = known->above_;
    }
    steps.erase(steps.begin(), steps.begin() + static_cast<std::ptrdiff_t>(depth));
    steps.shrink_to_fit();
    return std::make_shared<SharedTrail>(std::move(known), depth, std::move(steps), total);
  }

  /// Its first `depth` steps.
  [[nodiscard]] std::vector<TrailStep> first(std::size_t depth) const {
    std::vector<TrailStep> trail(depth);
    for (const auto* part = this; depth > 0; part = part->above_.get()) {
      if (part->start_ >= depth) continue;
      std::copy_n(part->steps_.begin(), depth - part->start_,
                  trail.begin() + static_cast<std::ptrdiff_t>(part->start_));
      depth = part->start_;
    }
    return trail;
  }

  [[nodiscard]] std::size_t size() const { return start_ + steps_.size(); }

 private:
  static constexpr std::size_t longest_copy = 128;

  [[nodiscard]] const TrailStep& last_of(std::size_t depth) const {
    return steps_[depth - 1 - start_];
  }
  [[nodiscard]] std::size_t bytes() const {
    return sizeof(SharedTrail) + steps_.capacity() * sizeof(TrailStep);
  }

  Pointer above_;
  std::size_t start_;  // steps taken from the trail above
  std::vector<TrailStep> steps_;
  std::size_t& total_;
};

}  // namespace kusabi::engine
