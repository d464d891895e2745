// Iterative refinement of a linear program: a basis solved in 104 bits, and rounds that scale up
// the residuals.
#include "solvers/linear/precise_simplex.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <optional>
#include <tuple>
#include <utility>

#include <Eigen/LU>

#include "solvers/linear/precise_bound.hpp"

namespace kusabi::linear {
namespace {

using numbers::Precise;
using Vector = std::vector<Precise>;

// Relative residual at which a basis is solved.
constexpr double solved = 0x1p-90;
constexpr int max_corrections = 24;
// Tolerance of basic values and reduced costs, relative to the magnitudes around them: the error
// implied by the residual above for a basis that is not too ill-conditioned.
constexpr double on_it = 1e-21;
constexpr int max_rounds = 24;
// Largest increase of the scale factor per round; the remainder is 1e-9 in the scaled program.
constexpr double scale_per_round = 0x1p40;
// The largest violation is scaled to one; bounds beyond this are then omitted.
constexpr double far = 1e15;
// Limit of scaled costs; larger ones are certainly positive. GLPK divides all costs by the largest,
// so that smaller ones would vanish in its tolerance.
constexpr double dear = 1e5;

double size(const Precise& number) {
  return std::abs(number.x[0]);
}

// The program with a column for each row's activity s, so that it can have a cost: Ax - s = 0.
LinearProgram with_activities(const LinearProgram& given) {
  LinearProgram program;
  program.columns.reserve(given.columns.size() + given.rows.size());
  for (const auto& column : given.columns) {
    program.add_column({.cost = column.cost, .lower = column.lower, .upper = column.upper});
  }
  program.entries = given.entries;
  for (const auto& row : given.rows) {
    const int column = program.add_column({.cost = 0, .lower = row.lower, .upper = row.upper});
    program.entries.push_back({static_cast<int>(program.rows.size()), column, -1});
    program.rows.push_back({.lower = 0, .upper = 0});
  }
  return program;
}

class Refinement {
 public:
  Refinement(const LinearProgram& given, const support::Stop& stop)
      : given_(given),
        extended_(with_activities(given)),
        rows_(given.rows.size()),
        columns_(given.columns.size()),
        simplex_(extended_),
        stop_(stop),
        column_entries_(extended_.columns.size()) {
    for (const auto& entry : extended_.entries) {
      column_entries_[static_cast<std::size_t>(entry.column)].push_back(entry);
    }
  }

  PreciseSolution solve(const Basis& start) {
    if (!start.empty()) simplex_.set_basis(extended(start));
    PreciseSolution result;
    values_.assign(extended_.columns.size(), 0.0);
    reduced_.clear();
    for (const auto& column : extended_.columns) reduced_.emplace_back(column.cost);
    for (int round = 0; round < max_rounds; ++round) {
      load(round == 0);
      result.status = simplex_.solve_robustly({.stop = stop_});
      const bool stays = round > 1 && result.basis == given_basis();
      result.basis = given_basis();
      if (result.status == LinearStatus::infeasible) {
        if (auto reason = contradiction()) result.duals = *std::move(reason);
        if (contradicts(result.duals)) return result;
        // Infeasible by less than GLPK's tolerance, if at all: the next round magnifies it.
      } else {
        if (result.status != LinearStatus::optimal) return result;
        result.status = LinearStatus::failed;
      }
      if (!take_basis()) return result;
      if (fits()) {
        result.status = LinearStatus::optimal;
        conclude(result);
        return result;
      }
      if (stays) return result;
      scale_up();
    }
    return result;
  }

 private:
  // ---- bases -----------------------------------------------------------------------------------

  [[nodiscard]] Basis extended(const Basis& given) const {
    Basis basis(rows_, columns_ + rows_);
    for (std::size_t j = 0; j < columns_; ++j) basis.set_column(j, given.column(j));
    for (std::size_t i = 0; i < rows_; ++i) {
      // Rows added after the basis was made are basic.
      basis.set_column(columns_ + i, i < given.rows() ? given.row(i) : BasisStatus::basic);
      basis.set_row(i, BasisStatus::lower);
    }
    return basis;
  }

  // A basic row is represented by its activity: they are the same column of the basis.
  [[nodiscard]] Basis given_basis() const {
    const auto now = simplex_.basis();
    Basis basis(rows_, columns_);
    for (std::size_t j = 0; j < columns_; ++j) basis.set_column(j, now.column(j));
    for (std::size_t i = 0; i < rows_; ++i) {
      const bool basic = now.row(i) == BasisStatus::basic;
      basis.set_row(i, basic ? BasisStatus::basic : now.column(columns_ + i));
    }
    return basis;
  }

