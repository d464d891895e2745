// Cut-generating program and interpretation of its solution.
#include "nodes/zero_one/disjunctive_cuts.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace kusabi::zero_one {
namespace {

using linear::infinity;
using linear::LinearStatus;
using linear::LinearTerm;

// A column closer to its bound than this is at it.
constexpr double at_bound = 1e-9;
// Coefficients below this share of the largest are rounding errors; without them the cut is another
// one, whose right-hand side is computed for itself.
constexpr double no_coefficient = 1e-10;
// A smaller violation is within the feasibility tolerance of GLPK.
constexpr double min_violation = 1e-6;
// If no inequality of both sides holds at the point's face, (51) is unbounded; the violation is
// limited to this multiple of the size of the point.
constexpr double max_violation = 1e3;
// Right-hand sides without a safe bound are relaxed by this, relative to the size of the terms.
constexpr double relaxation_share = 1e-8;
// Smaller numbers are rounded zeros. As coefficients of the cut-generating program they would spoil
// its scaling; the cut remains valid, since its right-hand side is computed anew.
constexpr double noise = 1e-9;

double without_noise(double number) {
  return std::abs(number) < noise ? 0 : number;
}

std::vector<double> without_noise(std::vector<double> numbers) {
  for (double& number : numbers) number = without_noise(number);
  return numbers;
}

enum class Spot : std::uint8_t { inside, lower, upper };

// (51), and the interpretation of its solution.
class CutProgram {
 public:
  CutProgram(const Relaxation& relaxation, std::size_t rows, const std::vector<double>& point,
             std::size_t binary)
      : relaxation_(relaxation),
        rows_(rows),
        point_(without_noise(point)),
        split_(static_cast<std::size_t>(relaxation.column(binary))) {
    locate();
    write();
  }

  std::optional<DisjunctiveCut> solve() {
    linear::Simplex simplex(program_);
    const linear::SolveLimits limits{.stop = relaxation_.stop()};
    auto status = simplex.solve_primal(limits);
    if (status == LinearStatus::failed) status = simplex.solve_robustly(limits);
    if (status != LinearStatus::optimal) return {};
    return cut(simplex.values());
  }

 private:
  [[nodiscard]] const linear::LinearProgram& given() const { return relaxation_.program(); }

  void locate() {
    const auto& columns = given().columns;
    spot_.resize(columns.size(), Spot::inside);
    alpha_.resize(columns.size(), -1);
    for (std::size_t j = 0; j < columns.size(); ++j) {
      if (j == split_) continue;
      if (point_[j] <= columns[j].lower + at_bound) {
        spot_[j] = Spot::lower;
      } else if (point_[j] >= columns[j].upper - at_bound) {
        spot_[j] = Spot::upper;
      }
    }
  }

  void write() {
    const auto& columns = given().columns;
    double size = 1;
    const double maximum = infinity;
    beta_ = program_.add_column({.cost = -1, .lower = -maximum, .upper = maximum});
    std::vector<LinearTerm> depth{{beta_, 1}};
    for (std::size_t j = 0; j < spot_.size(); ++j) {
      if (spot_[j] != Spot::inside) continue;
      // (51) normalises nonzero columns. A column with bounds is normalised even at zero: otherwise
      // its bounds make deep but useless cuts.
      const bool free = columns[j].lower == -infinity && columns[j].upper == infinity;
      const double norm = free && point_[j] == 0 ? infinity : 1;
      alpha_[j] = program_.add_column({.cost = point_[j], .lower = -norm, .upper = norm});
      depth.push_back({alpha_[j], -point_[j]});
      size += std::abs(point_[j]);
    }
    write_side(0);
    write_side(1);
    program_.add_row({.upper = max_violation * size}, depth);
  }

