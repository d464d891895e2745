// The best solution known so far, as all ranks need to know it: its value and its place.
#pragma once

#include <cmath>
#include <compare>
#include <limits>
#include <stdexcept>

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

  /// Whether nothing below a node, whose solutions have objectives of `bound` or more, can be
  /// better. (If the node's path is not smaller than that of the best solution, all paths below it
  /// are greater.)
  /// @param place the node's path, or anything in its place that a path can be compared with by
  ///   <=>: it is looked at only if the objectives are equal
  /// @throws std::domain_error if the bound is not a number
  template <class Place = Path>
  [[nodiscard]] bool rules_out(double bound, const Place& place) const {
    if (!exists || bound < objective) return false;
    return above(bound) || std::is_lt(path <=> place);
  }

  /// The same for what the node may yield itself after what it has yielded already.
  template <class Place = Path>
  [[nodiscard]] bool rules_out_more(double bound, const Place& place) const {
    if (!exists || bound < objective) return false;
    return above(bound) || std::is_lteq(path <=> place);
  }

  template <class Archive>
  void serialize(Archive& archive, unsigned /*version*/) {
    archive& exists& objective& path;
  }

 private:
  [[nodiscard]] bool above(double bound) const {
    if (std::isnan(bound)) throw std::domain_error("a bound is not a number");
    return bound > objective;
  }
};

}  // namespace kusabi::engine
