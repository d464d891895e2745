// Sums over the components.
#include "problems/limit/uncertain_column.hpp"

#include <algorithm>
#include <cmath>

namespace kusabi::problems {

UncertainColumn UncertainColumn::single(int degree, double value) {
  return {.weight = std::abs(value), .direction = {{degree, value < 0 ? -1.0 : 1.0}}};
}

double UncertainColumn::along(const Eigen::VectorXd& motion) const {
  double total = 0;
  for (const auto& [degree, value] : direction) total += value * motion(degree);
  return total;
}

void UncertainColumn::add_to(Eigen::VectorXd& load, double share) const {
  for (const auto& [degree, value] : direction) load(degree) += reach() * value * share;
}

double UncertainColumn::largest() const {
  double maximum = 0;
  for (const auto& [degree, value] : direction) maximum = std::max(maximum, std::abs(value));
  return reach() * maximum;
}

}  // namespace kusabi::problems
