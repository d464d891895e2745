// B, f_D, f_R, T and the yield forces of a structure.
#include "problems/limit/limit_problem.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include <fmt/format.h>

#include "problems/structure/bodies/mechanism.hpp"
#include "problems/structure/model/constraints.hpp"
#include "problems/structure/model/load_cases.hpp"
#include "support/fingerprint.hpp"

namespace kusabi::problems {
namespace {

support::SourcePosition top_of(const Structure& structure) {
  return structure.sources.file.empty() ? support::SourcePosition{} : support::SourcePosition{1, 1};
}

void require_bars_with_yield_and_reference(const Structure& structure) {
  if (!structure.elements.empty()) {
    throw structure_error(structure, position_of(structure.sources.elements, 0),
                          "an element has no yield force; expected a truss: limit analysis is "
                          "for bars only");
  }
  if (has_constraints(structure)) {
    throw structure_error(
        structure, top_of(structure),
        "limit analysis does not support pairs of bodies, ties and inclined supports; "
        "expected supports along axes and bars only");
  }
  if (!structure.springs.empty()) {
    throw structure_error(structure, position_of(structure.sources.springs, 0),
                          "a spring has no yield force; expected supports: limit analysis is for "
                          "bars only");
  }
  if (!structure.superelements.empty()) {
    throw structure_error(structure, position_of(structure.sources.superelements, 0),
                          "a stiffness of another program has no yield force; expected a truss: "
                          "limit analysis is for bars only");
  }
  for (std::size_t index = 0; index < structure.members.size(); ++index) {
    if (structure.members[index].yield) continue;
    throw structure_error(
        structure, position_of(structure.sources.yields, static_cast<int>(index)),
        "a [[members]] group has no yield; expected yield = axial force at which it yields, or "
        "fy and A");
  }
  if (!load_cases(structure).empty()) {
    throw structure_error(structure, top_of(structure),
                          fmt::format("the loads belong to several load cases, and a limit load "
                                      "to one; expected --case with one of {}",
                                      choice_of_load_cases(structure)));
  }
  const bool any = std::ranges::any_of(
      structure.loads, [](const Load& load) { return load.kind == Load::Kind::reference; });
  if (!any) {
    throw structure_error(structure, top_of(structure),
                          "no reference load; expected a [[loads]] group of kind \"reference\", "
                          "which the load factor multiplies");
  }
}

/// The loads of one kind on the free displacements; loads on supports act on the ground.
Eigen::VectorXd load_vector(const Structure& structure, const FreeDegrees& degrees,
                            Load::Kind kind) {
  Eigen::VectorXd load = Eigen::VectorXd::Zero(degrees.size());
  for (const Load& each : structure.loads) {
    if (each.kind != kind) continue;
    for (int axis = 0; axis < structure.dimension; ++axis) {
      const int degree = degrees.number(axis, each.node);
      if (degree >= 0) load(degree) += each.force(axis);
    }
  }
  return load;
}

void require_free_reference(const Structure& structure, const LimitProblem& problem) {
  if (!problem.reference.isZero(0.0)) return;
  std::size_t first = 0;
  while (structure.loads[first].kind != Load::Kind::reference) ++first;
  throw structure_error(
      structure, position_of(structure.sources.loads, static_cast<int>(first)),
      "the reference load f_R is zero wherever the structure can move, so its load factor is "
      "unbounded; expected a reference load at a node and along an axis that are free");
}

// Loads on a support act on the ground.
UncertainColumn column_of(const UncertainParameter& parameter, const FreeDegrees& degrees) {
  std::vector<UncertainColumn::Component> free;
  for (const auto& [node, axis, weight] : parameter.components) {
    const int degree = degrees.number(axis, node);
    if (degree >= 0) free.push_back({degree, weight});
  }
  std::ranges::sort(free, {}, &UncertainColumn::Component::degree);
  auto column = free.size() == 1 ? UncertainColumn::single(free[0].degree, free[0].value)
                                 : UncertainColumn{.direction = std::move(free)};
  column.name = parameter.name;
  column.group = parameter.group;
  column.half_width = parameter.half_width.value_or(1);
  column.in_file = parameter.half_width.has_value();
  return column;
}

std::vector<UncertainColumn> given_columns(const Structure& structure,
                                           const LimitProblem& problem) {
  std::vector<UncertainColumn> columns;
  for (const UncertainParameter& parameter : *structure.uncertain) {
    columns.push_back(column_of(parameter, problem.degrees));
  }
  return columns;
}

std::vector<UncertainColumn> default_columns(const LimitProblem& problem) {
  std::vector<UncertainColumn> columns;
  for (int degree = 0; degree < problem.free_count(); ++degree) {
    if (problem.dead(degree) == 0 && problem.reference(degree) == 0) {
      columns.push_back(UncertainColumn::single(degree, 1));
    }
  }
  return columns;
}

std::uint64_t fingerprint(const LimitProblem& problem) {
  support::Fingerprint result;
  result.add(problem.dimension);
  result.add(problem.units.length);
  result.add(problem.units.force);
  result.add(problem.free_count());
  result.add(problem.member_count());
  for (int member = 0; member < problem.member_count(); ++member) {
    for (Eigen::SparseMatrix<double>::InnerIterator entry(problem.equilibrium, member); entry;
         ++entry) {
      result.add(static_cast<int>(entry.row()));
      result.add(entry.value());
    }
  }
  for (const auto* vector :
       {&problem.dead, &problem.reference, &problem.tension, &problem.compression}) {
    for (const double value : *vector) result.add(value);
  }
  for (const UncertainColumn& column : problem.uncertain) {
    // A negative number, which no displacement has, so that fingerprints of single components are
    // unchanged.
    if (column.direction.size() > 1) result.add(-static_cast<int>(column.direction.size()));
    for (const auto& [degree, value] : column.direction) {
      result.add(degree);
      result.add(column.weight * value);
    }
    if (column.in_file) {
      result.add(-1);  // differs from all counts of components
      result.add(column.half_width);
    }
  }
  return result.value();
}

}  // namespace

std::string member_name(const LimitProblem& problem, int member) {
  const Member& bar = problem.members[static_cast<std::size_t>(member)];
  return fmt::format("{}-{}", problem.node_names[static_cast<std::size_t>(bar.first)],
                     problem.node_names[static_cast<std::size_t>(bar.second)]);
}

std::string parameter_name(const LimitProblem& problem, int column) {
  const auto& given = problem.uncertain[static_cast<std::size_t>(column)];
  if (!given.name.empty()) return given.name;
  const auto& [node, axis] =
      problem.degrees.free[static_cast<std::size_t>(given.direction.front().degree)];
  return fmt::format("{} at {}", axis_name(axis),
                     problem.node_names[static_cast<std::size_t>(node)]);
}

bool works_with_reference(const LimitProblem& problem, const UncertainColumn& column) {
  double sizes = 0;
  for (const auto& [degree, value] : column.direction) {
    sizes += std::abs(value * problem.reference(degree));
  }
  return std::abs(column.along(problem.reference)) > no_reference_work * sizes;
}

bool alpha_is_force(const LimitProblem& problem) {
  return std::ranges::all_of(problem.uncertain, [](const UncertainColumn& column) {
    return column.direction.size() == 1 && column.weight == 1;
  });
}

Eigen::VectorXd dead_load(const LimitProblem& problem, const Eigen::VectorXd& shares) {
  Eigen::VectorXd load = problem.dead;
  for (int j = 0; j < problem.uncertain_count(); ++j) {
    problem.uncertain[static_cast<std::size_t>(j)].add_to(load, shares(j));
  }
  return load;
}

LimitProblem limit_problem(const CheckedStructure& structure) {
  require_bars_with_yield_and_reference(structure);
  LimitProblem problem;
  problem.name = structure->name;
  problem.dimension = structure->dimension;
  problem.units = structure->units;
  problem.node_names = structure->node_names;
  problem.members = structure->members;
  problem.degrees = structure.degrees();
  problem.dead = load_vector(structure, problem.degrees, Load::Kind::dead);
  problem.reference = load_vector(structure, problem.degrees, Load::Kind::reference);
  require_free_reference(structure, problem);
  refuse_mechanism(structure, problem.degrees);
  problem.equilibrium = equilibrium_matrix(structure, problem.degrees);
  problem.tension.resize(problem.member_count());
  problem.compression.resize(problem.member_count());
  for (int member = 0; member < problem.member_count(); ++member) {
    const auto& yield = *problem.members[static_cast<std::size_t>(member)].yield;
    problem.tension(member) = yield.tension;
    problem.compression(member) = yield.compression;
  }
  problem.uncertain =
      structure->uncertain ? given_columns(structure, problem) : default_columns(problem);
  std::ranges::stable_sort(problem.uncertain, {}, [&](const UncertainColumn& column) {
    const auto first = static_cast<std::size_t>(column.direction.front().degree);
    const auto& [node, axis] = problem.degrees.free[first];
    return std::pair(axis, node);
  });
  problem.fingerprint = fingerprint(problem);
  return problem;
}

}  // namespace kusabi::problems