  // ---- the system of a basis -------------------------------------------------------------------

  // Entries of column k of (I | -A), rows first.
  template <class Each>
  void each_entry(int k, const Each& each) const {
    const auto at = static_cast<std::size_t>(k);
    if (at < rows_) {
      each(at, 1.0);
      return;
    }
    for (const auto& entry : column_entries_[at - rows_]) {
      each(static_cast<std::size_t>(entry.row), -entry.value);
    }
  }

  using Apply = std::function<void(const Vector&, Vector&, std::vector<double>&)>;

  // Solves a system by iterative refinement. `apply` multiplies, and adds up the magnitudes of the
  // terms; `approximate` replaces the right-hand side by an approximate solution.
  static std::optional<Vector> corrected(const Vector& right, const Apply& apply,
                                         const std::function<bool(Vector&)>& approximate) {
    Vector x(right.size(), 0.0);
    double worst_before = infinity;
    for (int time = 0; time < max_corrections; ++time) {
      Vector product(right.size(), 0.0);
      std::vector<double> terms(right.size());
      apply(x, product, terms);
      double worst = 0;
      Vector residual(right.size());
      for (std::size_t i = 0; i < right.size(); ++i) {
        residual[i] = right[i] - product[i];
        const double missing = size(residual[i]);
        if (!std::isfinite(missing)) return {};
        const double weight = size(right[i]) + terms[i];
        if (weight > 0) worst = std::max(worst, missing / weight);
      }
      if (worst <= solved) return x;
      // The first correction reduces the residual except where the solution was zero.
      if (time > 2 && worst > 0.5 * worst_before) return {};
      worst_before = worst;
      if (!approximate(residual)) return {};
      for (std::size_t i = 0; i < x.size(); ++i) x[i] += residual[i];
    }
    return {};
  }

  // Approximate solution by GLPK's factorisation.
  static bool approximate_in_doubles(Vector& right,
                                     const std::function<bool(std::vector<double>&)>& solve) {
    double largest = 0;
    for (const auto& number : right) largest = std::max(largest, size(number));
    const double scale = std::exp2(std::ilogb(largest));
    std::vector<double> step(right.size());
    for (std::size_t i = 0; i < step.size(); ++i) step[i] = right[i].x[0] / scale;
    if (!solve(step)) return false;
    for (std::size_t i = 0; i < step.size(); ++i) right[i] = Precise(step[i]) * Precise(scale);
    return true;
  }

  // Approximate solution by a factorisation in 104 bits, for a basis too ill-conditioned for
  // doubles.
  bool approximate_in_all_bits(Vector& right, bool transposed) const {
    constexpr std::size_t max_rows = 200;
    if (rows_ == 0 || rows_ > max_rows) return false;
    const auto count = static_cast<Eigen::Index>(rows_);
    numbers::PreciseMatrix matrix = numbers::PreciseMatrix::Zero(count, count);
    for (std::size_t p = 0; p < rows_; ++p) {
      each_entry(head_[p], [&](std::size_t row, double value) {
        const auto i = static_cast<Eigen::Index>(row);
        const auto j = static_cast<Eigen::Index>(p);
        (transposed ? matrix(j, i) : matrix(i, j)) = value;
      });
    }
    numbers::PreciseVector b(count);
    for (Eigen::Index i = 0; i < count; ++i) b(i) = right[static_cast<std::size_t>(i)];
    const numbers::PreciseVector x = Eigen::PartialPivLU<numbers::PreciseMatrix>(matrix).solve(b);
    for (Eigen::Index i = 0; i < count; ++i) right[static_cast<std::size_t>(i)] = x(i);
    return true;
  }

  // basis: x with B x = right, in the order of head_. transposed: pi with B'pi = right.
  enum class System { basis, transposed };

