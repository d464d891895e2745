// In which order the pricing programs of a round are solved: each starts from the basis of the one
// before, and loads near each other have similar forces.
#pragma once

#include <span>
#include <vector>

#include "problems/limit/limit_analysis.hpp"

namespace kusabi::limit {

/// Neighbours are displacements that a member pulls with opposite forces: those of its two ends
/// along one axis. Of a column of T the first component counts.
class PricingOrder {
 public:
  explicit PricingOrder(const problems::LimitModel& model);

  /// A walk through the columns: from the first of them to the nearest that is left, and so on;
  /// where several are as near, or none can be reached, to the least.
  /// @param columns of T, ascending
  [[nodiscard]] std::vector<int> walk(std::span<const int> columns) const;

 private:
  std::vector<int> degree_;                   // by column of T
  std::vector<std::vector<int>> neighbours_;  // by displacement
};

}  // namespace kusabi::limit
