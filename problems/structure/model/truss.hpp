// Stiffness of a truss over its free displacements: the part [K_CC K_CN; K_NC K_NN] of K^0 in
// equation (2) of the paper.
#pragma once

#include <set>
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

/// A master degree of freedom of a dependent displacement, with its weight.
struct MasterDegree {
  int number;
  numbers::Precise weight;  ///< accurate to 104 bits
};

/// The free displacements of a structure, by nodes and axes, then the internal unknowns of
/// superelements. Those of a candidate against another body are relative to it.
struct FreeDegrees {
  std::vector<DegreeOfFreedom> free;  ///< number -> node and axis, of displacements of nodes
  /// d x nodes: node and axis -> number, or -1 if fixed or dependent.
  Eigen::MatrixXi number;
  /// By d * node + axis, or empty if there are none: masters of the displacement besides the free
  /// one of its own number (problems/structure/model/constraints.hpp).
  std::vector<std::vector<MasterDegree>> master_degrees{};
  /// By superelement and row: the number of an internal unknown, or -1 for displacements of nodes.
  std::vector<std::vector<int>> internal_unknowns{};
  int internal_count = 0;  ///< number of internal unknowns
  /// The nodes with more than one contact candidate (problems/structure/model/several_normals.hpp).
  std::set<int> several_normals{};

  int of_nodes() const { return static_cast<int>(free.size()); }
  int size() const { return of_nodes() + internal_count; }
};

/// `CheckedStructure::degrees` are those of a structure that was checked.
FreeDegrees free_degrees(const Structure& structure);

/// EA / L of each member, force/length.
Eigen::VectorXd member_stiffnesses(const Structure& structure);

/// Sum over the members of k_e b_e b_e^T, where b_e^T u is the elongation of member e: the whole
/// symmetric matrix over the free displacements, exactly symmetric where no displacement is
/// dependent.
/// @param member_stiffness k of each member; `member_stiffnesses` computes the actual values
Eigen::SparseMatrix<double> truss_stiffness(const Structure& structure, const FreeDegrees& degrees,
                                            const Eigen::VectorXd& member_stiffness);

/// B of the limit paper's (1): column e is b_e, so B q is the load in equilibrium with the axial
/// forces q. Free displacements x members.
Eigen::SparseMatrix<double> equilibrium_matrix(const Structure& structure,
                                               const FreeDegrees& degrees);

/// Elongation b_e^T u of each member for the free displacements u.
Eigen::VectorXd elongations(const Structure& structure, const FreeDegrees& degrees,
                            const Eigen::VectorXd& displacement);

}  // namespace kusabi::problems
