// (5), again and again.
#include "nodes/limit/load_factor.hpp"

#include <cmath>
#include <cstddef>

namespace kusabi::nodes::limit {
namespace {

using problems::LimitModel;

/// A descent goes on while the factor falls by this much of the scaled factor: what is less may be
/// rounding, and the next round would be for nothing.
constexpr double least_fall = 1e-10;

Eigen::VectorXd values(std::span<const double> numbers) {
  return Eigen::Map<const Eigen::VectorXd>(numbers.data(),
                                           static_cast<Eigen::Index>(numbers.size()));
}

}  // namespace

LoadFactor::LoadFactor(const LimitModel& model)
    : model_(model), simplex_(problems::static_program(model, model.dead)) {}

LoadStatus LoadFactor::solve(const Eigen::VectorXd& dead) {
  for (int k = 0; k < model_.free_count(); ++k) simplex_.set_row_bounds(k, dead(k), dead(k));
  switch (simplex_.solve_robustly()) {
    case linear::LinearStatus::optimal:
      if (!first_) first_ = simplex_.basis();
      return LoadStatus::collapses;
    case linear::LinearStatus::infeasible:
      return LoadStatus::not_carried;
    default:
      return LoadStatus::undetermined;
  }
}

void LoadFactor::restart() {
  if (first_) simplex_.set_basis(*first_);
}

Collapse LoadFactor::collapse() const {
  const auto columns = simplex_.values();
  const auto duals = simplex_.duals();
  return {columns.back(), values(std::span(columns).first(columns.size() - 1)), values(duals)};
}

Eigen::VectorXd LoadFactor::overpowering_motion() {
  const auto reason = simplex_.farkas();
  if (reason.empty()) return {};
  return values(reason);
}

Eigen::VectorXd worst_for(const LimitModel& model, double alpha, const Eigen::VectorXd& motion,
                          const Eigen::VectorXd& otherwise) {
  Eigen::VectorXd zeta(model.uncertain_count());
  for (int j = 0; j < model.uncertain_count(); ++j) {
    double sign = motion(model.uncertain[static_cast<std::size_t>(j)].degree);
    if (sign == 0) sign = otherwise(j);
    zeta(j) = sign < 0 ? -alpha : alpha;
  }
  return zeta;
}

std::optional<Worst> descend(const LimitModel& model, LoadFactor& load_factor, double alpha,
                             Eigen::VectorXd& zeta) {
  std::optional<Worst> worst;
  for (;;) {
    const LoadStatus status = load_factor.solve(problems::dead_load(model, zeta));
    if (status == LoadStatus::undetermined) return worst;
    if (status == LoadStatus::not_carried) return std::nullopt;
    Collapse collapse = load_factor.collapse();
    const bool falls = !worst || collapse.factor < worst->collapse.factor - least_fall;
    if (!falls) return worst;
    const Eigen::VectorXd next = worst_for(model, alpha, collapse.motion, zeta);
    const bool settled = next == zeta;
    worst = Worst{zeta, std::move(collapse)};
    if (settled) return worst;
    zeta = next;
  }
}

}  // namespace kusabi::nodes::limit
