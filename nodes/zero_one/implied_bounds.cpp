// Rows as intervals: bounds of one column from those of the others.
#include "nodes/zero_one/implied_bounds.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "solvers/linear/rounded.hpp"

namespace kusabi::zero_one {
namespace {

using linear::Interval;
using linear::rounded::product_down;
using linear::rounded::product_up;

constexpr int rounds = 8;
// A bound that changes by less than this share of the width is not changed: otherwise bounds may
// approach a limit in ever smaller steps.
constexpr double worth_it = 0.05;

struct Row {
  double lower = -linear::infinity;
  double upper = linear::infinity;
  std::vector<linear::LinearTerm> terms;
};

Interval times(double a, double lower, double upper) {
  return a > 0 ? Interval{product_down(a, lower), product_up(a, upper)}
               : Interval{product_down(a, upper), product_up(a, lower)};
}

bool tightens(double old_bound, double new_bound, double width) {
  if (!std::isfinite(new_bound)) return false;
  if (!std::isfinite(old_bound)) return true;
  return std::abs(new_bound - old_bound) > worth_it * width;
}

class Propagation {
 public:
  explicit Propagation(ColumnBounds& bounds) : bounds_(bounds) {}

  /// @return true if a bound changed
  bool apply(const Row& row) {
    const std::size_t count = row.terms.size();
    // Sums over the terms before and from each one on; both together leave one out, without a
    // subtraction, which infinite terms would spoil.
    from_.assign(count + 1, {});
    for (std::size_t k = count; k-- > 0;) from_[k] = term(row, k) + from_[k + 1];
    Interval before{};
    bool moved = false;
    for (std::size_t k = 0; k < count; ++k) {
      const auto own = term(row, k);
      const auto others = before + from_[k + 1];
      before = before + own;
      const double minimum = linear::rounded::sum_down(row.lower, -others.upper);
      const double maximum = linear::rounded::sum_up(row.upper, -others.lower);
      moved = narrow(row.terms[k], minimum, maximum) || moved;
    }
    return moved;
  }

 private:
  [[nodiscard]] Interval term(const Row& row, std::size_t k) const {
    const auto j = static_cast<std::size_t>(row.terms[k].column);
    return times(row.terms[k].value, bounds_.lower[j], bounds_.upper[j]);
  }

  // minimum <= a x <= maximum
  bool narrow(const linear::LinearTerm& at, double minimum, double maximum) {
    if (std::isnan(minimum)) minimum = -linear::infinity;
    if (std::isnan(maximum)) maximum = linear::infinity;
    const auto j = static_cast<std::size_t>(at.column);
    if (at.value < 0) std::swap(minimum, maximum);
    const double below =
        std::isfinite(minimum) ? quotient_down(minimum, at.value) : -linear::infinity;
    const double above =
        std::isfinite(maximum) ? -quotient_down(-maximum, at.value) : linear::infinity;
    const double width = bounds_.upper[j] - bounds_.lower[j];
    bool moved = false;
    if (below > bounds_.lower[j] && tightens(bounds_.lower[j], below, width)) {
      bounds_.lower[j] = std::min(below, bounds_.upper[j]);
      moved = true;
    }
    if (above < bounds_.upper[j] && tightens(bounds_.upper[j], above, width)) {
      bounds_.upper[j] = std::max(above, bounds_.lower[j]);
      moved = true;
    }
    return moved;
  }

  static double quotient_down(double a, double b) { return linear::rounded::before(a / b); }

  ColumnBounds& bounds_;
  std::vector<Interval> from_;
};

}  // namespace

ColumnBounds own_bounds(const linear::LinearProgram& program) {
  ColumnBounds bounds;
  for (const auto& column : program.columns) {
    bounds.lower.push_back(column.lower);
    bounds.upper.push_back(column.upper);
  }
  return bounds;
}

ColumnBounds implied_bounds(const linear::LinearProgram& program, double cutoff) {
  auto bounds = own_bounds(program);
  std::vector<Row> rows;
  for (const auto& row : program.rows) rows.push_back({row.lower, row.upper, {}});
  for (const auto& [row, column, value] : program.entries) {
    // An M may have been reduced to zero.
    if (value != 0) rows[static_cast<std::size_t>(row)].terms.push_back({column, value});
  }
  if (std::isfinite(cutoff)) {
    Row objective;
    objective.upper = linear::rounded::sum_up(cutoff, -program.constant);
    for (std::size_t j = 0; j < program.columns.size(); ++j) {
      const double cost = program.columns[j].cost;
      if (cost != 0) objective.terms.push_back({static_cast<int>(j), cost});
    }
    rows.push_back(std::move(objective));
  }
  Propagation propagation(bounds);
  for (int round = 0; round < rounds; ++round) {
    bool moved = false;
    for (const auto& row : rows) moved = propagation.apply(row) || moved;
    if (!moved) break;
  }
  return bounds;
}

}  // namespace kusabi::zero_one
