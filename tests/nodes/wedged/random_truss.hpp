// Random trusses with bars of very different stiffness, for tests of precision levels.
#pragma once

#include <cmath>
#include <random>
#include <set>
#include <string>
#include <utility>

#include "problems/structure/model/structure.hpp"
#include "problems/wedged/wedged_problem.hpp"
#include "support/input_error.hpp"

namespace kusabi::wedged::testing {

/// Parameters of a random truss.
struct TrussKind {
  int dimension = 2;
  int candidates = 3;
  int free_nodes = 5;    ///< including candidates
  double contrast = 1;   ///< of the stiffest and the softest bar
  double density = 0.7;  ///< share of the pairs of nodes that have a bar
};

/// A truss that may be a mechanism.
inline problems::Structure random_truss(const TrussKind& kind, std::mt19937_64& generator) {
  std::uniform_real_distribution<double> place(-1, 1), share(0, 1);
  const auto direction = [&] {
    Eigen::VectorXd vector(kind.dimension);
    do {
      for (double& entry : vector) entry = place(generator);
    } while (vector.norm() < 0.1 || vector.norm() > 1);
    return Eigen::VectorXd(vector.normalized());
  };
  problems::Structure structure;
  structure.name = "random";
  structure.dimension = kind.dimension;
  structure.units = {"m", "kN"};
  const int supports = kind.dimension + 1;
  const int nodes = kind.free_nodes + supports;
  structure.coordinates.resize(kind.dimension, nodes);
  for (int node = 0; node < nodes; ++node) {
    structure.node_names.push_back("n" + std::to_string(node));
    const bool held = node >= kind.free_nodes;
    structure.fixed.push_back({held, held, held});
    for (int axis = 0; axis < kind.dimension; ++axis)
      structure.coordinates(axis, node) = 2 * place(generator);
  }
  for (int a = 0; a < kind.free_nodes; ++a)
    for (int b = a + 1; b < nodes; ++b) {
      if (share(generator) > kind.density) continue;
      structure.members.push_back({a, b, std::pow(kind.contrast, share(generator)), {}});
    }
  for (int node = 0; node < kind.candidates; ++node)
    structure.contact.push_back({node, direction(), std::nullopt, 1.0});
  return structure;
}

/// A truss that is stable.
inline std::pair<problems::Structure, problems::WedgedProblem> random_problem(
    const TrussKind& kind, std::mt19937_64& generator) {
  for (;;) {
    problems::Structure structure = random_truss(kind, generator);
    try {
      problems::WedgedProblem problem = problems::wedged_problem(checked(structure));
      if (problem.modes.matrix.cols() > 0) continue;  // unconstrained
      return {std::move(structure), std::move(problem)};
    } catch (const support::InputError&) {
      continue;  // a mechanism, or a normal out of the body
    }
  }
}

}  // namespace kusabi::wedged::testing