  // alpha and beta of one side of the disjunction, as combinations of its inequalities: (48).
  void write_side(std::size_t side) {
    const auto& columns = given().columns;
    std::vector<std::vector<LinearTerm>> sums(
        columns.size());                         // alpha_i of the columns that are not at a bound
    std::vector<LinearTerm> right{{beta_, -1}};  // >= 0
    const auto multiplier = [&](double lower, double upper, double bound) {
      const int column = program_.add_column({.lower = lower, .upper = upper});
      right.push_back({column, without_noise(bound)});
      return column;
    };
    // The columns at a bound are constants here.
    std::vector<double> constants(rows_);
    for (const auto& [row, column, value] : given().entries) {
      const auto i = static_cast<std::size_t>(row);
      const auto j = static_cast<std::size_t>(column);
      if (i < rows_ && spot_[j] != Spot::inside) constants[i] += value * bound_at(j);
    }
    auto& of_row = multipliers_[side];
    of_row.assign(rows_, {-1, -1});
    for (std::size_t i = 0; i < rows_; ++i) {
      const auto& row = given().rows[i];
      if (row.lower == row.upper) {
        of_row[i][0] = multiplier(-infinity, infinity, row.lower - constants[i]);
        continue;
      }
      if (std::isfinite(row.lower)) {
        of_row[i][0] = multiplier(0, infinity, row.lower - constants[i]);
      }
      if (std::isfinite(row.upper)) {
        of_row[i][1] = multiplier(-infinity, 0, row.upper - constants[i]);
      }
    }
    for (const auto& [row, column, value] : given().entries) {
      const auto i = static_cast<std::size_t>(row);
      const auto j = static_cast<std::size_t>(column);
      if (i >= rows_ || spot_[j] != Spot::inside) continue;
      for (const int of : of_row[i]) {
        if (of >= 0) sums[j].push_back({of, value});
      }
    }
    for (std::size_t j = 0; j < columns.size(); ++j) {
      if (spot_[j] != Spot::inside) continue;
      const auto& [cost, lower, upper, name] = columns[j];
      if (std::isfinite(lower)) sums[j].push_back({multiplier(0, infinity, lower), 1});
      if (std::isfinite(upper)) sums[j].push_back({multiplier(-infinity, 0, upper), 1});
      if (j == split_) {
        sums[j].push_back(side == 0 ? LinearTerm{multiplier(-infinity, 0, 0), 1}
                                    : LinearTerm{multiplier(0, infinity, 1), 1});
      }
      sums[j].push_back({alpha_[j], -1});
      program_.add_row({.lower = 0, .upper = 0}, sums[j]);
    }
    program_.add_row({.lower = 0}, right);
  }

  [[nodiscard]] double bound_at(std::size_t j) const {
    const auto& column = given().columns[j];
    return spot_[j] == Spot::lower ? column.lower : column.upper;
  }

  [[nodiscard]] std::vector<double> duals(const std::vector<double>& values,
                                          std::size_t side) const {
    std::vector<double> y(given().rows.size());
    for (std::size_t i = 0; i < rows_; ++i) {
      for (const int of : multipliers_[side][i]) {
        if (of >= 0) y[i] += values[static_cast<std::size_t>(of)];
      }
    }
    return y;
  }

  std::optional<DisjunctiveCut> cut(const std::vector<double>& values) const {
    const std::array<std::vector<double>, 2> y{duals(values, 0), duals(values, 1)};
    std::vector<double> alpha(spot_.size());
    // Columns at a bound: the least alpha_i that both sides allow above their own sum, so (54),
    // (58) and (59); at an upper bound the greatest below.
    std::array<std::vector<double>, 2> sum;
    for (const std::size_t side : {std::size_t{0}, std::size_t{1}}) {
      sum[side].resize(spot_.size());
      for (const auto& [row, column, value] : given().entries) {
        sum[side][static_cast<std::size_t>(column)] +=
            value * y[side][static_cast<std::size_t>(row)];
      }
    }
    double largest = 0;
    for (std::size_t j = 0; j < alpha.size(); ++j) {
      switch (spot_[j]) {
        case Spot::inside:
          alpha[j] = values[static_cast<std::size_t>(alpha_[j])];
          break;
        case Spot::lower:
          alpha[j] = std::max(sum[0][j], sum[1][j]);
          break;
        case Spot::upper:
          alpha[j] = std::min(sum[0][j], sum[1][j]);
          break;
      }
      largest = std::max(largest, std::abs(alpha[j]));
    }
    if (largest == 0) return {};
    // Scaled by a power of two, so that multipliers and coefficients remain consistent.
    const double scale = std::exp2(-std::ceil(std::log2(largest)));
    DisjunctiveCut cut;
    double at_point = 0;
    for (std::size_t j = 0; j < alpha.size(); ++j) {
      alpha[j] *= scale;
      if (std::abs(alpha[j]) < no_coefficient) alpha[j] = 0;
      if (alpha[j] == 0) continue;
      cut.terms.push_back({static_cast<int>(j), alpha[j]});
      at_point += alpha[j] * point_[j];
    }
    cut.lower = infinity;
    for (const std::size_t side : {std::size_t{0}, std::size_t{1}}) {
      auto scaled = y[side];
      for (double& multiplier : scaled) multiplier *= scale;
      const double held = side == 0 ? 0 : 1;
      cut.lower = std::min(cut.lower, relaxation_.minimum(alpha, scaled, static_cast<int>(split_),
                                                          held, relaxation_share));
    }
    cut.violation = cut.lower - at_point;
    if (!(cut.violation > min_violation)) return {};
    return cut;
  }

  const Relaxation& relaxation_;
  std::size_t rows_;
  std::vector<double> point_;
  std::size_t split_;  // column of the binary
  std::vector<Spot> spot_;
  linear::LinearProgram program_;
  int beta_ = -1;
  std::vector<int> alpha_;  // columns of the cut-generating program; -1: left out
  std::array<std::vector<std::array<int, 2>>, 2> multipliers_;  // side, row, {lower, upper}
};

}  // namespace

std::optional<DisjunctiveCut> deepest_cut(const Relaxation& relaxation, std::size_t rows,
                                          const std::vector<double>& point, std::size_t binary) {
  return CutProgram(relaxation, rows, point, binary).solve();
}

}  // namespace kusabi::zero_one
