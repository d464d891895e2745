// Stresses from the displacements of nodes: of elements at their centre, sigma = D B u, where B has
// the gradients of the shape functions and D is Hooke's law,
//
//   sigma = 2 mu e + lambda tr(e) I,   e = (grad u + grad u^T) / 2,
//
// with lambda and mu of problems/structure/assembly/solid_element.hpp, the thickness aside. Of
// members how much of their strength their axial force takes.
#pragma once

#include <Eigen/Core>

#include "problems/structure/model/structure.hpp"

namespace kusabi::problems {

/// Columns: sigma_xx, sigma_yy, sigma_zz, sigma_xy, sigma_yz, sigma_xz, force/length^2, positive in
/// tension. In the plane sigma_yz = sigma_xz = 0; sigma_zz is 0 in plane stress and
/// nu (sigma_xx + sigma_yy) in plane strain.
using Stresses = Eigen::Matrix<double, 6, Eigen::Dynamic>;

/// Of the elements, in their order, each where its natural coordinates are those of its centre.
/// @param displacements of all nodes, d x nodes, global axes, length
/// @pre the elements pass `check_structure`
Stresses element_stresses(const Structure& structure, const Eigen::MatrixXd& displacements);

/// The equivalent stress of von Mises, sqrt(3/2 s:s) with s the deviator: one a column, >= 0.
Eigen::VectorXd von_mises(const Stresses& stresses);

/// Whether a yield force is known of any member.
bool has_yield_forces(const Structure& structure);

/// |q| relative to the yield force on the side of q, one a member: 1 where it yields, 0 where it
/// carries nothing, infinite where it can carry nothing and does; NaN where none is given.
/// @param forces q of the members, force, positive in tension
Eigen::VectorXd utilisations(const Structure& structure, const Eigen::VectorXd& forces);

}  // namespace kusabi::problems
