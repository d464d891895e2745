// Linear programs for the bounds of a form.
#include "nodes/zero_one/bound_tightening.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <utility>

#include "solvers/linear/exact_simplex.hpp"
#include "solvers/linear/safe_bound.hpp"

namespace kusabi::zero_one {
namespace {

using linear::infinity;
using linear::LinearStatus;
using linear::LinearTerm;

// Gap between a bound and its proof in doubles, relative to its size (at least one), that is
// accepted.
constexpr double margin = 1e-6;

linear::LinearProgram with_objective_row(const linear::LinearProgram& given, double cutoff) {
  auto program = given;
  std::vector<LinearTerm> objective;
  for (std::size_t j = 0; j < program.columns.size(); ++j) {
    objective.push_back({static_cast<int>(j), program.columns[j].cost});
    program.columns[j].cost = 0;
  }
  program.constant = 0;
  const double maximum = linear::rounded::sum_up(cutoff, -given.constant);
  program.add_row({.upper = maximum}, objective);
  return program;
}

}  // namespace

BoundTightening::BoundTightening(const linear::LinearProgram& program, double cutoff,
                                 support::Stop stop)
    : program_(with_objective_row(program, cutoff)),
      simplex_(program_),
      implied_(implied_bounds(program_)),
      stop_(std::move(stop)) {}

void BoundTightening::set_column_bounds(int column, double lower, double upper) {
  auto& own = program_.columns.at(static_cast<std::size_t>(column));
  own.lower = lower;
  own.upper = upper;
  simplex_.set_column_bounds(column, lower, upper);
  implied_.lower[static_cast<std::size_t>(column)] = lower;
  implied_.upper[static_cast<std::size_t>(column)] = upper;
}

FormRange BoundTightening::range(std::span<const LinearTerm> form) {
  const auto below = end(form, 1);
  const auto above = end(form, -1);
  return {below.lower, above.upper, std::max(below.size, above.size)};
}

FormRange BoundTightening::upper_end(std::span<const LinearTerm> form) {
  return end(form, -1);
}

// The minimum of sign * form.
FormRange BoundTightening::end(std::span<const LinearTerm> form, double sign) {
  const auto set_costs = [&](double factor) {
    for (const auto& [column, value] : form) {
      if (column < 0 || column >= simplex_.columns()) {
        throw std::invalid_argument("bound tightening: no such column");
      }
      program_.columns[static_cast<std::size_t>(column)].cost = factor * value;
      simplex_.set_cost(column, factor * value);
    }
  };
  set_costs(sign);
  const linear::SolveLimits limits{.stop = stop_};
  auto status = simplex_.solve_primal(limits);
  if (status == LinearStatus::failed) status = simplex_.solve_robustly(limits);
  double minimum = -infinity;
  if (status == LinearStatus::optimal) {
    minimum = linear::safe_dual_bound(program_, simplex_.duals(), implied_.lower, implied_.upper);
    const double found = simplex_.objective();
    const double enough = found - margin * std::max(1.0, std::abs(found));
    if (!(minimum >= enough)) minimum = std::max(minimum, minimise_exactly());
  } else if (status == LinearStatus::infeasible) {
    minimum = minimise_exactly();
  }
  set_costs(0);
  const double size = largest_term(form);
  if (minimum == infinity) return {infinity, -infinity, size};
  return sign > 0 ? FormRange{minimum, infinity, size} : FormRange{-infinity, -minimum, size};
}

// Largest term at the point found; a column near zero counts as one, or as its bound if that is
// nearer.
double BoundTightening::largest_term(std::span<const LinearTerm> form) const {
  double largest = 0;
  for (const auto& [column, value] : form) {
    const auto j = static_cast<std::size_t>(column);
    const double farthest = std::max(std::abs(implied_.lower[j]), std::abs(implied_.upper[j]));
    const double at = std::max(std::abs(simplex_.value(column)), std::min(1.0, farthest));
    largest = std::max(largest, std::abs(value) * at);
  }
  return largest;
}

// The minimum of the form that is set as costs, in rational numbers; infinity: there is no relevant
// point.
double BoundTightening::minimise_exactly() {
  const auto found = linear::solve_exactly(program_, simplex_.basis(), stop_);
  return found.status == LinearStatus::infeasible ? infinity : found.bound;
}

}  // namespace kusabi::zero_one
