// Fixed-point iteration, one or two steps.
#include "nodes/limit/model/balanced_model.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "nodes/limit/model/load_factor.hpp"

namespace kusabi::limit {
namespace {

using problems::LimitModel;
using problems::LimitProblem;

/// Maximum number of steps; no known truss takes more than three.
constexpr int max_times = 8;

// Iterates from one unit of force. @return true if a collapse was found
bool balance(const LimitProblem& problem, LimitModel& model, double alpha) {
  for (int time = 0; time < max_times; ++time) {
    LoadFactor load_factor(model);
    if (load_factor.solve(model.dead) != LoadStatus::collapses) return false;
    const double size = dissipation(problem, model, load_factor.collapse().motion);
    if (!is_out_of_balance(size)) return true;
    const double before = model.force_unit;
    model = rebalanced(problem, model, size, alpha);
    if (model.force_unit == before) return true;
  }
  return true;
}

}  // namespace

bool is_out_of_balance(double dissipation) {
  constexpr double far = 0x1p6;
  return !(dissipation > 1 / far && dissipation < far);
}

double dissipation(const LimitProblem& problem, const LimitModel& model,
                   const Eigen::VectorXd& motion) {
  const Eigen::VectorXd elongation = model.equilibrium.transpose() * motion;
  double total = 0;
  for (int i = 0; i < model.member_count(); ++i) {
    const double yield = elongation(i) < 0 ? problem.compression(i) : problem.tension(i);
    total += std::abs(elongation(i)) * (yield / model.member_unit(i));
  }
  return total;
}

std::optional<LimitModel> with_more_yield(const LimitProblem& problem, const LimitModel& model) {
  constexpr double more = 0x1p12;
  constexpr double enough = 0x1p40;
  const bool cut_off = model.tension.maxCoeff() >= model.max_yield ||
                       model.compression.maxCoeff() >= model.max_yield;
  if (!cut_off || model.max_yield >= enough) return {};
  return limit_model(problem, model.force_unit, model.max_yield * more);
}

LimitModel rebalanced(const LimitProblem& problem, const LimitModel& model, double dissipation,
                      double alpha) {
  // Lower limit relative to the weakest member, since a collapse may have no dissipation.
  constexpr double below_all = 0x1p-10;
  const Eigen::VectorXd yield = (problem.tension + problem.compression) / 2;
  double load = std::max(problem.dead.cwiseAbs().maxCoeff(), below_all * yield.minCoeff());
  for (const auto& column : problem.uncertain) load = std::max(load, alpha * column.largest());
  constexpr double farthest = 0x1p60;
  const double unit = model.force_unit * std::clamp(dissipation, 1 / farthest, farthest);
  return limit_model(problem, std::max(unit, load), model.max_yield);
}

LimitModel balanced_model(const LimitProblem& problem, double alpha) {
  const LimitModel middle = limit_model(problem);
  const Eigen::VectorXd yield = (problem.tension + problem.compression) / 2;
  for (const double unit : {middle.force_unit, yield.maxCoeff(), yield.minCoeff()}) {
    LimitModel model = limit_model(problem, unit);
    if (balance(problem, model, alpha)) return model;
  }
  return middle;
}

}  // namespace kusabi::limit
