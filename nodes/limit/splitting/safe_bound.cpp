// Program (5) with other bounds of its forces.
#include "nodes/limit/splitting/safe_bound.hpp"

#include <cmath>
#include <utility>
#include <variant>

namespace kusabi::limit::splitting {

SafeStates::SafeStates(const problems::LimitModel& model, support::Stop stop)
    : model_(model),
      stop_(std::move(stop)),
      simplex_(problems::static_program(model, model.dead)) {}

void SafeStates::set_load(const Eigen::VectorXd& dead) {
  for (int k = 0; k < model_.free_count(); ++k) simplex_.set_row_bounds(k, dead(k), dead(k));
}

std::optional<SafeState> SafeStates::state(const std::vector<double>& taken,
                                           const Eigen::VectorXd& room) {
  const int members = model_.member_count();
  for (int i = 0; i < members; ++i) {
    const double less = taken[static_cast<std::size_t>(i)] + room(i);
    const double lower = less - model_.compression(i);
    const double upper = model_.tension(i) - less;
    if (lower > upper) return {};
    simplex_.set_column_bounds(i, lower, upper);
  }
  const auto* const optimum = std::get_if<linear::CheckedOptimum>(&simplex_.solve(stop_));
  if (optimum == nullptr) return {};
  SafeState state;
  state.factor = optimum->value(members);
  state.bound = state.factor - taken.back();
  state.forces.resize(members);
  for (int i = 0; i < members; ++i) state.forces(i) = optimum->value(i);
  return state;
}

std::vector<int> SafeStates::members_in_the_way() const {
  constexpr double share = 1e-2;
  const auto* const shown = std::get_if<linear::CheckedInfeasibility>(&simplex_.answer());
  if (shown == nullptr || shown->multipliers().empty()) return {};
  const auto reason = shown->multipliers();
  const Eigen::VectorXd stretch =
      (model_.equilibrium.transpose() *
       Eigen::Map<const Eigen::VectorXd>(reason.data(), model_.free_count()))
          .cwiseAbs();
  std::vector<int> members;
  for (int i = 0; i < stretch.size(); ++i) {
    if (stretch(i) > share * stretch.maxCoeff()) members.push_back(i);
  }
  return members;
}

}  // namespace kusabi::limit::splitting
