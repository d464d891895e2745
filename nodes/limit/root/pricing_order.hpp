// Order of the pricing programs of a round: each starts from the basis of the previous one, and
// loads at nearby nodes have similar forces.
#pragma once

#include <span>
#include <vector>

#include "problems/limit/limit_analysis.hpp"

namespace kusabi::limit {

/// Neighbours are displacements on which a member exerts opposite forces: those of its two ends
/// along one axis. A column of T is represented by its first component.
class PricingOrder {
 public:
  explicit PricingOrder(const problems::LimitModel& model);

  /// A walk through the columns: from the first one to the nearest remaining one, and so on; the
  /// least of several equally near ones, or if none can be reached.
  /// @param columns of T, ascending
  [[nodiscard]] std::vector<int> walk(std::span<const int> columns) const;

 private:
  std::vector<int> degree_;                   // by column of T
  std::vector<std::vector<int>> neighbours_;  // by displacement
};

}  // namespace kusabi::limit
