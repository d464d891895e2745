// Whole structure in a wedged configuration: the displacements of all nodes and the reactions of
// the supports, (4) and (5) of the wedged paper.
#pragma once

#include <span>
#include <vector>

#include <Eigen/Core>
#include <Eigen/QR>

#include "problems/structure/checks/checked_structure.hpp"
#include "problems/wedged/wedged_problem.hpp"

namespace kusabi::problems {

/// State of the whole structure, in global axes.
struct WholeState {
  Eigen::MatrixXd displacements;  ///< u_C and u_N, d x nodes, length; zero where fixed
  /// r_D of the supports and forces of springs on the structure, d x nodes, force; zero where free
  Eigen::MatrixXd reactions;
  Eigen::VectorXd axial_forces;  ///< of the members, in their order, force; positive in tension
  /// Error of the equilibrium between the reactions of the obstacle and of the supports: the
  /// largest component of their resultant or of their moment (divided by the size of the
  /// structure), relative to the sum of their sizes, of which those of one node may cancel.
  double imbalance = 0;
};

/// Linear functions of the contact reactions, as matrices computed in 104 bits. The rigid-body
/// displacements of unconstrained bodies follow from the displacements of their candidates.
class WholeStructure {
 public:
  /// @param problem made by `wedged_problem` from the structure
  WholeStructure(const CheckedStructure& structure, const WedgedProblem& problem);

  /// @param reactions r, dm, in the frame of each candidate, in equilibrium on unconstrained bodies
  /// @param displacements u, dm, likewise; required for unconstrained bodies only
  [[nodiscard]] WholeState under(std::span<const double> reactions,
                                 std::span<const double> displacements = {}) const;

  /// The contact forces on the nodes: d x nodes, global axes.
  /// @param reactions as above
  [[nodiscard]] Eigen::MatrixXd contact_forces(std::span<const double> reactions) const;

  /// True if a support or a spring acts on the node along any axis.
  [[nodiscard]] bool is_supported(int node) const;

 private:
  void set_reactions(const Structure& structure, const numbers::PreciseMatrix& displacements,
                     const numbers::PreciseMatrix& internal_unknowns);
  void set_motions(const CheckedStructure& structure, const WedgedProblem& problem);
  /// @param forces on the nodes, d x nodes  @param sizes sum of the components of all reactions
  [[nodiscard]] double imbalance(const Eigen::MatrixXd& forces, double sizes) const;

  int dimension_;
  Eigen::MatrixXd coordinates_;     // d x nodes
  Eigen::MatrixXd displacements_;   // (d nodes) x dm, node by node
  Eigen::MatrixXd support_forces_;  // (d nodes) x dm: r_D
  Eigen::MatrixXd contact_forces_;  // (d nodes) x dm: contact forces
  Eigen::MatrixXd axial_forces_;    // members x dm
  std::vector<bool> supported_;     // by node
  // For unconstrained bodies: all modes, (d nodes) x P, their restriction to contact degrees of
  // freedom, dm x P; and F.
  Eigen::MatrixXd motions_;
  Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> restricted_modes_;
  Eigen::MatrixXd compliance_;
};

}  // namespace kusabi::problems
