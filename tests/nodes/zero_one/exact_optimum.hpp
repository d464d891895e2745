// Optimum of a small mixed zero-one program in rational arithmetic: all values of the binaries, and
// for each of them the simplex method with Bland's rule. For a few columns and rows only.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include <gmpxx.h>

#include "solvers/linear/linear_program.hpp"

namespace kusabi::tests {

/// Minimise c'x with Ax <= b and x >= 0, as a dictionary: each basic variable is a constant plus a
/// combination of the nonbasic ones.
class ExactSimplex {
 public:
  enum class Status { optimal, infeasible, unbounded };

  ExactSimplex(std::vector<std::vector<mpq_class>> a, std::vector<mpq_class> b,
               std::vector<mpq_class> c)
      : rows_(b.size()), columns_(c.size()), constant_(std::move(b)), costs_(std::move(c)) {
    for (auto& row : a) {
      for (auto& value : row) value = -value;
      entries_.push_back(std::move(row));
    }
    for (std::size_t j = 0; j < columns_; ++j) free_.push_back(j);
    for (std::size_t i = 0; i < rows_; ++i) basic_.push_back(columns_ + i);
  }

  Status solve() {
    if (!make_feasible()) return Status::infeasible;
    return minimise(costs_, value_) ? Status::optimal : Status::unbounded;
  }

  /// After `optimal`.
  [[nodiscard]] const mpq_class& value() const { return value_; }

 private:
  using Numbers = std::vector<mpq_class>;

  // Phase one: one more variable, added to all rows, is minimised.
  bool make_feasible() {
    std::size_t worst = rows_;
    for (std::size_t i = 0; i < rows_; ++i) {
      if (constant_[i] < 0 && (worst == rows_ || constant_[i] < constant_[worst])) worst = i;
    }
    if (worst == rows_) return true;
    const std::size_t extra = columns_ + rows_;
    Numbers extra_cost(free_.size(), 0);
    free_.push_back(extra);
    extra_cost.emplace_back(1);
    costs_.emplace_back(0);
    for (auto& row : entries_) row.emplace_back(1);
    mpq_class minimum = 0;
    costs_to_keep_ = &extra_cost;
    extra_value_ = &minimum;
    pivot(worst, free_.size() - 1, costs_, value_);
    minimise(extra_cost, minimum, &costs_);
    costs_to_keep_ = nullptr;
    if (minimum > 0) return false;
    for (std::size_t i = 0; i < rows_; ++i) {
      if (basic_[i] != extra) continue;
      // It is zero and can be replaced by any other.
      for (std::size_t j = 0; j < free_.size(); ++j) {
        if (entries_[i][j] == 0) continue;
        pivot(i, j, costs_, value_);
        break;
      }
    }
    for (std::size_t j = 0; j < free_.size(); ++j) {
      if (free_[j] != extra) continue;
      free_.erase(free_.begin() + static_cast<std::ptrdiff_t>(j));
      costs_.erase(costs_.begin() + static_cast<std::ptrdiff_t>(j));
      for (auto& row : entries_) row.erase(row.begin() + static_cast<std::ptrdiff_t>(j));
      return true;
    }
    // It is zero and basic in a row without other entries.
    for (std::size_t i = 0; i < rows_; ++i) {
      if (basic_[i] != extra) continue;
      basic_.erase(basic_.begin() + static_cast<std::ptrdiff_t>(i));
      constant_.erase(constant_.begin() + static_cast<std::ptrdiff_t>(i));
      entries_.erase(entries_.begin() + static_cast<std::ptrdiff_t>(i));
      --rows_;
      break;
    }
    return true;
  }

  // Bland's rule: the first improving column, the first limiting row. @return false if unbounded
  bool minimise(Numbers& costs, mpq_class& value, Numbers* other = nullptr) {
    for (;;) {
      std::size_t enters = free_.size();
      for (std::size_t j = 0; j < free_.size(); ++j) {
        if (costs[j] < 0 && (enters == free_.size() || free_[j] < free_[enters])) enters = j;
      }
      if (enters == free_.size()) return true;
      std::size_t leaves = rows_;
      mpq_class minimum;
      for (std::size_t i = 0; i < rows_; ++i) {
        if (entries_[i][enters] >= 0) continue;
        const mpq_class step = -constant_[i] / entries_[i][enters];
        if (leaves == rows_ || step < minimum || (step == minimum && basic_[i] < basic_[leaves])) {
          leaves = i;
          minimum = step;
        }
      }
      if (leaves == rows_) return false;
      if (other != nullptr) {
        pivot(leaves, enters, *other, value_);
      } else {
        pivot(leaves, enters, costs, value);
      }
    }
  }

