// Simplex method in doubles, then in rational numbers, with a check after each.
#include "solvers/linear/checked_simplex.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>

#include "solvers/linear/exact_simplex.hpp"

namespace kusabi::linear {
namespace {

/// Share of the largest entry of its row and of its column at which an entry is small: GLPK's scale
/// factors are geometric means, which such an entry distorts.
constexpr double small_entry = 1e-9;

bool has_small_entries(const LinearProgram& program) {
  std::vector<double> in_row(program.rows.size());
  std::vector<double> in_column(program.columns.size());
  for (const auto& [row, column, value] : program.entries) {
    double& of_row = in_row[static_cast<std::size_t>(row)];
    double& of_column = in_column[static_cast<std::size_t>(column)];
    of_row = std::max(of_row, std::abs(value));
    of_column = std::max(of_column, std::abs(value));
  }
  return std::ranges::any_of(program.entries, [&](const LinearEntry& entry) {
    const double largest = std::min(in_row[static_cast<std::size_t>(entry.row)],
                                    in_column[static_cast<std::size_t>(entry.column)]);
    return std::abs(entry.value) < small_entry * largest;
  });
}

}  // namespace

CheckedSimplex::CheckedSimplex(LinearProgram program)
    : program_(std::move(program)), simplex_(program_) {
  if (has_small_entries(program_)) simplex_.unscale();
}

void CheckedSimplex::set_column_bounds(int column, double lower, double upper) {
  simplex_.set_column_bounds(column, lower, upper);
  auto& changed = program_.columns[static_cast<std::size_t>(column)];
  changed.lower = lower;
  changed.upper = upper;
}

void CheckedSimplex::set_row_bounds(int row, double lower, double upper) {
  simplex_.set_row_bounds(row, lower, upper);
  auto& changed = program_.rows[static_cast<std::size_t>(row)];
  changed.lower = lower;
  changed.upper = upper;
}

void CheckedSimplex::set_cost(int column, double cost) {
  simplex_.set_cost(column, cost);
  program_.columns[static_cast<std::size_t>(column)].cost = cost;
}

int CheckedSimplex::add_row(double lower, double upper, std::span<const LinearTerm> terms) {
  program_.add_row({.lower = lower, .upper = upper}, terms);
  return simplex_.add_row(lower, upper, terms);
}

void CheckedSimplex::drop_rows_from(int first) {
  if (first >= rows()) return;
  simplex_.drop_rows_from(first);
  std::erase_if(program_.entries, [first](const LinearEntry& each) { return each.row >= first; });
  program_.rows.resize(static_cast<std::size_t>(first));
}

// Takes an answer of the simplex method in doubles. @return true if it is final
bool CheckedSimplex::take(LinearStatus status, const support::Stop& stop) {
  if (status == LinearStatus::optimal) {
    if (auto found = CheckedOptimum::of(program_, simplex_.values(), simplex_.duals())) {
      answer_ = *std::move(found);
      return true;
    }
  } else if (status == LinearStatus::infeasible) {
    if (auto found = CheckedInfeasibility::of(program_, simplex_.farkas())) {
      answer_ = *std::move(found);
      return true;
    }
  }
  const bool interrupted = status == LinearStatus::interrupted || support::is_requested(stop);
  answer_ = NotDetermined{interrupted};
  return interrupted;
}

void CheckedSimplex::solve_in_rational_numbers(const support::Stop& stop) {
  auto exact = solve_exactly(program_, simplex_.basis(), stop);
  if (exact.status == LinearStatus::optimal) {
    auto found = CheckedOptimum::of(program_, std::move(exact.values), std::move(exact.duals));
    if (!found) return;
    answer_ = *std::move(found);
    simplex_.set_basis(exact.basis);
  } else if (exact.status == LinearStatus::infeasible) {
    if (auto found = CheckedInfeasibility::of(program_, std::move(exact.duals)))
      answer_ = *std::move(found);
  } else {
    answer_ = NotDetermined{exact.status == LinearStatus::interrupted};
  }
}

const CheckedAnswer& CheckedSimplex::solve(const support::Stop& stop) {
  if (take(simplex_.solve_robustly({.stop = stop}), stop)) return answer_;
  simplex_.use_slack_basis();
  if (take(simplex_.solve_robustly({.stop = stop}), stop)) return answer_;
  solve_in_rational_numbers(stop);
  return answer_;
}

}  // namespace kusabi::linear
