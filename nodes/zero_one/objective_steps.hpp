// Resolution of objectives: steps of about 1e-9 of their own size. Otherwise the search would
// enumerate all optima that are equal up to rounding. The step depends on the objective itself and
// on the program, never on a point found: the first one may contain a penalty of 1e12.
#pragma once

#include <algorithm>
#include <cmath>

namespace kusabi::zero_one {

class ObjectiveSteps {
 public:
  ObjectiveSteps() = default;
  /// @param min_size smaller objectives are distinguished as if they had this size, since zero has
  ///   no size of its own
  explicit ObjectiveSteps(double min_size) : min_size_(min_size) {}

  [[nodiscard]] double min_size() const { return min_size_; }

  /// The size for differences of objectives.
  [[nodiscard]] double size(double objective) const {
    return std::max(std::abs(objective), min_size_);
  }

  /// Width of the step around a finite objective: a power of two, 2^-30 of its size or somewhat
  /// more than half of that.
  [[nodiscard]] double width(double objective) const {
    return std::ldexp(1.0, std::ilogb(size(objective)) - bits);
  }

  /// The objective in whole steps; rounding keeps the order of two objectives.
  [[nodiscard]] double whole(double objective) const {
    if (!std::isfinite(objective)) return objective;
    const double step = width(objective);
    return std::round(objective / step) * step;
  }

 private:
  static constexpr int bits = 30;
  double min_size_ = 1;
};

}  // namespace kusabi::zero_one
