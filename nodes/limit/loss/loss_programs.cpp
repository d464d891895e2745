// Lost members have forces with bounds of zero; all else stays.
#include "nodes/limit/loss/loss_programs.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace kusabi::limit {
namespace {

using problems::LimitModel;
using support::IndexSet;

/// Weights of |q_i|: members to be avoided, members that may be stressed at will, all others. A
/// state without avoided members is found if its forces are at most thirty times those of one with
/// them, and otherwise only by removing them.
constexpr double avoided_weight = 30;
constexpr double free_weight = 1e-3;

/// Smaller scaled forces of a basic solution are rounding errors.
constexpr double no_force = 1e-12;

Eigen::VectorXd values(const std::vector<double>& numbers, int count) {
  return Eigen::Map<const Eigen::VectorXd>(numbers.data(), count);
}

// Columns: q^+ and q^- of each member in turn, lambda. Rows: equilibrium.
linear::LinearProgram state_program(const LimitModel& model, double target) {
  linear::LinearProgram program;
  program.name = "carrying stress state";
  for (int i = 0; i < model.member_count(); ++i) {
    program.add_column({.cost = 1, .upper = model.tension(i)});
    program.add_column({.cost = 1, .upper = model.compression(i)});
  }
  const int factor = program.add_column({.lower = target});
  for (int k = 0; k < model.free_count(); ++k) {
    const linear::LinearTerm term{factor, -model.reference(k)};
    program.add_row({.lower = model.dead(k), .upper = model.dead(k)}, std::span(&term, 1));
  }
  for (int i = 0; i < model.member_count(); ++i) {
    for (Eigen::SparseMatrix<double>::InnerIterator entry(model.equilibrium, i); entry; ++entry) {
      const int row = static_cast<int>(entry.row());
      program.entries.push_back({row, 2 * i, entry.value()});
      program.entries.push_back({row, 2 * i + 1, -entry.value()});
    }
  }
  return program;
}

}  // namespace

RemainingFactor::RemainingFactor(const LimitModel& model, support::Stop stop)
    : model_(model), stop_(std::move(stop)), simplex_(problems::static_program(model, model.dead)) {
  if (simplex_.solve_robustly() == linear::LinearStatus::optimal) {
    first_ = simplex_.basis();
  } else {
    simplex_.use_slack_basis();
    first_ = simplex_.basis();
  }
}

LoadStatus RemainingFactor::solve(const IndexSet& lost) {
  for (const int i : lost_ - lost) {
    simplex_.set_column_bounds(i, -model_.compression(i), model_.tension(i));
  }
  for (const int i : lost - lost_) simplex_.set_column_bounds(i, 0, 0);
  lost_ = lost;
  simplex_.set_basis(first_);
  switch (simplex_.solve_robustly({.stop = stop_})) {
    case linear::LinearStatus::optimal:
      return LoadStatus::collapses;
    case linear::LinearStatus::infeasible:
      return LoadStatus::not_carried;
    default:
      return LoadStatus::undetermined;
  }
}

Collapse RemainingFactor::collapse() const {
  const auto columns = simplex_.values();
  return {columns.back(), values(columns, model_.member_count()),
          values(simplex_.duals(), model_.free_count())};
}

Eigen::VectorXd RemainingFactor::overpowering_motion() {
  const auto reason = simplex_.farkas();
  if (reason.empty()) return {};
  return values(reason, model_.free_count());
}

StateProgram::StateProgram(const LimitModel& model, double target, support::Stop stop)
    : model_(model), stop_(std::move(stop)), simplex_(state_program(model, target)) {
  if (simplex_.solve_robustly() != linear::LinearStatus::optimal) simplex_.use_slack_basis();
  first_ = simplex_.basis();
}

void StateProgram::restart() {
  simplex_.set_basis(first_);
}

StateProgram::Result StateProgram::solve(const IndexSet& lost, const IndexSet& avoided,
                                         const IndexSet& free, double margin) {
  for (int i = 0; i < model_.member_count(); ++i) {
    const double share = lost.contains(i) ? 0 : 1 - margin;
    simplex_.set_column_bounds(2 * i, 0, share * model_.tension(i));
    simplex_.set_column_bounds(2 * i + 1, 0, share * model_.compression(i));
    const double weight = avoided.contains(i) ? avoided_weight : free.contains(i) ? free_weight : 1;
    simplex_.set_cost(2 * i, weight);
    simplex_.set_cost(2 * i + 1, weight);
  }
  switch (simplex_.solve_robustly({.stop = stop_})) {
    case linear::LinearStatus::optimal:
      return Result::found;
    case linear::LinearStatus::infeasible:
      return Result::none;
    default:
      return Result::undetermined;
  }
}

CarryingState StateProgram::state() const {
  const auto columns = simplex_.values();
  CarryingState state{columns.back(), Eigen::VectorXd(model_.member_count())};
  for (int i = 0; i < model_.member_count(); ++i) {
    const auto at = 2 * static_cast<std::size_t>(i);
    // The simplex method may violate bounds by its tolerance.
    const double force =
        std::clamp(columns[at] - columns[at + 1], -model_.compression(i), model_.tension(i));
    state.forces(i) = std::abs(force) < no_force ? 0 : force;
  }
  return state;
}

}  // namespace kusabi::limit
