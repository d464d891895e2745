// Fixings become bounds of columns; multipliers become a bound of the objective.
#include "nodes/zero_one/relaxation.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace kusabi::nodes {
namespace {

using linear::LinearStatus;

const problems::LinearProgram& checked(const problems::MixedProgram& mixed) {
  std::vector<bool> seen(mixed.program.columns.size());
  for (const int column : mixed.binaries) {
    const auto at = static_cast<std::size_t>(column);
    if (column < 0 || at >= seen.size() || seen[at]) {
      throw std::invalid_argument("mixed program: a binary is no column, or is listed twice");
    }
    seen[at] = true;
    const auto& [cost, lower, upper, name] = mixed.program.columns[at];
    if (!(lower >= 0 && upper <= 1)) {
      throw std::invalid_argument("mixed program: a binary has bounds outside of [0, 1]");
    }
  }
  return mixed.program;
}

}  // namespace

Relaxation::Relaxation(problems::MixedProgram mixed)
    : mixed_(std::move(mixed)),
      simplex_(checked(mixed_)),
      implied_(implied_bounds(mixed_.program)),
      node_(implied_) {
  // A binary with bounds like [0, 0.5] is 0.
  for (const int column : mixed_.binaries) {
    auto& [cost, lower, upper, name] = mixed_.program.columns[static_cast<std::size_t>(column)];
    lower = std::ceil(lower);
    upper = std::floor(upper);
    simplex_.set_column_bounds(column, lower, upper);
    held_.lower.push_back(lower);
    held_.upper.push_back(upper);
  }
  proves_ = all_bounded();
}

bool Relaxation::all_bounded() const {
  const auto finite = [](double bound) { return std::isfinite(bound); };
  return std::all_of(implied_.lower.begin(), implied_.lower.end(), finite) &&
         std::all_of(implied_.upper.begin(), implied_.upper.end(), finite);
}

void Relaxation::add_row(const problems::LinearRow& row,
                         const std::vector<problems::LinearTerm>& terms) {
  mixed_.program.add_row(row, terms);
  simplex_.add_row(row.lower, row.upper, terms);
}

void Relaxation::drop_last_row() {
  auto& [name, constant, columns, rows, entries] = mixed_.program;
  const int last = static_cast<int>(rows.size()) - 1;
  while (!entries.empty() && entries.back().row == last) entries.pop_back();
  rows.pop_back();
  simplex_.drop_rows(last);
}

void Relaxation::matters_below(double cutoff) {
  implied_ = implied_bounds(mixed_.program, cutoff);
  proves_ = all_bounded();
}

void Relaxation::hold(const Fixings& fixings) {
  node_ = implied_;
  for (std::size_t k = 0; k < binaries(); ++k) {
    const auto j = static_cast<std::size_t>(column(k));
    const auto& own = mixed_.program.columns[j];
    const double lower = fixings.at_one(k) ? 1 : own.lower;
    const double upper = fixings.at_zero(k) ? 0 : own.upper;
    if (lower != held_.lower[k] || upper != held_.upper[k]) {
      simplex_.set_column_bounds(column(k), lower, upper);
      held_.lower[k] = lower;
      held_.upper[k] = upper;
    }
    node_.lower[j] = lower;
    node_.upper[j] = upper;
  }
}

LinearStatus Relaxation::solve(const Fixings& fixings, const linear::Basis& basis,
                               const linear::SolveLimits& limits) {
  hold(fixings);
  if (basis.empty()) {
    simplex_.use_slack_basis();
  } else {
    simplex_.set_basis(basis);
  }
  simplex_.solve_robustly(limits);
  conclude();
  return simplex_.status();
}

LinearStatus Relaxation::solve_on(const Fixings& fixings, const linear::SolveLimits& limits) {
  hold(fixings);
  simplex_.solve_robustly(limits);
  conclude();
  return simplex_.status();
}

void Relaxation::conclude() {
  bound_ = -problems::infinity;
  contradiction_ = false;
  switch (simplex_.status()) {
    case LinearStatus::optimal:
    case LinearStatus::cut_off:
    case LinearStatus::stopped:
    case LinearStatus::interrupted:
      if (proves_) {
        safe_ = linear::safe_bound(mixed_.program, simplex_.duals(), node_.lower, node_.upper);
        bound_ = safe_.value;
      } else if (simplex_.dual_feasible()) {
        bound_ = simplex_.objective();
      }
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
      return;
    }
    case LinearStatus::unbounded:
    case LinearStatus::failed:
      return;
  }
}

double Relaxation::least(const std::vector<double>& alpha, const std::vector<double>& duals,
                         int column, double held, double give_way) const {
  auto bounds = proves_ ? implied_ : own_bounds(mixed_.program);
  const auto at = static_cast<std::size_t>(column);
  bounds.lower[at] = bounds.upper[at] = held;
  // alpha - A'y, by the safe bound of the program with other costs.
  auto program = mixed_.program;
  program.constant = 0;
  for (std::size_t j = 0; j < alpha.size(); ++j) program.columns[j].cost = alpha[j];
  const auto safe = linear::safe_bound(program, duals, bounds.lower, bounds.upper);
  if (proves_) return safe.value;
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
    // What should be zero is taken for it where the column has no bound to weigh it with.
    const double residual = safe.residuals[j].lower;
    const double bound = residual > 0 ? bounds.lower[j] : bounds.upper[j];
    if (!std::isfinite(bound)) {
      if (std::abs(residual) > give_way) return -problems::infinity;
      continue;
    }
    total += residual * bound;
    size += std::abs(residual * bound);
  }
  return total - give_way * size;
}

double Relaxation::bound_if(std::size_t binary, bool at_one) const {
  const auto j = static_cast<std::size_t>(column(binary));
  const double held = at_one ? 1 : 0;
  if (!proves_) {
    const double gain = simplex_.reduced_cost(column(binary));
    return bound_ + std::max(0.0, at_one ? gain : -gain);
  }
  using linear::rounded::sum_down;
  const auto& residual = safe_.residuals[j];
  const double now = linear::least_product(residual, node_.lower[j], node_.upper[j]);
  return sum_down(sum_down(bound_, -now), linear::least_product(residual, held, held));
}

}  // namespace kusabi::nodes
