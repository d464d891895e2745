// (27) to (29), row by row.
#include "problems/limit/mixed_limit.hpp"

#include <cmath>
#include <cstddef>
#include <vector>

namespace kusabi::problems {

linear::MixedProgram worst_case_program(const LimitModel& model, double alpha,
                                        const Eigen::VectorXd& big_m,
                                        const Eigen::VectorXd& max_motion,
                                        const Eigen::VectorXd& max_elongation) {
  linear::MixedProgram mixed;
  mixed.program = kinematic_program(model, model.dead);
  auto& program = mixed.program;
  program.name = "worst-case limit load (29)";
  for (int k = 0; k < model.free_count(); ++k) {
    auto& column = program.columns[static_cast<std::size_t>(k)];
    column.lower = -max_motion(k);
    column.upper = max_motion(k);
  }
  for (int i = 0; i < model.member_count(); ++i) {
    program.columns[static_cast<std::size_t>(model.free_count() + i)].upper = max_elongation(i);
  }
  const int m = model.uncertain_count();
  for (int j = 0; j < m; ++j) {
    const auto& column = model.uncertain[static_cast<std::size_t>(j)];
    double maximum = 0;
    for (const auto& [degree, value] : column.direction) {
      maximum += std::abs(value) * max_motion(degree);
    }
    program.add_column({.cost = -alpha * column.weight, .upper = maximum});
  }
  for (int j = 0; j < m; ++j) mixed.binaries.push_back(program.add_column({.upper = 1}));
  for (int j = 0; j < m; ++j) {
    const int gamma = model.free_count() + model.member_count() + j;
    const int tau = gamma + m;
    for (const double sign : {-1.0, 1.0}) {
      std::vector<linear::LinearTerm> terms{{gamma, 1}};
      for (const auto& [degree, value] : model.uncertain[static_cast<std::size_t>(j)].direction) {
        terms.push_back({degree, sign * value});
      }
      terms.push_back({tau, -sign * big_m(j)});
      program.add_row({.upper = sign < 0 ? big_m(j) : 0}, terms);
    }
  }
  return mixed;
}

std::vector<double> worst_case_point(const LimitModel& model, const Eigen::VectorXd& motion) {
  std::vector<double> point(motion.begin(), motion.end());
  const Eigen::VectorXd elongation = model.equilibrium.transpose() * motion;
  for (const double each : elongation) point.push_back(std::abs(each));
  for (const auto& column : model.uncertain) point.push_back(std::abs(column.along(motion)));
  for (const auto& column : model.uncertain) point.push_back(column.along(motion) < 0 ? 0 : 1);
  return point;
}

}  // namespace kusabi::problems
