// The stiffness of an isoparametric element of any shape, of an isotropic material: plane stress
// and plane strain with a thickness, or in space.
//
//   K_e = sum_g w_g |det J_g| t B_g^T D B_g, which is block (a, b) =
//   lambda H_ab + mu (H_ab^T + tr(H_ab) I),   H_ab = sum_g w_g |det J_g| grad N_a grad N_b^T
//
// for the shape functions N_a: H is all that the geometry gives, and a fifth of the work.
// lambda = nu E / ((1 + nu) (1 - 2 nu)), in plane stress nu E / (1 - nu^2); mu = E / (2 (1 + nu)).
#pragma once

#include <cstddef>
#include <vector>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include "problems/structure/model/elongation.hpp"
#include "problems/structure/model/structure.hpp"
#include "problems/structure/model/truss.hpp"
#include "support/numbers/running_error.hpp"

namespace kusabi::problems {

/// A matrix over all displacements of an element's nodes, node by node and axis by axis, supported
/// or not.
template <class Scalar>
using ElementMatrix = Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic>;

/// K_e, force/length, symmetric to the last bit.
/// @pre the element passes `check_structure`
template <class Scalar>
ElementMatrix<Scalar> element_matrix(const Structure& structure, const Element& element);

extern template ElementMatrix<double> element_matrix(const Structure&, const Element&);
extern template ElementMatrix<numbers::Precise> element_matrix(const Structure&, const Element&);
extern template ElementMatrix<numbers::RunningError> element_matrix(const Structure&,
                                                                    const Element&);

/// One of these displacements, or a free displacement that it is made of.
template <class Scalar>
struct ElementPart {
  Eigen::Index place;  ///< in the matrix of the element
  int number;          ///< among the free displacements
  Scalar weight;       ///< 1 for a displacement of its own
};

/// All of them, those that are fixed left out.
template <class Scalar>
std::vector<ElementPart<Scalar>> element_parts(const FreeDegrees& degrees, const Element& element) {
  std::vector<ElementPart<Scalar>> parts;
  Eigen::Index place = 0;
  for (const int node : element.nodes) {
    for (int axis = 0; axis < static_cast<int>(degrees.number.rows()); ++axis, ++place) {
      for (const auto& [number, weight] : parts_of<Scalar>(degrees, axis, node))
        parts.push_back({place, number, weight});
    }
  }
  return parts;
}

/// Adds the entries of an element at its free displacements to those of a matrix over all of these.
template <class Scalar>
void add_matrix(const ElementMatrix<Scalar>& matrix, const std::vector<ElementPart<Scalar>>& parts,
                std::vector<Eigen::Triplet<Scalar>>& entries) {
  for (const auto& row : parts) {
    for (const auto& column : parts) {
      entries.emplace_back(row.number, column.number,
                           matrix(row.place, column.place) * (row.weight * column.weight));
    }
  }
}

/// The vectors b of an element whose squares b b^T add up to its stiffness, as those of a member
/// do, without a unit: E = 1, nu = 0, thickness 1; in the plane plane stress, in space divided by
/// the size of the element. What moves without straining these moves freely. d (d + 1) / 2 for each
/// integration point.
std::vector<StrainVector<double>> shape_vectors(const Structure& structure,
                                                const FreeDegrees& degrees, const Element& element);

/// The sum of their squares.
ElementMatrix<double> shape_matrix(const Structure& structure, const Element& element);

/// Longest distance of a node from the first. Length.
double element_extent(const Structure& structure, const Element& element);

/// det J at the corners, and after them at the integration points, length^d; for quadrilaterals
/// and hexahedra 2^d times that. Of one sign if the element is valid.
Eigen::VectorXd jacobian_determinants(const Structure& structure, const Element& element);

/// Stiffness of all elements over the free displacements, force/length.
Eigen::SparseMatrix<double> element_stiffness(const Structure& structure,
                                              const FreeDegrees& degrees);

}  // namespace kusabi::problems
