// Lost members have forces with bounds of zero; all else stays.
#include "nodes/limit/loss/loss_programs.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>
#include <utility>
#include <variant>

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

/// The same for the force of a cable under all loads, which the simplex method finds up to its
/// tolerance only.
constexpr double no_cable_force = 1e-8;

/// Relative increase of the variation of forces: a cable without compression strength has no other
/// margin.
constexpr double variation_margin = 1e-8;

Eigen::VectorXd values(std::span<const double> numbers, int count) {
  return Eigen::Map<const Eigen::VectorXd>(numbers.data(), count);
}

std::vector<Eigen::VectorXd> loads_of(const LimitModel& model, double alpha) {
  std::vector<Eigen::VectorXd> loads{model.dead};
  if (alpha == 0) return loads;
  for (const auto& column : model.uncertain) {
    Eigen::VectorXd load = Eigen::VectorXd::Zero(model.free_count());
    column.add_to(load, alpha);
    loads.push_back(std::move(load));
  }
  return loads;
}

}  // namespace

RemainingFactor::RemainingFactor(const LimitModel& model, double alpha)
    : model_(model), alpha_(alpha), simplex_(problems::static_program(model, model.dead)) {
  if (!std::holds_alternative<linear::CheckedOptimum>(simplex_.solve())) simplex_.use_slack_basis();
  first_ = simplex_.basis();
}

// Of the truss without the lost members.
LoadResult RemainingFactor::result(const Eigen::VectorXd& dead, const support::Stop& stop) {
  for (int k = 0; k < model_.free_count(); ++k) simplex_.set_row_bounds(k, dead(k), dead(k));
  const auto& answer = simplex_.solve(stop);
  if (const auto* const shown = std::get_if<linear::CheckedInfeasibility>(&answer)) {
    const auto reason = shown->multipliers();
    return {LoadStatus::not_carried, {}, values(reason, static_cast<int>(reason.size()))};
  }
  const auto* const optimum = std::get_if<linear::CheckedOptimum>(&answer);
  if (optimum == nullptr) return {};
  return {LoadStatus::collapses,
          {optimum->values().back(), values(optimum->values(), model_.member_count()),
           values(optimum->duals(), model_.free_count())}};
}

Descent RemainingFactor::descend(Eigen::VectorXd zeta, const support::Stop& stop) {
  simplex_.set_basis(first_);
  return limit::descend(model_, alpha_, std::move(zeta),
                        [&](const Eigen::VectorXd& dead) { return result(dead, stop); });
}

Descent RemainingFactor::solve(const IndexSet& lost, const Eigen::VectorXd& start,
                               const support::Stop& stop) {
  for (const int i : lost_ - lost) {
    simplex_.set_column_bounds(i, -model_.compression(i), model_.tension(i));
  }
  for (const int i : lost - lost_) simplex_.set_column_bounds(i, 0, 0);
  lost_ = lost;
  auto found = descend(Eigen::VectorXd::Zero(model_.uncertain_count()), stop);
  if (alpha_ == 0 || start.size() == 0 || found.status != LoadStatus::collapses) return found;
  auto other = descend(start, stop);
  const bool less = other.status == LoadStatus::not_carried ||
                    (other.status == LoadStatus::collapses &&
                     other.worst.collapse.factor < found.worst.collapse.factor);
  return less ? other : found;
}

// Columns of each load: q^+ and q^- of each member in turn. Then lambda_0, and kappa^+ and kappa^-
// of each uncertain load.
int StateProgram::force_column(std::size_t load, int member) const {
  return 2 * (static_cast<int>(load) * model_.member_count() + member);
}

int StateProgram::factor_column(std::size_t load) const {
  const int first = force_column(loads_.size(), 0);
  return load == 0 ? first : first + 2 * static_cast<int>(load) - 1;
}

// Rows: equilibrium of each load. With uncertain loads also lambda_0 - sum_j |kappa_j|, and the two
// yield forces of each member.
linear::LinearProgram StateProgram::program() const {
  linear::LinearProgram program;
  program.name = "carrying stress state";
  const int forces = force_column(loads_.size(), 0);
  for (int column = 0; column < forces; ++column) program.add_column({.cost = 1});
  program.add_column({.lower = -linear::infinity});
  for (std::size_t load = 1; load < loads_.size(); ++load) {
    program.add_column({});
    program.add_column({});
  }
  const auto add = [&](int row, int column, double value) {
    program.entries.push_back({row, column, value});
  };
  for (std::size_t load = 0; load < loads_.size(); ++load) {
    const int first = static_cast<int>(load) * model_.free_count();
    for (int k = 0; k < model_.free_count(); ++k) {
      program.add_row({.lower = loads_[load](k), .upper = loads_[load](k)}, {});
      if (model_.reference(k) == 0) continue;
      add(first + k, factor_column(load), -model_.reference(k));
      if (load > 0) add(first + k, factor_column(load) + 1, model_.reference(k));
    }
    for (int i = 0; i < model_.member_count(); ++i) {
      for (Eigen::SparseMatrix<double>::InnerIterator entry(model_.equilibrium, i); entry;
           ++entry) {
        const int row = first + static_cast<int>(entry.row());
        add(row, force_column(load, i), entry.value());
        add(row, force_column(load, i) + 1, -entry.value());
      }
    }
  }
  if (loads_.size() == 1) return program;
  int row = static_cast<int>(loads_.size()) * model_.free_count();
  program.add_row({}, {});
  add(row, factor_column(0), 1);
  for (std::size_t load = 1; load < loads_.size(); ++load) {
    add(row, factor_column(load), -1);
    add(row, factor_column(load) + 1, -1);
  }
  for (int i = 0; i < model_.member_count(); ++i) {
    for (const double sign : {1.0, -1.0}) {
      program.add_row({.upper = 0}, {});
      ++row;
      add(row, force_column(0, i), sign);
      add(row, force_column(0, i) + 1, -sign);
      for (std::size_t load = 1; load < loads_.size(); ++load) {
        add(row, force_column(load, i), 1 + variation_margin);
        add(row, force_column(load, i) + 1, 1 + variation_margin);
      }
    }
  }
  return program;
}

