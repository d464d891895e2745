// The symmetric, scaled form, and its two programs.
#include "problems/limit/limit_analysis.hpp"

#include <algorithm>
#include <cstddef>

namespace kusabi::problems {

LimitModel limit_model(const LimitProblem& problem) {
  LimitModel model;
  model.force_unit = std::max(problem.tension.maxCoeff(), problem.compression.maxCoeff());
  const double reference_unit = problem.reference.cwiseAbs().maxCoeff();
  model.factor_unit = model.force_unit / reference_unit;
  model.equilibrium = problem.equilibrium;
  model.yield = (problem.tension + problem.compression) / (2 * model.force_unit);
  model.shift = (problem.tension - problem.compression) / (2 * model.force_unit);
  model.dead = problem.dead / model.force_unit - problem.equilibrium * model.shift;
  model.reference = problem.reference / reference_unit;
  model.uncertain = problem.uncertain;
  return model;
}

Eigen::VectorXd dead_load(const LimitModel& model, const Eigen::VectorXd& zeta) {
  Eigen::VectorXd load = model.dead;
  for (int j = 0; j < model.uncertain_count(); ++j) {
    const auto& [degree, weight] = model.uncertain[static_cast<std::size_t>(j)];
    load(degree) += weight * zeta(j);
  }
  return load;
}

LinearProgram static_program(const LimitModel& model, const Eigen::VectorXd& dead) {
  LinearProgram program;
  program.name = "static principle (5)";
  for (int i = 0; i < model.member_count(); ++i) {
    program.add_column({.lower = -model.yield(i), .upper = model.yield(i)});
  }
  const int factor = program.add_column({.cost = -1, .lower = -infinity});
  for (int k = 0; k < model.free_count(); ++k) {
    const LinearTerm term{factor, -model.reference(k)};
    program.add_row({.lower = dead(k), .upper = dead(k)}, std::span(&term, 1));
  }
  for (int i = 0; i < model.member_count(); ++i) {
    for (Eigen::SparseMatrix<double>::InnerIterator entry(model.equilibrium, i); entry; ++entry) {
      program.entries.push_back({static_cast<int>(entry.row()), i, entry.value()});
    }
  }
  return program;
}

LinearProgram kinematic_program(const LimitModel& model, const Eigen::VectorXd& dead) {
  LinearProgram program;
  program.name = "kinematic principle (15)";
  std::vector<LinearTerm> normalisation;
  for (int k = 0; k < model.free_count(); ++k) {
    const int motion = program.add_column({.cost = -dead(k), .lower = -infinity});
    normalisation.push_back({motion, model.reference(k)});
  }
  program.add_row({.lower = 1, .upper = 1}, normalisation);
  for (int i = 0; i < model.member_count(); ++i) {
    const int elongation = program.add_column({.cost = model.yield(i)});
    for (const double sign : {-1.0, 1.0}) {
      std::vector<LinearTerm> terms{{elongation, 1}};
      for (Eigen::SparseMatrix<double>::InnerIterator entry(model.equilibrium, i); entry; ++entry) {
        terms.push_back({static_cast<int>(entry.row()), sign * entry.value()});
      }
      program.add_row({.lower = 0}, terms);
    }
  }
  return program;
}

double kinematic_factor(const LimitModel& model, const Eigen::VectorXd& dead,
                        const Eigen::VectorXd& motion) {
  const Eigen::VectorXd elongation = model.equilibrium.transpose() * motion;
  return (model.yield.dot(elongation.cwiseAbs()) - dead.dot(motion)) / model.reference.dot(motion);
}

}  // namespace kusabi::problems
