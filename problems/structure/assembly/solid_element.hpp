// Stiffness of an isoparametric element of an isotropic material: plane stress or plane strain with
// a thickness, or in space.
//
//   K_e = sum_g w_g |det J_g| t B_g^T D B_g, which is block (a, b) =
//   lambda H_ab + mu (H_ab^T + tr(H_ab) I),   H_ab = sum_g w_g |det J_g| grad N_a grad N_b^T
//
// for the shape functions N_a. H depends on the geometry only and takes a fifth of the operations
// of B^T D B. lambda = nu E / ((1 + nu) (1 - 2 nu)), in plane stress nu E / (1 - nu^2); mu = E / (2
// (1 + nu)).
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

/// A matrix over all displacements of an element's nodes, by nodes and axes, including supported
/// ones.
template <class Scalar>
using ElementMatrix = Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic>;

/// K_e, force/length, exactly symmetric.
/// @pre the element passes `check_structure`
template <class Scalar>
ElementMatrix<Scalar> element_matrix(const Structure& structure, const Element& element);

extern template ElementMatrix<double> element_matrix(const Structure&, const Element&);
extern template ElementMatrix<numbers::Precise> element_matrix(const Structure&, const Element&);
extern template ElementMatrix<numbers::RunningError> element_matrix(const Structure&,
                                                                    const Element&);

/// A displacement of an element, or a master degree of freedom of it.
template <class Scalar>
struct ElementPart {
  Eigen::Index place;  ///< in the matrix of the element
  int number;          ///< among the free displacements
  Scalar weight;       ///< 1 if the displacement is independent
};

/// All of them, without fixed ones.
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

/// Adds the entries of an element to a matrix over the free displacements.
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

/// The vectors b of an element whose sum of b b^T is its stiffness, like those of a member, without
/// units: E = 1, nu = 0, thickness 1; plane stress in the plane, divided by the size of the element
/// in space. Its null space contains the rigid-body modes. There are d (d + 1) / 2 vectors for each
/// integration point.
std::vector<StrainVector<double>> shape_vectors(const Structure& structure,
                                                const FreeDegrees& degrees, const Element& element);

/// The sum of their b b^T.
ElementMatrix<double> shape_matrix(const Structure& structure, const Element& element);

/// Largest distance of a node from the first. Length.
double element_extent(const Structure& structure, const Element& element);

/// det J at the vertices, then at the integration points, length^d; 2^d times that for
/// quadrilaterals and hexahedra. All have one sign if the element is valid.
Eigen::VectorXd jacobian_determinants(const Structure& structure, const Element& element);

/// Stiffness of all elements over the free displacements, force/length.
Eigen::SparseMatrix<double> element_stiffness(const Structure& structure,
                                              const FreeDegrees& degrees);

}  // namespace kusabi::problems