StateProgram::StateProgram(const LimitModel& model, double alpha, double target, support::Stop stop)
    : model_(model), loads_(loads_of(model, alpha)), stop_(std::move(stop)), simplex_(program()) {
  simplex_.use_slack_basis();
  first_ = simplex_.basis();
  restart(target);
  if (solve({}, {}, {}, yield_margins[0]) == Result::found) first_ = simplex_.basis();
}

void StateProgram::restart(double target) {
  simplex_.set_basis(first_);
  if (loads_.size() == 1) {
    simplex_.set_column_bounds(factor_column(0), target, linear::infinity);
  } else {
    const int row = static_cast<int>(loads_.size()) * model_.free_count();
    simplex_.set_row_bounds(row, target, linear::infinity);
  }
}

StateProgram::Result StateProgram::solve(const IndexSet& lost, const IndexSet& avoided,
                                         const IndexSet& free, double margin) {
  const bool alone = loads_.size() == 1;
  const int rows = static_cast<int>(loads_.size()) * model_.free_count() + 1;
  for (int i = 0; i < model_.member_count(); ++i) {
    const double share = lost.contains(i) ? 0 : 1 - margin;
    const double tension = share * model_.tension(i);
    const double compression = share * model_.compression(i);
    const double weight = avoided.contains(i) ? avoided_weight : free.contains(i) ? free_weight : 1;
    if (!alone) {
      simplex_.set_row_bounds(rows + 2 * i, -linear::infinity, tension);
      simplex_.set_row_bounds(rows + 2 * i + 1, -linear::infinity, compression);
    }
    const double maximum = std::max(tension, compression);
    for (std::size_t load = 0; load < loads_.size(); ++load) {
      const int column = force_column(load, i);
      simplex_.set_column_bounds(column, 0, alone ? tension : maximum);
      simplex_.set_column_bounds(column + 1, 0, alone ? compression : maximum);
      simplex_.set_cost(column, weight);
      simplex_.set_cost(column + 1, weight);
    }
  }
  const auto& answer = simplex_.solve(stop_);
  if (std::holds_alternative<linear::CheckedOptimum>(answer)) return Result::found;
  return std::holds_alternative<linear::CheckedInfeasibility>(answer) ? Result::none
                                                                      : Result::undetermined;
}

IndexSet StateProgram::basic_members() const {
  const auto basis = simplex_.basis();
  const auto is_basic = [&](int column) {
    return basis.column(static_cast<std::size_t>(column)) == linear::BasisStatus::basic;
  };
  IndexSet members;
  for (std::size_t load = 0; load < loads_.size(); ++load) {
    for (int i = 0; i < model_.member_count(); ++i) {
      const int force = force_column(load, i);
      if (is_basic(force) || is_basic(force + 1)) members.insert(i);
    }
  }
  return members;
}

verify::StressState StateProgram::state() const {
  const auto& optimum = simplex_.optimum();
  const auto at = [&](int column) { return optimum.value(column); };
  verify::StressState state;
  IndexSet stressed;
  IndexSet idle;
  for (int i = 0; i < model_.member_count(); ++i) {
    double maximum = 0;
    for (std::size_t load = 0; load < loads_.size(); ++load)
      maximum =
          std::max(maximum, std::abs(at(force_column(load, i)) - at(force_column(load, i) + 1)));
    const bool cable = model_.tension(i) == 0 || model_.compression(i) == 0;
    if (maximum < (cable ? no_cable_force : no_force)) idle.insert(i);
  }
  for (std::size_t load = 0; load < loads_.size(); ++load) {
    auto& column = state.columns.emplace_back();
    const int place = factor_column(load);
    column.factor = (load == 0 ? at(place) : at(place) - at(place + 1)) * model_.factor_unit;
    for (int i = 0; i < model_.member_count(); ++i) {
      const int force = force_column(load, i);
      const double size = at(force) - at(force + 1);
      if (std::abs(size) < no_force || idle.contains(i)) continue;
      stressed.insert(i);
      column.forces.emplace_back(static_cast<std::size_t>(i), size * model_.member_unit(i));
    }
  }
  for (const int i : stressed) state.support.push_back(static_cast<std::size_t>(i));
  return state;
}

}  // namespace kusabi::limit
