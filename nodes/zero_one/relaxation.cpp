// Fixings as bounds of columns; bounds of the objective from multipliers.
#include "nodes/zero_one/relaxation.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "nodes/zero_one/objective_steps.hpp"

namespace kusabi::zero_one {
namespace {

using linear::LinearStatus;

const linear::LinearProgram& checked(const linear::MixedProgram& mixed) {
  std::vector<bool> seen(mixed.program.columns.size());
  for (const int column : mixed.binaries) {
    const auto at = static_cast<std::size_t>(column);
    if (column < 0 || at >= seen.size() || seen[at]) {
      throw std::invalid_argument("mixed program: a binary is not a column, or is listed twice");
    }
    seen[at] = true;
    const auto& [cost, lower, upper, name] = mixed.program.columns[at];
    if (!(lower >= 0 && upper <= 1)) {
      throw std::invalid_argument("mixed program: a binary has bounds outside of [0, 1]");
    }
  }
  return mixed.program;
}

// A bound whose distance from the optimum is below this share of a step is tight.
constexpr double tight_share = 0.25;

}  // namespace

Relaxation::Relaxation(linear::MixedProgram mixed)
    : mixed_(std::move(mixed)),
      given_rows_(mixed_.program.rows.size()),
      simplex_(checked(mixed_)),
      implied_(implied_bounds(mixed_.program)),
      node_(implied_) {
  // A binary with bounds like [0, 0.5] is 0.
  for (const int column : mixed_.binaries) {
    auto& [cost, lower, upper, name] = mixed_.program.columns[static_cast<std::size_t>(column)];
    lower = std::ceil(lower);
    upper = std::floor(upper);
    simplex_.set_column_bounds(column, lower, upper);
    fixed_.lower.push_back(lower);
    fixed_.upper.push_back(upper);
  }
}

bool Relaxation::all_bounded() const {
  const auto finite = [](double bound) { return std::isfinite(bound); };
  return std::all_of(implied_.lower.begin(), implied_.lower.end(), finite) &&
         std::all_of(implied_.upper.begin(), implied_.upper.end(), finite);
}

void Relaxation::add_row(const linear::LinearRow& row,
                         const std::vector<linear::LinearTerm>& terms) {
  last_exact_.reset();
  mixed_.program.add_row(row, terms);
  simplex_.add_row(row.lower, row.upper, terms);
}

void Relaxation::drop_last_row() {
  auto& [name, constant, columns, rows, entries] = mixed_.program;
  const int last = static_cast<int>(rows.size()) - 1;
  while (!entries.empty() && entries.back().row == last) entries.pop_back();
  rows.pop_back();
  simplex_.drop_rows_from(last);
}

void Relaxation::limit_objective(double cutoff) {
  implied_ = implied_bounds(mixed_.program, cutoff);
}

void Relaxation::fix(const Fixings& fixings) {
  node_ = implied_;
  for (std::size_t k = 0; k < binaries(); ++k) {
    const auto j = static_cast<std::size_t>(column(k));
    const auto& own = mixed_.program.columns[j];
    const double lower = fixings.at_one(k) ? 1 : own.lower;
    const double upper = fixings.at_zero(k) ? 0 : own.upper;
    if (lower != fixed_.lower[k] || upper != fixed_.upper[k]) {
      simplex_.set_column_bounds(column(k), lower, upper);
      fixed_.lower[k] = lower;
      fixed_.upper[k] = upper;
    }
    node_.lower[j] = lower;
    node_.upper[j] = upper;
  }
}

LinearStatus Relaxation::solve(const Fixings& fixings, const linear::Basis& basis,
                               const linear::SolveLimits& limits) {
  fix(fixings);
  if (basis.empty()) {
    simplex_.use_slack_basis();
  } else {
    simplex_.set_basis(basis);
  }
  auto all_limits = limits;
  if (stop_) all_limits.stop = stop_;
  status_ = simplex_.solve_robustly(all_limits);
  conclude();
  return status_;
}

void Relaxation::conclude() {
  bound_ = -linear::infinity;
  contradiction_ = false;
  exact_.reset();
  basis_ = simplex_.basis();
  values_ = simplex_.values();
  switch (status_) {
    case LinearStatus::optimal:
      conclude_in_doubles();
      if (proves_ && !is_tight(simplex_.objective())) conclude_exactly();
      return;
    case LinearStatus::cut_off:
    case LinearStatus::stopped:
    case LinearStatus::interrupted:
      conclude_in_doubles();
      return;
    case LinearStatus::infeasible: {
      for (std::size_t j = 0; j < node_.lower.size(); ++j) {
        if (node_.lower[j] > node_.upper[j]) {
          contradiction_ = true;
          return;
        }
      }
      const auto reason = simplex_.farkas();
      contradiction_ = !reason.empty() && linear::safe_infeasibility(mixed_.program, reason,
                                                                     node_.lower, node_.upper) > 0;
      if (!contradiction_) conclude_exactly();
      return;
    }
    case LinearStatus::failed:
    case LinearStatus::unbounded:
      conclude_exactly();
      return;
  }
}

// The bound of the present multipliers. If it need not be proved, columns without bounds are left
// out if their part is negligible.
void Relaxation::conclude_in_doubles() {
  safe_ = linear::safe_bound(mixed_.program, simplex_.duals(), node_.lower, node_.upper);
  bound_ = safe_.value;
  if (!proves_ && std::isfinite(safe_.finite_part) &&
      left_out() <= tight_share * step_width(safe_.finite_part)) {
    bound_ = safe_.finite_part;
  }
}

// Estimate of the part of columns without bounds.
double Relaxation::left_out() const {
  double sum = 0;
  for (std::size_t j = 0; j < values_.size(); ++j) {
    const auto& residual = safe_.residuals[j];
    if (std::isfinite(linear::min_product(residual, node_.lower[j], node_.upper[j]))) continue;
    sum += std::max(std::abs(residual.lower), std::abs(residual.upper)) *
           std::max(1.0, std::abs(values_[j]));
  }
  return sum;
}

// True if the bound agrees with the simplex method's optimum.
bool Relaxation::is_tight(double objective) const {
  return std::isfinite(bound_) && std::abs(objective - bound_) <= tight_share * step_width(bound_);
}

// Solves the simplex method's program in rational numbers. An optimal program may turn out
// infeasible, and the other way round. Cuts have many digits, which may be too much work; then it is
// solved without them.
void Relaxation::conclude_exactly() {
  for (const std::size_t rows : {mixed_.program.rows.size(), given_rows_}) {
    if (!exact_ || rows < mixed_.program.rows.size()) exact_ = solve_exactly(rows);
    if (conclude_from(*exact_) || exact_->status == LinearStatus::interrupted) return;
  }
}

// @return true if the solution decides the program
bool Relaxation::conclude_from(const linear::ExactSolution& solution) {
  const bool stays_open =
      solution.status == LinearStatus::failed && status_ != LinearStatus::unbounded;
  if (!stays_open) status_ = solution.status;
  contradiction_ = status_ == LinearStatus::infeasible && !stays_open;
  if (solution.status != LinearStatus::optimal) {
    return solution.status == LinearStatus::infeasible ||
           solution.status == LinearStatus::unbounded;
  }
  values_ = solution.values;
  basis_ = solution.basis;
  raise_bound(solution);
  return true;
}

linear::ExactSolution Relaxation::exact_point() {
  if (exact_ && exact_->basis.rows() == given_rows_) return *exact_;
  exact_ = solve_exactly(given_rows_);
  if (exact_->status == LinearStatus::optimal) raise_bound(*exact_);
  if (exact_->status == LinearStatus::infeasible || exact_->status == LinearStatus::interrupted) {
    status_ = exact_->status;
    contradiction_ = status_ == LinearStatus::infeasible;
  }
  return *exact_;
}

// Keeps the bound of an exact solution if it is better.
void Relaxation::raise_bound(const linear::ExactSolution& solution) {
  if (solution.bound < bound_) return;
  bound_ = safe_.value = solution.bound;
  safe_.residuals = solution.reduced;
}

// Solves the first rows of the program, with the bounds of the simplex method, from its basis; with
// fewer rows from a basis of their own.
linear::ExactSolution Relaxation::solve_exactly(std::size_t rows) {
  const bool all = rows == mixed_.program.rows.size();
  auto start = all ? basis_ : linear::Basis();
  if (last_exact_ && last_exact_->rows == rows && last_exact_->fixed == fixed_ &&
      last_exact_->start == start) {
    return last_exact_->solution;
  }
  linear::LinearProgram program;
  program.constant = mixed_.program.constant;
  for (const auto& [cost, lower, upper, name] : mixed_.program.columns) {
    program.add_column({.cost = cost, .lower = lower, .upper = upper});
  }
  for (std::size_t k = 0; k < binaries(); ++k) {
    auto& column = program.columns[static_cast<std::size_t>(this->column(k))];
    column.lower = fixed_.lower[k];
    column.upper = fixed_.upper[k];
  }
  for (std::size_t i = 0; i < rows; ++i) {
    program.rows.push_back(
        {.lower = mixed_.program.rows[i].lower, .upper = mixed_.program.rows[i].upper});
  }
  for (const auto& entry : mixed_.program.entries) {
    if (static_cast<std::size_t>(entry.row) < rows) program.entries.push_back(entry);
  }
  ++exact_programs_;
  auto from = start;
  if (!all) {
    linear::Simplex doubles(program);
    doubles.solve_robustly({.stop = stop_});
    from = doubles.basis();
  }
  auto solution = linear::solve_exactly(program, from, stop_);
  last_exact_ = {rows, fixed_, std::move(start), solution};
  return solution;
}

double Relaxation::objective() const {
  if (exact_ && exact_->status == LinearStatus::optimal) return exact_->objective;
  return simplex_.objective();
}

double Relaxation::minimum(const std::vector<double>& alpha, const std::vector<double>& duals,
                           int column, double held, double relaxation_share) const {
  const bool safe_bounds = all_bounded();
  auto bounds = safe_bounds ? implied_ : own_bounds(mixed_.program);
  const auto at = static_cast<std::size_t>(column);
  bounds.lower[at] = bounds.upper[at] = held;
  // alpha - A'y, by the safe bound of the program with other costs.
  auto program = mixed_.program;
  program.constant = 0;
  for (std::size_t j = 0; j < alpha.size(); ++j) program.columns[j].cost = alpha[j];
  const auto safe = linear::safe_bound(program, duals, bounds.lower, bounds.upper);
  if (safe_bounds) return safe.value;
  double total = 0;
  double size = 1;
  for (std::size_t i = 0; i < duals.size(); ++i) {
    const auto& row = program.rows[i];
    const double pressed = duals[i] > 0 ? row.lower : row.upper;
    if (!std::isfinite(pressed)) continue;
    total += duals[i] * pressed;
    size += std::abs(duals[i] * pressed);
  }
  for (std::size_t j = 0; j < alpha.size(); ++j) {
    // Taken as zero if the column has no bound.
    const double residual = safe.residuals[j].lower;
    const double bound = residual > 0 ? bounds.lower[j] : bounds.upper[j];
    if (!std::isfinite(bound)) {
      if (std::abs(residual) > relaxation_share) return -linear::infinity;
      continue;
    }
    total += residual * bound;
    size += std::abs(residual * bound);
  }
  return total - relaxation_share * size;
}

double Relaxation::bound_if(std::size_t binary, bool at_one) const {
  const auto j = static_cast<std::size_t>(column(binary));
  const double held = at_one ? 1 : 0;
  using linear::rounded::sum_down;
  const auto& residual = safe_.residuals[j];
  // The bound may be an exact optimum, to which the column contributes with its exact reduced cost.
  const double now = linear::max_contribution(residual, node_.lower[j], node_.upper[j]);
  return sum_down(sum_down(bound_, -now), linear::min_product(residual, held, held));
}

}  // namespace kusabi::zero_one
