// From a structure to B, f_D, f_R, T and the yield forces.
#include "problems/limit/limit_problem.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>

#include <fmt/format.h>

#include "problems/structure/mechanism.hpp"
#include "problems/structure/structure_check.hpp"
#include "support/fingerprint.hpp"

namespace kusabi::problems {
namespace {

support::SourcePosition top_of(const Structure& structure) {
  return structure.sources.file.empty() ? support::SourcePosition{} : support::SourcePosition{1, 1};
}

void require_bars_with_yield_and_reference(const Structure& structure) {
  if (!structure.elements.empty()) {
    throw structure_error(structure, position_of(structure.sources.elements, 0),
                          "a plane element has no yield force; expected a truss: limit analysis is "
                          "for bars only");
  }
  for (std::size_t index = 0; index < structure.members.size(); ++index) {
    if (structure.members[index].yield) continue;
    throw structure_error(
        structure, position_of(structure.sources.yields, static_cast<int>(index)),
        "a [[members]] group has no yield; expected yield = axial force at which it yields");
  }
  const bool any = std::ranges::any_of(
      structure.loads, [](const Load& load) { return load.kind == Load::Kind::reference; });
  if (!any) {
    throw structure_error(structure, top_of(structure),
                          "no reference load; expected a [[loads]] group of kind \"reference\", "
                          "which the load factor multiplies");
  }
}

/// The loads of one kind on the free displacements; those on supports go straight to the ground.
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

std::vector<UncertainColumn> given_columns(const Structure& structure,
                                           const LimitProblem& problem) {
  std::vector<UncertainColumn> columns;
  for (std::size_t index = 0; index < structure.uncertain->size(); ++index) {
    const auto& [node, axis, weight] = (*structure.uncertain)[index];
    const int degree = problem.degrees.number(axis, node);
    if (problem.reference(degree) != 0) {
      throw structure_error(
          structure, position_of(structure.sources.uncertain, static_cast<int>(index)),
          fmt::format("component {} of the load at {} is uncertain and carries reference load; "
                      "expected one or the other (assumption 3.1)",
                      axis_name(axis),
                      support::in_quotes(structure.node_names[static_cast<std::size_t>(node)])));
    }
    columns.push_back({degree, weight});
  }
  return columns;
}

std::vector<UncertainColumn> default_columns(const LimitProblem& problem) {
  std::vector<UncertainColumn> columns;
  for (int degree = 0; degree < problem.free_count(); ++degree) {
    if (problem.dead(degree) == 0 && problem.reference(degree) == 0) columns.push_back({degree, 1});
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
    result.add(column.degree);
    result.add(column.weight);
  }
  return result.value();
}

}  // namespace

std::string member_name(const LimitProblem& problem, int member) {
  const Member& bar = problem.members[static_cast<std::size_t>(member)];
  return fmt::format("{}-{}", problem.node_names[static_cast<std::size_t>(bar.first)],
                     problem.node_names[static_cast<std::size_t>(bar.second)]);
}

Eigen::VectorXd dead_load(const LimitProblem& problem, const Eigen::VectorXd& zeta) {
  Eigen::VectorXd load = problem.dead;
  for (int j = 0; j < problem.uncertain_count(); ++j) {
    const auto& [degree, weight] = problem.uncertain[static_cast<std::size_t>(j)];
    load(degree) += weight * zeta(j);
  }
  return load;
}

LimitProblem limit_problem(const Structure& structure) {
  check_structure(structure);
  require_bars_with_yield_and_reference(structure);
  LimitProblem problem;
  problem.name = structure.name;
  problem.dimension = structure.dimension;
  problem.units = structure.units;
  problem.node_names = structure.node_names;
  problem.members = structure.members;
  problem.degrees = free_degrees(structure);
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
      structure.uncertain ? given_columns(structure, problem) : default_columns(problem);
  std::ranges::sort(problem.uncertain, {}, [&](const UncertainColumn& column) {
    const auto& [node, axis] = problem.degrees.free[static_cast<std::size_t>(column.degree)];
    return std::pair(axis, node);
  });
  problem.fingerprint = fingerprint(problem);
  return problem;
}

}  // namespace kusabi::problems
