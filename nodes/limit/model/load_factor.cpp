// Program (5), with a warm start from one dead load to the next.
#include "nodes/limit/model/load_factor.hpp"

#include <cmath>
#include <cstddef>
#include <utility>
#include <variant>

namespace kusabi::limit {
namespace {

using problems::LimitModel;

/// Minimum decrease of the scaled factor for another round of a descent; smaller ones may be
/// rounding errors.
constexpr double min_fall = 1e-10;

Eigen::VectorXd values(std::span<const double> numbers) {
  return Eigen::Map<const Eigen::VectorXd>(numbers.data(),
                                           static_cast<Eigen::Index>(numbers.size()));
}

}  // namespace

LoadFactor::LoadFactor(const LimitModel& model, support::Stop stop)
    : model_(model),
      stop_(std::move(stop)),
      simplex_(problems::static_program(model, model.dead)) {}

// The cost of lambda is -1 except here.
std::optional<Collapse> LoadFactor::opposite_collapse(const Eigen::VectorXd& dead) {
  const int factor = model_.member_count();
  simplex_.set_cost(factor, 1);
  restart();
  const auto status = solve(dead);
  simplex_.set_cost(factor, -1);
  if (status != LoadStatus::collapses) return {};
  auto found = collapse();
  found.factor = -found.factor;
  return found;
}

LoadStatus LoadFactor::solve(const Eigen::VectorXd& dead) {
  for (int k = 0; k < model_.free_count(); ++k) simplex_.set_row_bounds(k, dead(k), dead(k));
  const auto& answer = simplex_.solve(stop_);
  if (std::holds_alternative<linear::CheckedInfeasibility>(answer)) return LoadStatus::not_carried;
  if (!std::holds_alternative<linear::CheckedOptimum>(answer)) return LoadStatus::undetermined;
  if (!first_) {
    first_ = simplex_.basis();
    first_iterations_ = simplex_.iterations();
  }
  return LoadStatus::collapses;
}

void LoadFactor::restart() {
  if (first_) simplex_.set_basis(*first_);
}

Collapse LoadFactor::collapse() const {
  const auto& optimum = simplex_.optimum();
  const auto columns = optimum.values();
  return {columns.back(), values(columns.first(columns.size() - 1)), values(optimum.duals())};
}

Eigen::VectorXd LoadFactor::overpowering_motion() const {
  const auto* const shown = std::get_if<linear::CheckedInfeasibility>(&simplex_.answer());
  return shown == nullptr ? Eigen::VectorXd() : values(shown->multipliers());
}

Eigen::VectorXd worst_for(const LimitModel& model, double alpha, const Eigen::VectorXd& motion,
                          const Eigen::VectorXd& otherwise) {
  Eigen::VectorXd zeta(model.uncertain_count());
  for (int j = 0; j < model.uncertain_count(); ++j) {
    double sign = model.uncertain[static_cast<std::size_t>(j)].along(motion);
    if (sign == 0) sign = otherwise(j);
    zeta(j) = sign < 0 ? -alpha : alpha;
  }
  return zeta;
}

Descent descend(const LimitModel& model, double alpha, Eigen::VectorXd zeta,
                const std::function<LoadResult(const Eigen::VectorXd& dead)>& solve) {
  Descent descent;
  for (;;) {
    auto [status, collapse, motion] = solve(problems::dead_load(model, zeta));
    if (status == LoadStatus::not_carried) return {status, {}, std::move(zeta), std::move(motion)};
    if (status == LoadStatus::undetermined) return descent;
    if (descent.status == LoadStatus::collapses &&
        collapse.factor >= descent.worst.collapse.factor - min_fall) {
      return descent;
    }
    Eigen::VectorXd next = worst_for(model, alpha, collapse.motion, zeta);
    const bool settled = next == zeta;
    descent.status = LoadStatus::collapses;
    descent.worst = {std::move(zeta), std::move(collapse)};
    if (settled) return descent;
    zeta = std::move(next);
  }
}

Descent descend(const LimitModel& model, LoadFactor& load_factor, double alpha,
                Eigen::VectorXd zeta) {
  return descend(model, alpha, std::move(zeta), [&](const Eigen::VectorXd& dead) -> LoadResult {
    const auto status = load_factor.solve(dead);
    if (status == LoadStatus::collapses) return {status, load_factor.collapse()};
    if (status == LoadStatus::not_carried) return {status, {}, load_factor.overpowering_motion()};
    return {};
  });
}

}  // namespace kusabi::limit
