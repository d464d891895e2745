// Sums over the components.
#include "problems/limit/uncertain_column.hpp"

#include <algorithm>
#include <cmath>

namespace kusabi::problems {

UncertainColumn UncertainColumn::single(int degree, double value) {
  return {std::abs(value), {{degree, value < 0 ? -1.0 : 1.0}}};
}

double UncertainColumn::along(const Eigen::VectorXd& motion) const {
  double total = 0;
  for (const auto& [degree, value] : direction) total += value * motion(degree);
  return total;
}

void UncertainColumn::add_to(Eigen::VectorXd& load, double zeta) const {
  for (const auto& [degree, value] : direction) load(degree) += weight * value * zeta;
}

double UncertainColumn::largest() const {
  double most = 0;
  for (const auto& [degree, value] : direction) most = std::max(most, std::abs(value));
  return weight * most;
}

}  // namespace kusabi::problems
