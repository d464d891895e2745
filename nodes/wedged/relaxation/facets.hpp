// Outer half of Algorithm 5.8 of the wedged paper: circumscribed polyhedral friction cones (19),
// and the bound of a node with these.
//
// The polyhedral cone has F facets, F even, which touch the friction cone at the angles 2 pi k / F;
// an inscribed cone needs twice as many facets. Its edges lie between them, at mu / cos(pi / F)
// from the normal. Two opposite edges span a friction cone of the plane, |s| <= mu rho / cos(pi /
// F), and the sum of all of these is the polyhedral cone. The linear program of a node is therefore
// a cone program of dimension 2 with F / 2 cones for each candidate, and the same solver brackets
// its value.
#pragma once

#include <span>

#include <Eigen/Core>

#include "solvers/conic/node_solver.hpp"

namespace kusabi::wedged {

/// Bounds the nodes of a contact problem in space with polyhedral friction.
class FacetBound {
 public:
  static constexpr int minimum = 4;
  static constexpr int maximum = 64;

  /// @param compliance F, 3m x 3m, scaled like that of conic::NodeSolver
  /// @param friction mu, m numbers: 0 or 1e-6 to 1e6
  /// @param facets F of each cone: even, `minimum` to `maximum`
  /// @param error of F: |F_ij - F*_ij| <= error sqrt(F*_ii F*_jj)
  /// @param motions G of an unconstrained body, 3m x p, and the error bound of its entries
  /// @throws std::invalid_argument when the sizes disagree or a number is out of range
  FacetBound(const Eigen::MatrixXd& compliance, std::span<const double> friction, int facets,
             conic::Tolerances tolerances, double error = 0, const Eigen::MatrixXd& motions = {},
             double motion_error = 0);

  /// The sign of t* under polyhedral friction. An infeasible node is infeasible with the friction
  /// cones themselves, since those are contained, with the same multipliers().
  /// `ignored`: see ContactSolver.
  conic::ConicResult solve(const support::IndexSet& contact, const support::IndexSet& separated,
                           conic::StopEarly stop, const support::IndexSet& ignored = {});

  /// r_n and u_n of a candidate at the last solved node.
  [[nodiscard]] double normal_reaction(int candidate) const;
  [[nodiscard]] double normal_displacement(int candidate) const;
  /// y, m, and beta: see ContactSolver.
  [[nodiscard]] Eigen::VectorXd multipliers() const;

 private:
  FacetBound(int facets, const Eigen::MatrixXd& spread, const Eigen::MatrixXd& compliance,
             std::span<const double> friction, conic::Tolerances tolerances, double error,
             const conic::Motions<double>& motions);

  int cones_each_;
  Eigen::MatrixXd combination_;  // T of the modes
  conic::NodeSolver<2> solver_;
};

}  // namespace kusabi::wedged
