// The best solution known so far, as all ranks need to know it: its value and its place.
#pragma once

#include <limits>

#include <boost/serialization/vector.hpp>

#include "engine/path.hpp"

namespace kusabi::engine {

/// Of two solutions with the same objective the one with the smaller path is better, so the best of
/// all does not depend on who found what first.
struct Incumbent {
  bool exists = false;
  double objective = std::numeric_limits<double>::infinity();
  Path path;

  [[nodiscard]] bool better_than(const Incumbent& other) const {
    if (!exists || !other.exists) return exists;
    if (objective != other.objective) return objective < other.objective;
    return path < other.path;
  }

  /// Whether nothing below the node at `path`, whose solutions have objectives of `bound` or more,
  /// can be better. (A path that is greater without being a continuation has only greater ones
  /// below it; so has a continuation.)
  [[nodiscard]] bool rules_out(double bound, const Path& node) const {
    return exists && (bound > objective || (bound == objective && path < node));
  }

  /// The same for what the node at `path` may yield itself after what it has yielded already.
  [[nodiscard]] bool rules_out_more(double bound, const Path& node) const {
    return exists && (bound > objective || (bound == objective && !(node < path)));
  }

  template <class Archive>
  void serialize(Archive& archive, unsigned /*version*/) {
    archive& exists& objective& path;
  }
};

}  // namespace kusabi::engine