  void pivot(std::size_t i, std::size_t j, Numbers& costs, mpq_class& value) {
    // x_i = constant + sum + a x_j, so x_j = (x_i - constant - sum) / a.
    const mpq_class inverse = 1 / entries_[i][j];
    auto row = entries_[i];
    mpq_class constant = -constant_[i] * inverse;
    for (auto& entry : row) entry = -entry * inverse;
    row[j] = inverse;
    const auto put_in = [&](Numbers& into, mpq_class& into_constant) {
      const mpq_class factor = into[j];
      if (factor == 0) return;
      into_constant += factor * constant;
      into[j] = 0;
      for (std::size_t k = 0; k < row.size(); ++k) into[k] += factor * row[k];
    };
    for (std::size_t k = 0; k < rows_; ++k) {
      if (k != i) put_in(entries_[k], constant_[k]);
    }
    put_in(costs, value);
    if (costs_to_keep_ != nullptr) put_in(*costs_to_keep_, *extra_value_);
    entries_[i] = std::move(row);
    constant_[i] = constant;
    std::swap(basic_[i], free_[j]);
  }

  std::size_t rows_;
  std::size_t columns_;
  Numbers constant_;
  Numbers costs_;
  std::vector<Numbers> entries_;
  std::vector<std::size_t> free_;
  std::vector<std::size_t> basic_;
  mpq_class value_ = 0;
  Numbers* costs_to_keep_ = nullptr;  // of phase one
  mpq_class* extra_value_ = nullptr;
};

struct ExactOptimum {
  std::optional<mpq_class> value;  ///< none: there is no point
  bool unbounded = false;
};

/// Of a linear program.
inline ExactOptimum exact_optimum(const linear::LinearProgram& program) {
  using Numbers = std::vector<mpq_class>;
  // x = start + sum of direction * x', x' >= 0
  struct Part {
    std::size_t column;
    int direction;
  };
  std::vector<Part> parts;
  Numbers start(program.columns.size());
  Numbers widths;  // of the parts; below zero: none
  for (std::size_t j = 0; j < program.columns.size(); ++j) {
    const auto& [cost, lower, upper, name] = program.columns[j];
    if (std::isfinite(lower)) {
      start[j] = lower;
      parts.push_back({j, 1});
      widths.emplace_back(std::isfinite(upper) ? mpq_class(upper) - mpq_class(lower)
                                               : mpq_class(-1));
    } else if (std::isfinite(upper)) {
      start[j] = upper;
      parts.push_back({j, -1});
      widths.emplace_back(-1);
    } else {
      parts.push_back({j, 1});
      parts.push_back({j, -1});
      widths.resize(parts.size(), -1);
    }
  }
  std::vector<Numbers> dense(program.rows.size(), Numbers(program.columns.size()));
  for (const auto& [row, column, value] : program.entries) {
    dense[static_cast<std::size_t>(row)][static_cast<std::size_t>(column)] = value;
  }
  std::vector<Numbers> a;
  Numbers b;
  const auto add = [&](const Numbers& row, int sign, const mpq_class& bound) {
    Numbers line(parts.size());
    mpq_class right = sign * bound;
    for (std::size_t j = 0; j < row.size(); ++j) right -= sign * row[j] * start[j];
    for (std::size_t k = 0; k < parts.size(); ++k) {
      line[k] = sign * parts[k].direction * row[parts[k].column];
    }
    a.push_back(std::move(line));
    b.push_back(std::move(right));
  };
  for (std::size_t i = 0; i < dense.size(); ++i) {
    const auto& [lower, upper, name] = program.rows[i];
    if (std::isfinite(upper)) add(dense[i], 1, upper);
    if (std::isfinite(lower)) add(dense[i], -1, lower);
  }
  for (std::size_t k = 0; k < parts.size(); ++k) {
    if (widths[k] < 0) continue;
    Numbers line(parts.size());
    line[k] = 1;
    a.push_back(std::move(line));
    b.push_back(widths[k]);
  }
  Numbers c(parts.size());
  mpq_class constant = program.constant;
  for (std::size_t j = 0; j < start.size(); ++j) constant += program.columns[j].cost * start[j];
  for (std::size_t k = 0; k < parts.size(); ++k) {
    c[k] = parts[k].direction * mpq_class(program.columns[parts[k].column].cost);
  }
  ExactSimplex simplex(std::move(a), std::move(b), std::move(c));
  switch (simplex.solve()) {
    case ExactSimplex::Status::optimal:
      return {simplex.value() + constant};
    case ExactSimplex::Status::unbounded:
      return {constant, true};
    case ExactSimplex::Status::infeasible:
      break;
  }
  return {};
}

/// Of a mixed program.
inline ExactOptimum exact_optimum(const linear::MixedProgram& mixed) {
  ExactOptimum best;
  for (std::uint64_t mask = 0; mask < (std::uint64_t{1} << mixed.binaries.size()); ++mask) {
    auto program = mixed.program;
    bool within = true;
    for (std::size_t k = 0; k < mixed.binaries.size(); ++k) {
      auto& column = program.columns[static_cast<std::size_t>(mixed.binaries[k])];
      const double value = ((mask >> k) & 1U) != 0 ? 1 : 0;
      within = within && column.lower <= value && value <= column.upper;
      column.lower = column.upper = value;
    }
    if (!within) continue;
    const auto found = exact_optimum(program);
    if (found.unbounded) return found;
    if (found.value && (!best.value || *found.value < *best.value)) best = found;
  }
  return best;
}

}  // namespace kusabi::tests
