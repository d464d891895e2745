// (27) to (29), row by row.
#include "problems/limit/mixed_limit.hpp"

#include <array>
#include <cmath>
#include <cstddef>

namespace kusabi::problems {

linear::MixedProgram worst_case_program(const LimitModel& model, double alpha,
                                        const Eigen::VectorXd& big_m,
                                        const Eigen::VectorXd& most_motion,
                                        const Eigen::VectorXd& most_elongation) {
  linear::MixedProgram mixed;
  mixed.program = kinematic_program(model, model.dead);
  auto& program = mixed.program;
  program.name = "worst-case limit load (29)";
  for (int k = 0; k < model.free_count(); ++k) {
    auto& column = program.columns[static_cast<std::size_t>(k)];
    column.lower = -most_motion(k);
    column.upper = most_motion(k);
  }
  for (int i = 0; i < model.member_count(); ++i) {
    program.columns[static_cast<std::size_t>(model.free_count() + i)].upper = most_elongation(i);
  }
  const int m = model.uncertain_count();
  for (int j = 0; j < m; ++j) {
    const auto& [degree, weight] = model.uncertain[static_cast<std::size_t>(j)];
    program.add_column({.cost = -alpha * weight, .upper = most_motion(degree)});
  }
  for (int j = 0; j < m; ++j) mixed.binaries.push_back(program.add_column({.upper = 1}));
  for (int j = 0; j < m; ++j) {
    const int degree = model.uncertain[static_cast<std::size_t>(j)].degree;
    const int gamma = model.free_count() + model.member_count() + j;
    const int tau = gamma + m;
    const std::array<linear::LinearTerm, 3> positive{{{gamma, 1}, {degree, -1}, {tau, big_m(j)}}};
    program.add_row({.upper = big_m(j)}, positive);
    const std::array<linear::LinearTerm, 3> negative{{{gamma, 1}, {degree, 1}, {tau, -big_m(j)}}};
    program.add_row({.upper = 0}, negative);
  }
  return mixed;
}

std::vector<double> worst_case_point(const LimitModel& model, const Eigen::VectorXd& motion) {
  std::vector<double> point(motion.begin(), motion.end());
  const Eigen::VectorXd elongation = model.equilibrium.transpose() * motion;
  for (const double each : elongation) point.push_back(std::abs(each));
  for (const auto& [degree, weight] : model.uncertain) point.push_back(std::abs(motion(degree)));
  for (const auto& [degree, weight] : model.uncertain) point.push_back(motion(degree) < 0 ? 0 : 1);
  return point;
}

}  // namespace kusabi::problems
