// Incumbent: objective and path of the best known solution, as shared by all ranks.
#pragma once

#include <cmath>
#include <compare>
#include <limits>
#include <stdexcept>

#include <boost/serialization/vector.hpp>

#include "engine/path.hpp"

namespace kusabi::engine {

/// Among solutions of equal objective the one with the smaller path is better, so that the result
/// does not depend on the order of discovery.
struct Incumbent {
  bool exists = false;
  double objective = std::numeric_limits<double>::infinity();
  Path path;

  [[nodiscard]] bool better_than(const Incumbent& other) const {
    if (!exists || !other.exists) return exists;
    if (objective != other.objective) return objective < other.objective;
    return path < other.path;
  }

  /// True if no solution below a node can be better than the incumbent. (If the node's path is not
  /// smaller than that of the incumbent, no path below it is.)
  /// @param bound lower bound of the objectives below the node
  /// @param place the node's path, or an object that compares with a path by <=>; read only if the
  ///   objectives are equal
  /// @throws std::domain_error if the bound is NaN
  template <class Place = Path>
  [[nodiscard]] bool rules_out(double bound, const Place& place) const {
    if (!exists || bound < objective) return false;
    return above(bound) || std::is_lt(path <=> place);
  }

  /// As `rules_out`, for further solutions of the node that reported the incumbent.
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
