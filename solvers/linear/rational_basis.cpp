// Values, multipliers and edges of a basis, by one sparse factor.
#include "solvers/linear/rational_basis.hpp"

#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

#include <gmpxx.h>

#include "solvers/linear/rational_factor.hpp"

namespace kusabi::linear {
namespace {

// A row's activity or a column: a variable of Ax - s = 0, the rows first.
struct Variable {
  double cost = 0;
  double lower = -infinity;
  double upper = infinity;
  BasisStatus place = BasisStatus::basic;

  [[nodiscard]] mpq_class resting() const {
    const double first = place == BasisStatus::lower ? lower : upper;
    const double second = place == BasisStatus::lower ? upper : lower;
    return std::isfinite(first) ? first : std::isfinite(second) ? second : 0.0;
  }
  [[nodiscard]] bool is_below(const mpq_class& value) const {
    return std::isfinite(lower) && value < lower;
  }
  [[nodiscard]] bool is_above(const mpq_class& value) const {
    return std::isfinite(upper) && value > upper;
  }
};

// The product of a coefficient with a bound that it presses on; nothing if there is none.
std::optional<mpq_class> pressed(const mpq_class& coefficient, double lower, double upper) {
  if (sgn(coefficient) == 0) return mpq_class(0);
  const double bound = sgn(coefficient) > 0 ? lower : upper;
  if (!std::isfinite(bound)) return {};
  return mpq_class(coefficient * bound);
}

double rounded_down(const mpq_class& value) {
  const double near = value.get_d();  // towards zero
  if (!std::isfinite(near)) {
    return near > 0 ? std::numeric_limits<double>::max() : -infinity;
  }
  return near > value ? std::nextafter(near, -infinity) : near;
}

double nearest(const mpq_class& value) {
  const double near = value.get_d();  // towards zero
  if (near == 0 || !std::isfinite(near)) return near;
  return near + mpq_class(value - near).get_d();
}

Interval enclosed(const mpq_class& value) {
  if (sgn(value) == 0) return {};
  const double near = value.get_d();
  return {rounded::before(near), -rounded::before(-near)};
}

template <class Numbers>
std::vector<double> in_doubles(const Numbers& numbers) {
  std::vector<double> result;
  result.reserve(numbers.size());
  for (const auto& number : numbers) result.push_back(nearest(number));
  return result;
}

// A basis in rational numbers. Basic activities need no equation of their own, so that the system is
// that of the other rows and of the basic columns.
class RationalBasis {
 public:
  RationalBasis(const LinearProgram& program, const Basis& basis) : program_(program) {
    rows_ = program.rows.size();
    for (std::size_t i = 0; i < rows_; ++i) {
      const auto& [lower, upper, name] = program.rows[i];
      const auto place = i < basis.rows() ? basis.row(i) : BasisStatus::basic;
      variables_.push_back({.lower = lower, .upper = upper, .place = place});
    }
    for (std::size_t j = 0; j < program.columns.size(); ++j) {
      const auto& [cost, lower, upper, name] = program.columns[j];
      const auto place = basis.empty() ? BasisStatus::lower : basis.column(j);
      variables_.push_back({cost, lower, upper, place});
    }
  }

