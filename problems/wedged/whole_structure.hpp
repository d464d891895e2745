// From the reactions of the obstacle back to the whole structure: the displacements of all nodes
// and the reactions of the supports, (4) and (5) of the wedged paper.
#pragma once

#include <span>
#include <vector>

#include <Eigen/Core>

#include "problems/structure/structure.hpp"
#include "problems/wedged/wedged_problem.hpp"

namespace kusabi::problems {

/// What a wedged configuration does to the whole structure, in global axes.
struct WholeState {
  Eigen::MatrixXd displacements;  ///< u_C and u_N, d x nodes, length; zero where fixed
  Eigen::MatrixXd reactions;      ///< r_D of the supports, d x nodes, force; zero where free
  /// How far the reactions of the obstacle and of the supports are from equilibrium: the largest
  /// component of their resultant or of their moment (divided by the size of the structure),
  /// relative to the sum of their sizes.
  double imbalance = 0;
};

/// Both depend linearly on the reactions of the obstacle: two matrices, computed in 104 bits.
class WholeStructure {
 public:
  /// @param problem of the structure, made by `wedged_problem`
  WholeStructure(const Structure& structure, const WedgedProblem& problem);

  /// @param reactions r, dm, in the frame of each candidate
  [[nodiscard]] WholeState under(std::span<const double> reactions) const;

  /// Whether a support holds the node along any axis.
  [[nodiscard]] bool is_supported(int node) const;

 private:
  [[nodiscard]] double imbalance(const Eigen::MatrixXd& forces) const;

  int dimension_;
  Eigen::MatrixXd coordinates_;      // d x nodes
  Eigen::MatrixXd displacements_;    // (d nodes) x dm, node by node
  Eigen::MatrixXd internal_forces_;  // (d nodes) x dm: K^0 times these, at supports alone
  Eigen::MatrixXd contact_forces_;   // (d nodes) x dm: of the obstacle, in global axes
  std::vector<bool> supported_;      // by node
};

}  // namespace kusabi::problems
