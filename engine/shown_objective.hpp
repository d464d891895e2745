// ShownObjective: conversion of the objective of a search to the user's units, for display.
#pragma once

#include <limits>

namespace kusabi::engine {

/// Objective and bound in the user's units, for a search with internal units.
struct ShownObjective {
  double unit = 1;  ///< user's units per internal unit; negative: the user maximises
  /// Bounds of the optimum known apart from the search, in internal units.
  double upper = std::numeric_limits<double>::infinity();
  double lower = -std::numeric_limits<double>::infinity();
};

}  // namespace kusabi::engine