  // False if the basis is none, or too much work.
  bool solve(const support::Stop& stop, bool& too_much) {
    for (std::size_t k = 0; k < variables_.size(); ++k) {
      const bool basic = variables_[k].place == BasisStatus::basic;
      if (k < rows_ ? basic : !basic) continue;
      (k < rows_ ? kernel_rows_ : kernel_columns_).push_back(k);
    }
    if (kernel_rows_.size() != kernel_columns_.size()) return false;
    constexpr auto none = std::numeric_limits<std::size_t>::max();
    place_of_row_.assign(rows_, none);
    place_of_column_.assign(program_.columns.size(), none);
    for (std::size_t p = 0; p < kernel_rows_.size(); ++p) {
      place_of_row_[kernel_rows_[p]] = p;
      place_of_column_[kernel_columns_[p] - rows_] = p;
    }
    std::vector<RationalFactor::Row> matrix(kernel_rows_.size());
    Rationals right(kernel_rows_.size());
    values_.assign(variables_.size(), 0);
    for (std::size_t k = 0; k < variables_.size(); ++k) {
      if (variables_[k].place != BasisStatus::basic) values_[k] = variables_[k].resting();
    }
    for (std::size_t p = 0; p < kernel_rows_.size(); ++p) right[p] = values_[kernel_rows_[p]];
    for (const auto& [row, column, value] : program_.entries) {
      const std::size_t p = place_of_row_[static_cast<std::size_t>(row)];
      if (p == none || value == 0) continue;
      const auto j = static_cast<std::size_t>(column);
      if (place_of_column_[j] != none) {
        matrix[p][place_of_column_[j]] = value;
      } else {
        right[p] -= value * values_[rows_ + j];
      }
    }
    factor_ = RationalFactor::of(std::move(matrix), stop, too_much);
    if (!factor_) return false;
    const auto basic = factor_->solve(std::move(right));
    for (std::size_t p = 0; p < basic.size(); ++p) values_[kernel_columns_[p]] = basic[p];
    add_activities(values_);
    return true;
  }

  [[nodiscard]] bool is_feasible() const {
    for (std::size_t k = 0; k < variables_.size(); ++k) {
      if (variables_[k].is_below(values_[k]) || variables_[k].is_above(values_[k])) return false;
    }
    return true;
  }

  /// The optimum, if the basis is one.
  [[nodiscard]] std::optional<ExactSolution> optimum() const {
    if (!is_feasible()) return {};
    Rationals costs(kernel_columns_.size());
    for (std::size_t p = 0; p < costs.size(); ++p) costs[p] = variables_[kernel_columns_[p]].cost;
    const auto duals = multipliers(costs);
    const auto reduced = reduced_costs(duals, true);
    for (std::size_t k = 0; k < variables_.size(); ++k) {
      const auto& cost = k < rows_ ? duals[k] : reduced[k - rows_];
      const double bound = sgn(cost) > 0 ? variables_[k].lower : variables_[k].upper;
      if (sgn(cost) != 0 && !(std::isfinite(bound) && values_[k] == bound)) return {};
    }
    ExactSolution found{.status = LinearStatus::optimal};
    mpq_class objective = program_.constant;
    for (std::size_t j = 0; j < program_.columns.size(); ++j) {
      objective += program_.columns[j].cost * values_[rows_ + j];
      found.values.push_back(nearest(values_[rows_ + j]));
      found.reduced.push_back(enclosed(reduced[j]));
    }
    found.duals = in_doubles(duals);
    found.objective = nearest(objective);
    found.bound = rounded_down(objective);
    return found;
  }

  /// The proof that there is no point, if the gradient of all violations of this basis is one.
  [[nodiscard]] std::optional<ExactSolution> infeasibility() const {
    // A violated basic activity has the multiplier of its violation, and the others follow.
    Rationals duals(rows_);
    Rationals costs(kernel_columns_.size());
    const auto slope = [&](std::size_t k) {
      return variables_[k].is_below(values_[k]) ? -1 : variables_[k].is_above(values_[k]) ? 1 : 0;
    };
    for (std::size_t i = 0; i < rows_; ++i) {
      if (variables_[i].place == BasisStatus::basic) duals[i] = -slope(i);
    }
    for (std::size_t p = 0; p < costs.size(); ++p) costs[p] = slope(kernel_columns_[p]);
    for (const auto& [row, column, value] : program_.entries) {
      const std::size_t p = place_of_column_[static_cast<std::size_t>(column)];
      if (p < costs.size()) costs[p] -= value * duals[static_cast<std::size_t>(row)];
    }
    const auto rest = factor_->solve_transposed(std::move(costs));
    for (std::size_t p = 0; p < rest.size(); ++p) duals[kernel_rows_[p]] = rest[p];
    mpq_class excess = 0;
    const auto reduced = reduced_costs(duals, false);
    for (std::size_t k = 0; k < variables_.size(); ++k) {
      const auto least = pressed(k < rows_ ? duals[k] : reduced[k - rows_], variables_[k].lower,
                                 variables_[k].upper);
      if (!least) return {};
      excess += *least;
    }
    if (sgn(excess) <= 0) return {};
    return ExactSolution{.status = LinearStatus::infeasible, .duals = in_doubles(duals)};
  }

