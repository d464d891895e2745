// Mixed zero-one programs for tests of the tree: random ones of several kinds, and their optimum by
// enumeration of all binaries.
#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>
#include <random>
#include <string>
#include <vector>

#include "solvers/linear/linear_program.hpp"
#include "solvers/linear/simplex.hpp"

namespace kusabi::tests {

using linear::infinity;
using linear::LinearTerm;
using linear::MixedProgram;

/// The least objective over all values of the binaries, each by a linear program of its own; none
/// if infeasible. For at most 12 binaries or so.
inline std::optional<double> by_brute_force(const MixedProgram& mixed) {
  std::optional<double> best;
  for (std::uint64_t mask = 0; mask < (std::uint64_t{1} << mixed.binaries.size()); ++mask) {
    auto program = mixed.program;
    bool within = true;
    for (std::size_t k = 0; k < mixed.binaries.size(); ++k) {
      auto& column = program.columns[static_cast<std::size_t>(mixed.binaries[k])];
      const double value = ((mask >> k) & 1) != 0 ? 1 : 0;
      within = within && column.lower <= value && value <= column.upper;
      column.lower = column.upper = value;
    }
    if (!within) continue;
    linear::Simplex simplex(program);
    if (simplex.solve_primal() != linear::LinearStatus::optimal) continue;
    best = std::min(best.value_or(infinity), simplex.objective());
  }
  return best;
}

/// True if `values` satisfies the program, binaries exactly.
inline bool satisfies(const MixedProgram& mixed, const std::vector<double>& values,
                      double tolerance = 1e-6) {
  const auto& program = mixed.program;
  std::vector<double> activity(program.rows.size());
  for (const auto& [row, column, value] : program.entries) {
    activity[static_cast<std::size_t>(row)] += value * values[static_cast<std::size_t>(column)];
  }
  for (std::size_t i = 0; i < activity.size(); ++i) {
    if (activity[i] < program.rows[i].lower - tolerance) return false;
    if (activity[i] > program.rows[i].upper + tolerance) return false;
  }
  for (std::size_t j = 0; j < values.size(); ++j) {
    if (values[j] < program.columns[j].lower - tolerance) return false;
    if (values[j] > program.columns[j].upper + tolerance) return false;
  }
  return std::all_of(mixed.binaries.begin(), mixed.binaries.end(), [&](int column) {
    const double value = values[static_cast<std::size_t>(column)];
    return value == 0 || value == 1;
  });
}

/// Kinds: 0 knapsacks with several rows, 1 set covers, 2 flows with a charge for each arc in use,
/// 3 anything with continuous columns and equations, 4 the same without bounds of those columns.
inline MixedProgram random_mixed(unsigned seed, int kind, int binaries) {
  std::mt19937 draw(seed * 5 + static_cast<unsigned>(kind));
  const auto whole = [&](int from, int to) {
    return static_cast<double>(std::uniform_int_distribution<int>(from, to)(draw));
  };
  MixedProgram mixed;
  auto& program = mixed.program;
  for (int k = 0; k < binaries; ++k) {
    mixed.binaries.push_back(
        program.add_column({.cost = whole(kind == 1 ? 1 : -9, 9), .upper = 1}));
  }
  if (kind == 0) {
    for (int k = 0; k < binaries; ++k)
      program.columns[static_cast<std::size_t>(k)].cost = -whole(5, 40);
    for (int i = 0; i < 3; ++i) {
      std::vector<LinearTerm> terms;
      double sum = 0;
      for (int k = 0; k < binaries; ++k) {
        terms.push_back({k, whole(5, 40)});
        sum += terms.back().value;
      }
      program.add_row({.upper = std::floor(sum / 2)}, terms);
    }
  } else if (kind == 1) {
    for (int i = 0; i < 2 * binaries; ++i) {
      std::vector<LinearTerm> terms;
      for (int k = 0; k < binaries; ++k) {
        if (whole(0, 3) == 0) terms.push_back({k, 1});
      }
      if (!terms.empty()) program.add_row({.lower = 1}, terms);
    }
  } else if (kind == 2) {
    std::vector<LinearTerm> supply;
    for (int k = 0; k < binaries; ++k) {
      program.columns[static_cast<std::size_t>(k)].cost = whole(1, 20);
      const int flow = program.add_column({.cost = 0.25 * whole(1, 20)});
      program.add_row({.upper = 0}, {{{flow, 1}, {k, -whole(3, 12)}}});
      supply.push_back({flow, 1});
    }
    program.add_row({.lower = 2.0 * binaries, .upper = 2.0 * binaries}, supply);
  } else {
    for (int j = 0; j < binaries / 2; ++j) {
      program.add_column({.cost = 0.5 * whole(kind == 4 ? 0 : -9, 9),
                          .lower = kind == 4 ? 0 : -whole(0, 4),
                          .upper = kind == 4 ? infinity : whole(1, 6)});
    }
    for (int i = 0; i < binaries; ++i) {
      std::vector<LinearTerm> terms;
      double middle = 0;
      for (int j = 0; j < binaries + binaries / 2; ++j) {
        if (whole(0, 1) == 0) continue;
        terms.push_back({j, whole(-6, 6)});
        middle += terms.back().value * (whole(0, 2) / 2);
      }
      const bool equation = i < binaries / 6;
      program.add_row({.lower = equation ? middle : middle - 4, .upper = middle}, terms);
    }
  }
  return mixed;
}

}  // namespace kusabi::tests
