// Elimination of rigid-body modes by column operations.
#include "solvers/rays/pivoted_modes.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace kusabi::rays {

PivotedModes combined(LongMatrix motions) {
  const Eigen::Index count = motions.cols();
  PivotedModes result;
  long double largest = motions.size() == 0 ? 0 : motions.cwiseAbs().maxCoeff();
  for (Eigen::Index done = 0; done < count; ++done) {
    const auto normals = motions(Eigen::seq(0, Eigen::last, 2), Eigen::seq(done, Eigen::last));
    Eigen::Index pivot = 0;
    Eigen::Index column = 0;
    const long double size = normals.cwiseAbs().maxCoeff(&pivot, &column);
    if (size <= sliding * largest) {
      break;
    }
    largest = std::max(largest, size);
    motions.col(done).swap(motions.col(done + column));
    for (Eigen::Index k = done + 1; k < count; ++k) {
      motions.col(k) -= motions(2 * pivot, k) / motions(2 * pivot, done) * motions.col(done);
      motions(2 * pivot, k) = 0;
    }
    result.pivots.push_back(static_cast<int>(pivot));
  }
  // Rounding of zeros, from directions with sixteen digits.
  for (auto& entry : motions.reshaped()) {
    if (std::abs(entry) <= sliding * largest) entry = 0;
  }
  result.moves = std::move(motions);
  return result;
}

}  // namespace kusabi::rays