  /// The proof that the objective decreases without end from a point, along the edge of a nonbasic
  /// variable, if it does.
  [[nodiscard]] std::optional<ExactSolution> edge_without_end(std::size_t entering) const {
    if (!is_feasible() || variables_[entering].place == BasisStatus::basic) return {};
    for (const int sign : {1, -1}) {
      Rationals edge(variables_.size());
      edge[entering] = sign;
      Rationals right(kernel_rows_.size());
      for (std::size_t p = 0; p < right.size(); ++p) right[p] = edge[kernel_rows_[p]];
      if (entering >= rows_) {
        for (const auto& [row, column, value] : program_.entries) {
          const std::size_t p = place_of_row_[static_cast<std::size_t>(row)];
          if (static_cast<std::size_t>(column) == entering - rows_ && p < right.size())
            right[p] -= sign * value;
        }
      }
      const auto basic = factor_->solve(std::move(right));
      for (std::size_t p = 0; p < basic.size(); ++p) edge[kernel_columns_[p]] = basic[p];
      add_activities(edge);
      mpq_class slope = 0;
      bool ends = false;
      for (std::size_t k = 0; k < variables_.size(); ++k) {
        slope += variables_[k].cost * edge[k];
        ends = ends || (sgn(edge[k]) < 0 && std::isfinite(variables_[k].lower)) ||
               (sgn(edge[k]) > 0 && std::isfinite(variables_[k].upper));
      }
      if (!ends && sgn(slope) < 0) return ExactSolution{.status = LinearStatus::unbounded};
    }
    return {};
  }

 private:
  void add_activities(Rationals& values) const {
    for (std::size_t i = 0; i < rows_; ++i) values[i] = 0;
    for (const auto& [row, column, value] : program_.entries) {
      const auto& at = values[rows_ + static_cast<std::size_t>(column)];
      if (sgn(at) != 0) values[static_cast<std::size_t>(row)] += value * at;
    }
  }

  [[nodiscard]] Rationals multipliers(Rationals costs) const {
    const auto solved = factor_->solve_transposed(std::move(costs));
    Rationals duals(rows_);
    for (std::size_t p = 0; p < solved.size(); ++p) duals[kernel_rows_[p]] = solved[p];
    return duals;
  }

  // c - A'dual, or -A'dual.
  [[nodiscard]] Rationals reduced_costs(const Rationals& duals, bool with_costs) const {
    Rationals reduced(program_.columns.size());
    for (std::size_t j = 0; with_costs && j < reduced.size(); ++j)
      reduced[j] = program_.columns[j].cost;
    for (const auto& [row, column, value] : program_.entries) {
      const auto& dual = duals[static_cast<std::size_t>(row)];
      if (sgn(dual) != 0) reduced[static_cast<std::size_t>(column)] -= value * dual;
    }
    return reduced;
  }

  const LinearProgram& program_;
  std::size_t rows_ = 0;
  std::vector<Variable> variables_;
  std::vector<std::size_t> kernel_rows_;     // those of nonbasic activities
  std::vector<std::size_t> kernel_columns_;  // basic, as indices of variables
  std::vector<std::size_t> place_of_row_;
  std::vector<std::size_t> place_of_column_;
  std::optional<RationalFactor> factor_;
  Rationals values_;
};

}  // namespace

std::optional<ExactSolution> proof_by_basis(const LinearProgram& program, const Basis& basis,
                                            int entering, const support::Stop& stop,
                                            bool& too_much) {
  RationalBasis rational(program, basis);
  if (!rational.solve(stop, too_much)) return {};
  auto found = rational.optimum();
  if (!found) found = rational.infeasibility();
  if (!found && entering >= 0)
    found = rational.edge_without_end(static_cast<std::size_t>(entering));
  if (found) found->basis = basis;
  return found;
}

}  // namespace kusabi::linear
