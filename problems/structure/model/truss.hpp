// The stiffness of a truss over the displacements that its supports leave free: the part
// [K_CC K_CN; K_NC K_NN] of K^0 in equation (2) of the paper.
#pragma once

#include <vector>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include "problems/structure/model/structure.hpp"
#include "support/numbers/precise.hpp"

namespace kusabi::problems {

/// A displacement of one node along one axis.
struct DegreeOfFreedom {
  int node;
  int axis;
};

/// A free displacement that has a share in another one.
struct Leader {
  int number;
  numbers::Precise weight;  ///< right to 104 bits
};

/// The free displacements of a structure, node by node and axis by axis, and after them the
/// unknowns that superelements have of their own. Those of a candidate against another body are
/// relative to it.
struct FreeDegrees {
  std::vector<DegreeOfFreedom> free;  ///< number -> node and axis, of all that are of a node
  /// d x nodes: node and axis -> number, or -1 if fixed or made of others alone.
  Eigen::MatrixXi number;
  /// By d * node + axis, or empty if there are none: what the displacement has besides the free one
  /// of its own number (problems/structure/model/constraints.hpp).
  std::vector<std::vector<Leader>> leaders{};
  /// By superelement and row: the number of an unknown of its own, or -1 for those of nodes.
  std::vector<std::vector<int>> own_unknowns{};
  int own_count = 0;  ///< how many of these there are

  int of_nodes() const { return static_cast<int>(free.size()); }
  int size() const { return of_nodes() + own_count; }
};

FreeDegrees free_degrees(const Structure& structure);

/// EA / L of each member, force/length.
Eigen::VectorXd member_stiffnesses(const Structure& structure);

/// Sum over the members of k_e b_e b_e^T, where b_e^T u is the elongation of member e: the whole
/// symmetric matrix, over the free displacements, symmetric to the last bit where no displacement
/// is made of others.
/// @param member_stiffness k, one a member; `member_stiffnesses` gives the true one
Eigen::SparseMatrix<double> truss_stiffness(const Structure& structure, const FreeDegrees& degrees,
                                            const Eigen::VectorXd& member_stiffness);

/// B of the limit paper's (1): column e is b_e, so B q is the load that the axial forces q carry.
/// Free displacements x members.
Eigen::SparseMatrix<double> equilibrium_matrix(const Structure& structure,
                                               const FreeDegrees& degrees);

/// Elongation b_e^T u of each member under the free displacements u.
Eigen::VectorXd elongations(const Structure& structure, const FreeDegrees& degrees,
                            const Eigen::VectorXd& displacement);

}  // namespace kusabi::problems