  std::optional<Vector> solve(const Vector& right, System system) {
    const bool transposed = system == System::transposed;
    const Apply apply = [&](const Vector& x, Vector& product, std::vector<double>& terms) {
      for (std::size_t p = 0; p < head_.size(); ++p) {
        each_entry(head_[p], [&](std::size_t row, double value) {
          const auto [from, to] = transposed ? std::pair(row, p) : std::pair(p, row);
          const Precise term = x[from] * Precise(value);
          product[to] += term;
          terms[to] += size(term);
        });
      }
    };
    const auto in_doubles = [&](std::vector<double>& b) {
      return transposed ? simplex_.solve_with_transposed_basis(b) : simplex_.solve_with_basis(b);
    };
    if (auto x = corrected(right, apply,
                           [&](Vector& b) { return approximate_in_doubles(b, in_doubles); })) {
      return x;
    }
    return corrected(right, apply,
                     [&](Vector& b) { return approximate_in_all_bits(b, transposed); });
  }

  // ---- a round ---------------------------------------------------------------------------------

  // Loads the scaled residuals of bounds and costs; initially the whole program.
  void load(bool all) {
    if (all) return;  // unchanged since construction
    for (std::size_t k = 0; k < values_.size(); ++k) {
      const auto& column = extended_.columns[k];
      const int at = static_cast<int>(k);
      double lower = (Precise(column.lower) - values_[k]).x[0] * value_scale_;
      double upper = (Precise(column.upper) - values_[k]).x[0] * value_scale_;
      if (!std::isfinite(column.lower) || lower <= -far) lower = -infinity;
      if (!std::isfinite(column.upper) || upper >= far) upper = infinity;
      simplex_.set_column_bounds(at, std::min(lower, far), std::max(upper, -far));
      simplex_.set_cost(at, std::clamp(reduced_[k].x[0] * cost_scale_, -dear, dear));
    }
    for (std::size_t i = 0; i < rows_; ++i) {
      const double missing = std::clamp(-missed_[i].x[0] * value_scale_, -far, far);
      simplex_.set_row_bounds(static_cast<int>(i), missing, missing);
    }
  }

  [[nodiscard]] Precise resting(std::size_t k, BasisStatus place) const {
    const auto& column = extended_.columns[k];
    const double first = place == BasisStatus::lower ? column.lower : column.upper;
    const double second = place == BasisStatus::lower ? column.upper : column.lower;
    if (std::isfinite(first)) return first;
    return std::isfinite(second) ? second : 0.0;
  }

  // Values, multipliers and reduced costs of the current basis; false if the refinement does not
  // converge.
  bool take_basis() {
    head_ = simplex_.basis_head();
    if (head_.size() != rows_) return false;
    place_.assign(values_.size(), BasisStatus::basic);
    const auto basis = simplex_.basis();
    Vector right(rows_, 0.0);
    for (std::size_t k = 0; k < values_.size(); ++k) {
      place_[k] = basis.column(k);
      if (place_[k] == BasisStatus::basic) continue;
      values_[k] = resting(k, place_[k]);
      if (values_[k].x[0] == 0) continue;
      for (const auto& entry : column_entries_[k]) {
        right[static_cast<std::size_t>(entry.row)] += values_[k] * Precise(entry.value);
      }
    }
    const auto basic = solve(right, System::basis);
    if (!basic) return false;
    Vector costs(rows_, 0.0);
    missed_.assign(rows_, 0.0);
    for (std::size_t p = 0; p < rows_; ++p) {
      const auto k = static_cast<std::size_t>(head_[p]);
      if (k < rows_) {
        missed_[k] = (*basic)[p];
        continue;
      }
      values_[k - rows_] = (*basic)[p];
      costs[p] = extended_.columns[k - rows_].cost;
    }
    const auto pi = solve(costs, System::transposed);
    if (!pi) return false;
    duals_.assign(rows_, 0.0);
    for (std::size_t i = 0; i < rows_; ++i) duals_[i] = -(*pi)[i];
    double largest = 0;
    for (const auto& dual : duals_) largest = std::max(largest, size(dual));
    reduced_size_.assign(values_.size(), 0);
    for (std::size_t k = 0; k < values_.size(); ++k) {
      reduced_[k] = extended_.columns[k].cost;
      reduced_size_[k] = size(reduced_[k]);
      if (place_[k] == BasisStatus::basic) {
        reduced_[k] = 0.0;
        continue;
      }
      for (const auto& entry : column_entries_[k]) {
        reduced_[k] -= duals_[static_cast<std::size_t>(entry.row)] * Precise(entry.value);
        reduced_size_[k] += std::abs(entry.value) * largest;
      }
    }
    return true;
  }

