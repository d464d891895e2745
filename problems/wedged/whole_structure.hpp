// From the reactions of the obstacle back to the whole structure: the displacements of all nodes
// and the reactions of the supports, (4) and (5) of the wedged paper.
#pragma once

#include <span>
#include <vector>

#include <Eigen/Core>
#include <Eigen/QR>

#include "problems/structure/model/structure.hpp"
#include "problems/wedged/wedged_problem.hpp"

namespace kusabi::problems {

/// What a wedged configuration does to the whole structure, in global axes.
struct WholeState {
  Eigen::MatrixXd displacements;  ///< u_C and u_N, d x nodes, length; zero where fixed
  /// r_D of the supports, and what springs push with, d x nodes, force; zero where free
  Eigen::MatrixXd reactions;
  Eigen::VectorXd axial_forces;  ///< of the members, in their order, force; positive in tension
  /// How far the reactions of the obstacle and of the supports are from equilibrium: the largest
  /// component of their resultant or of their moment (divided by the size of the structure),
  /// relative to the sum of their sizes.
  double imbalance = 0;
};

/// All depend linearly on the reactions of the obstacle: matrices, computed in 104 bits. Where
/// loose bodies have gone is told by the displacements of their candidates.
class WholeStructure {
 public:
  /// @param problem of the structure, made by `wedged_problem`
  WholeStructure(const Structure& structure, const WedgedProblem& problem);

  /// @param reactions r, dm, in the frame of each candidate, in equilibrium for loose bodies
  /// @param displacements u, dm, likewise; only loose bodies ask for them
  [[nodiscard]] WholeState under(std::span<const double> reactions,
                                 std::span<const double> displacements = {}) const;

  /// The forces of the obstacle, or of the other bodies, on the nodes: d x nodes, global axes.
  /// @param reactions as above
  [[nodiscard]] Eigen::MatrixXd contact_forces(std::span<const double> reactions) const;

  /// Whether a support or a spring holds the node along any axis.
  [[nodiscard]] bool is_supported(int node) const;

 private:
  void set_reactions(const Structure& structure, const numbers::PreciseMatrix& displacements,
                     const numbers::PreciseMatrix& own_unknowns);
  void set_motions(const Structure& structure, const WedgedProblem& problem);
  [[nodiscard]] double imbalance(const Eigen::MatrixXd& forces) const;

  int dimension_;
  Eigen::MatrixXd coordinates_;     // d x nodes
  Eigen::MatrixXd displacements_;   // (d nodes) x dm, node by node
  Eigen::MatrixXd support_forces_;  // (d nodes) x dm: r_D
  Eigen::MatrixXd contact_forces_;  // (d nodes) x dm: of the obstacle, or of the other body
  Eigen::MatrixXd axial_forces_;    // members x dm
  std::vector<bool> supported_;     // by node
  // Of loose bodies: all motions, (d nodes) x P, and what the candidates see of them, dm x P; F.
  Eigen::MatrixXd motions_;
  Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> seen_;
  Eigen::MatrixXd compliance_;
};

}  // namespace kusabi::problems
