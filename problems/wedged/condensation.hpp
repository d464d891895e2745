// From the whole structure to the contact candidates: K of equations (3) and (6) of the paper, and
// the compliance F = K^-1.
//
// The two are computed in different ways, so that K F = I is a check of both: K as the Schur
// complement through a factorisation of K_NN, F as the displacements of the contact nodes under
// unit loads on them, through a factorisation of the whole. No inverse is formed.
#pragma once

#include <optional>
#include <vector>

#include <Eigen/Core>
#include <Eigen/SparseCore>

namespace kusabi::problems {

struct CondensedMatrices {
  Eigen::MatrixXd stiffness;   ///< K, force/length
  Eigen::MatrixXd compliance;  ///< F, length/force
};

/// Condenses `stiffness` onto displacements in given directions at given places.
///
/// @param stiffness  symmetric, f x f, over the free displacements, force/length
/// @param places     c different numbers of free displacements: those of the contact nodes
/// @param directions c x c, orthogonal: column j is the j-th unit displacement, over `places`
/// @return K and F, c x c, in the coordinates of `directions`; symmetric up to rounding. Nothing if
///         a factorisation meets a pivot that is not positive
std::optional<CondensedMatrices> condense(const Eigen::SparseMatrix<double>& stiffness,
                                          const std::vector<int>& places,
                                          const Eigen::MatrixXd& directions);

}  // namespace kusabi::problems