  // Violations of bounds by basic values, and of signs by reduced costs; values within the
  // tolerance are set to the bound.
  bool fits() {
    double value_size = 0;
    for (const auto& value : values_) value_size = std::max(value_size, size(value));
    worst_value_ = worst_cost_ = 0;
    for (auto& missing : missed_) {
      if (size(missing) <= on_it * value_size) {
        missing = 0.0;
      } else {
        worst_value_ = std::max(worst_value_, size(missing));
      }
    }
    for (std::size_t k = 0; k < values_.size(); ++k) {
      const auto& [cost, lower, upper, name] = extended_.columns[k];
      if (place_[k] == BasisStatus::basic) {
        const double at = values_[k] < Precise(lower)   ? lower
                          : values_[k] > Precise(upper) ? upper
                                                        : infinity;
        if (!std::isfinite(at)) continue;
        const double beyond = size(values_[k] - Precise(at));
        if (beyond <= on_it * value_size) {
          values_[k] = at;
        } else {
          worst_value_ = std::max(worst_value_, beyond);
        }
        continue;
      }
      if (lower == upper) continue;
      const double minimum = on_it * reduced_size_[k];
      const double at = reduced_[k].x[0];
      const bool at_lower = values_[k] == Precise(lower);
      const bool at_upper = values_[k] == Precise(upper);
      const bool wrong = (at < -minimum && !at_upper) || (at > minimum && !at_lower);
      if (wrong) worst_cost_ = std::max(worst_cost_, std::abs(at));
    }
    return worst_value_ == 0 && worst_cost_ == 0;
  }

  void scale_up() {
    const auto scale = [](double worst, double before) {
      if (worst == 0) return before;
      return std::min(std::exp2(-std::ilogb(worst)), before * scale_per_round);
    };
    value_scale_ = scale(worst_value_, value_scale_);
    cost_scale_ = scale(worst_cost_, cost_scale_);
  }

  // ---- the answers -----------------------------------------------------------------------------

  // Multipliers of the rows that prove infeasibility.
  std::optional<Vector> contradiction() {
    auto [place, sign] = simplex_.contradicting();
    if (place < 0) {
      // Without costs any basis is dual feasible, and the dual method ends with a proof; the primal
      // method does not.
      for (std::size_t k = 0; k < values_.size(); ++k) simplex_.set_cost(static_cast<int>(k), 0);
      simplex_.solve_dual({.stop = stop_});
      std::tie(place, sign) = simplex_.contradicting();
    }
    head_ = simplex_.basis_head();
    if (place < 0 || head_.size() != rows_) return {};
    Vector unit(rows_, 0.0);
    unit[static_cast<std::size_t>(place)] = sign;
    return solve(unit, System::transposed);
  }

  // True if these multipliers prove that no point satisfies all rows and bounds.
  [[nodiscard]] bool contradicts(const Vector& duals) const {
    if (duals.empty()) return false;
    std::vector<double> lower;
    std::vector<double> upper;
    for (std::size_t j = 0; j < columns_; ++j) {
      lower.push_back(given_.columns[j].lower);
      upper.push_back(given_.columns[j].upper);
    }
    return safe_infeasibility(given_, duals, lower, upper, Residuals::forgiven) > 0;
  }

  void conclude(PreciseSolution& result) const {
    result.values.assign(values_.begin(), values_.begin() + static_cast<std::ptrdiff_t>(columns_));
    result.duals = duals_;
    result.objective = given_.constant;
    for (std::size_t j = 0; j < columns_; ++j) {
      const double cost = given_.columns[j].cost;
      if (cost != 0) result.objective += Precise(cost) * values_[j];
    }
  }

  const LinearProgram& given_;
  LinearProgram extended_;
  std::size_t rows_;
  std::size_t columns_;
  Simplex simplex_;
  const support::Stop& stop_;
  std::vector<std::vector<LinearEntry>> column_entries_;
  std::vector<int> head_;
  std::vector<BasisStatus> place_;
  Vector values_;  // of the columns, then of the activities
  Vector missed_;  // Ax - s, which is to be zero: rows that are basic themselves may miss it
  Vector duals_;
  Vector reduced_;  // reduced costs
  std::vector<double> reduced_size_;
  double value_scale_ = 1;
  double cost_scale_ = 1;
  double worst_value_ = 0;
  double worst_cost_ = 0;
};

}  // namespace

PreciseSolution solve_precisely(const LinearProgram& program, const Basis& start,
                                const support::Stop& stop) {
  return Refinement(program, stop).solve(start);
}

}  // namespace kusabi::linear
