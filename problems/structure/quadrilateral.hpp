// The four-node quadrilateral (Q4) in plane stress or plane strain, integrated at 2 x 2 Gauss
// points. Its stiffness is a sum of squares, like that of a truss:
//
//   K_e = sum_g w_g t B_g^T D B_g = sum_g sum_k b_gk b_gk^T,   b_gk = row k of sqrt(w_g t) L^T B_g,
//
// D = L L^T: twelve vectors b for each element, that measure strain as the b_e of a member do.
#pragma once

#include <vector>

#include <Eigen/SparseCore>

#include "problems/structure/elongation.hpp"
#include "problems/structure/structure.hpp"
#include "problems/structure/truss.hpp"
#include "support/numbers/precise.hpp"

namespace kusabi::problems {

/// The twelve vectors of one element.
/// @pre the element passes `check_structure`
template <class Scalar>
std::vector<StrainVector<Scalar>> strain_vectors(const Structure& structure,
                                                 const FreeDegrees& degrees,
                                                 const Quadrilateral& element);

extern template std::vector<StrainVector<double>> strain_vectors(const Structure&,
                                                                 const FreeDegrees&,
                                                                 const Quadrilateral&);
extern template std::vector<StrainVector<numbers::Precise>> strain_vectors(const Structure&,
                                                                           const FreeDegrees&,
                                                                           const Quadrilateral&);

/// The same without a unit: E = 1, nu = 0, thickness 1, plane stress. What moves without straining
/// these moves freely.
std::vector<StrainVector<double>> shape_vectors(const Structure& structure,
                                                const FreeDegrees& degrees,
                                                const Quadrilateral& element);

/// Twice the areas of the four corner triangles, with the sign of the sense in which the corners go
/// round: of one sign if and only if the element is convex.
Eigen::Vector4d corner_areas(const Structure& structure, const Quadrilateral& element);

/// Stiffness of all elements over the free displacements, force/length.
Eigen::SparseMatrix<double> element_stiffness(const Structure& structure,
                                              const FreeDegrees& degrees);

}  // namespace kusabi::problems
