// Program (5) with other bounds of its forces.
#include "nodes/limit/splitting/safe_bound.hpp"

#include <cmath>
#include <utility>

namespace kusabi::limit::splitting {

SafeStates::SafeStates(const problems::LimitModel& model, support::Stop stop)
    : model_(model),
      stop_(std::move(stop)),
      simplex_(problems::static_program(model, model.dead)) {}

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
  if (simplex_.solve_robustly({.stop = stop_}) != linear::LinearStatus::optimal) return {};
  SafeState state;
  state.factor = simplex_.value(members);
  state.bound = state.factor - taken.back();
  state.forces.resize(members);
  for (int i = 0; i < members; ++i) state.forces(i) = simplex_.value(i);
  return state;
}

std::vector<int> SafeStates::members_in_the_way() {
  constexpr double share = 1e-2;
  const auto reason = simplex_.farkas();
  if (reason.empty()) return {};
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
