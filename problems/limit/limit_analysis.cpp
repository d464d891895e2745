// Scaled, symmetric form and its two linear programs.
#include "problems/limit/limit_analysis.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>

namespace kusabi::problems {
namespace {

/// A smaller cosine, or a smaller share of the largest component of a load at the same node, is
/// zero: the rounding error of cos(pi / 2) is 6e-17.
constexpr double noise = 1e-14;

// Without the cosines of B that are rounding errors.
Eigen::SparseMatrix<double> without_noise(Eigen::SparseMatrix<double> equilibrium) {
  equilibrium.prune(
      [](Eigen::Index, Eigen::Index, double value) { return std::abs(value) > noise; });
  return equilibrium;
}

// Without the components that are rounding errors of the direction of a force. Where a displacement
// is not free, the component along it is unknown and may be as large as any.
Eigen::VectorXd without_noise(const LimitProblem& problem, const Eigen::VectorXd& load) {
  const double largest = load.size() == 0 ? 0 : load.cwiseAbs().maxCoeff();
  Eigen::VectorXd result = load;
  for (int degree = 0; degree < problem.free_count(); ++degree) {
    const auto node = problem.degrees.free[static_cast<std::size_t>(degree)].node;
    double size = 0;
    for (const int other : problem.degrees.number.col(node))
      size = std::max(size, other < 0 ? largest : std::abs(load(other)));
    if (std::abs(load(degree)) <= noise * size) result(degree) = 0;
  }
  return result;
}

/// Unit of force for numbers of a given size: F unless they are much smaller. Units within a factor
/// of `alike` are equal, so that the program resembles its truss; the others are F times a power
/// of two.
double unit_of(double size, double force_unit) {
  constexpr double alike = 8;
  if (size > force_unit / alike) return force_unit;
  int exponent = 0;
  std::frexp(size / force_unit, &exponent);
  return std::ldexp(force_unit, exponent - 1);
}

// Half-widths become part of the weights of a model's columns.
std::vector<UncertainColumn> of_one_width(std::vector<UncertainColumn> columns) {
  for (auto& column : columns) {
    column.weight = column.reach();
    column.half_width = 1;
  }
  return columns;
}

// T~ = F Y^-1 T; the weights are the sizes of its columns. @param row_unit Y
void scale_uncertain(const LimitProblem& problem, const Eigen::VectorXd& row_unit,
                     LimitModel& model) {
  model.uncertain = of_one_width(problem.uncertain);
  model.direction_unit.resize(problem.uncertain_count());
  for (int j = 0; j < problem.uncertain_count(); ++j) {
    auto& column = model.uncertain[static_cast<std::size_t>(j)];
    double maximum = 0;
    for (auto& [degree, value] : column.direction) {
      value *= model.force_unit / row_unit(degree);
      maximum = std::max(maximum, std::abs(value));
    }
    for (auto& component : column.direction) component.value /= maximum;
    std::erase_if(column.direction,
                  [](const auto& component) { return std::abs(component.value) <= noise; });
    column.weight *= maximum;
    model.direction_unit(j) = model.force_unit / maximum;
  }
}

}  // namespace

LimitModel limit_model(const LimitProblem& problem, double force_unit, double max_yield) {
  LimitModel model;
  model.force_unit = force_unit;
  model.max_yield = max_yield;
  const Eigen::VectorXd yield = (problem.tension + problem.compression) / 2;
  model.member_unit = yield.unaryExpr([&](double size) { return unit_of(size, force_unit); });
  model.tension = problem.tension.cwiseQuotient(model.member_unit).cwiseMin(max_yield);
  model.compression = problem.compression.cwiseQuotient(model.member_unit).cwiseMin(max_yield);

  const auto given = without_noise(problem.equilibrium);
  const Eigen::VectorXd reference = without_noise(problem, problem.reference);
  Eigen::VectorXd largest = Eigen::VectorXd::Zero(given.rows());  // Y
  for (int i = 0; i < given.cols(); ++i) {
    for (Eigen::SparseMatrix<double>::InnerIterator entry(given, i); entry; ++entry) {
      double& maximum = largest(entry.row());
      maximum = std::max(maximum, std::abs(entry.value()) * model.member_unit(i));
    }
  }
  const Eigen::VectorXd row_unit =
      largest.unaryExpr([&](double maximum) { return unit_of(maximum, force_unit); });
  const double reference_unit = reference.cwiseAbs().cwiseQuotient(row_unit).maxCoeff();  // R
  model.displacement_unit = (reference_unit * row_unit).cwiseInverse();
  model.factor_unit = 1 / reference_unit;
  model.equilibrium = row_unit.cwiseInverse().asDiagonal() * given * model.member_unit.asDiagonal();
  model.dead = without_noise(problem, problem.dead).cwiseQuotient(row_unit);
  model.reference = reference.cwiseQuotient(row_unit) / reference_unit;
  scale_uncertain(problem, row_unit, model);
  return model;
}

LimitModel limit_model(const LimitProblem& problem) {
  Eigen::VectorXd yield = (problem.tension + problem.compression) / 2;
  const auto middle = yield.begin() + yield.size() / 2;
  std::nth_element(yield.begin(), middle, yield.end());
  return limit_model(problem, *middle);
}

LimitModel unscaled_model(const LimitProblem& problem) {
  LimitModel model;
  model.equilibrium = problem.equilibrium;
  model.dead = problem.dead;
  model.reference = problem.reference;
  model.tension = problem.tension;
  model.compression = problem.compression;
  model.uncertain = of_one_width(problem.uncertain);
  model.member_unit = Eigen::VectorXd::Ones(problem.member_count());
  model.displacement_unit = Eigen::VectorXd::Ones(problem.free_count());
  model.direction_unit = Eigen::VectorXd::Ones(problem.uncertain_count());
  model.max_yield = linear::infinity;
  return model;
}

Eigen::VectorXd dead_load(const LimitModel& model, const Eigen::VectorXd& zeta) {
  Eigen::VectorXd load = model.dead;
  for (int j = 0; j < model.uncertain_count(); ++j) {
    model.uncertain[static_cast<std::size_t>(j)].add_to(load, zeta(j));
  }
  return load;
}

Eigen::VectorXd forces_in_units(const LimitModel& model, const Eigen::VectorXd& forces) {
  return forces.cwiseProduct(model.member_unit);
}

Eigen::VectorXd motion_in_units(const LimitModel& model, const Eigen::VectorXd& motion) {
  return motion.cwiseProduct(model.displacement_unit);
}

linear::LinearProgram static_program(const LimitModel& model, const Eigen::VectorXd& dead) {
  linear::LinearProgram program;
  program.name = "static principle (5)";
  for (int i = 0; i < model.member_count(); ++i) {
    program.add_column({.lower = -model.compression(i), .upper = model.tension(i)});
  }
  const int factor = program.add_column({.cost = -1, .lower = -linear::infinity});
  for (int k = 0; k < model.free_count(); ++k) {
    const linear::LinearTerm term{factor, -model.reference(k)};
    program.add_row({.lower = dead(k), .upper = dead(k)}, std::span(&term, 1));
  }
  for (int i = 0; i < model.member_count(); ++i) {
    for (Eigen::SparseMatrix<double>::InnerIterator entry(model.equilibrium, i); entry; ++entry) {
      program.entries.push_back({static_cast<int>(entry.row()), i, entry.value()});
    }
  }
  return program;
}

linear::LinearProgram kinematic_program(const LimitModel& model, const Eigen::VectorXd& dead) {
  linear::LinearProgram program;
  program.name = "kinematic principle (15)";
  std::vector<linear::LinearTerm> normalisation;
  const Eigen::VectorXd yield = model.yield();
  const Eigen::VectorXd shift = (model.tension - model.compression) / 2;
  const Eigen::VectorXd load = dead - model.equilibrium * shift;
  for (int k = 0; k < model.free_count(); ++k) {
    const int motion = program.add_column({.cost = -load(k), .lower = -linear::infinity});
    normalisation.push_back({motion, model.reference(k)});
  }
  program.add_row({.lower = 1, .upper = 1}, normalisation);
  for (int i = 0; i < model.member_count(); ++i) {
    const int elongation = program.add_column({.cost = yield(i)});
    for (const double sign : {-1.0, 1.0}) {
      std::vector<linear::LinearTerm> terms{{elongation, 1}};
      for (Eigen::SparseMatrix<double>::InnerIterator entry(model.equilibrium, i); entry; ++entry) {
        terms.push_back({static_cast<int>(entry.row()), sign * entry.value()});
      }
      program.add_row({.lower = 0}, terms);
    }
  }
  return program;
}

}  // namespace kusabi::problems
