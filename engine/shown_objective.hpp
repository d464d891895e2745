// How the objective of a search is shown to a person who knows it in other units.
#pragma once

#include <limits>

namespace kusabi::engine {

/// Objective and bound as the user knows them, for a search that has its own.
struct ShownObjective {
  double unit = 1;  ///< one of the search's is so much; negative: the user maximises
  /// What is known of the optimum besides the search, in its own units.
  double above = std::numeric_limits<double>::infinity();
  double below = -std::numeric_limits<double>::infinity();
};

}  // namespace kusabi::engine
