// Stresses of elements at their centres, from the displacements of nodes: sigma = D B u, where B
// has the gradients of the shape functions and D is Hooke's law,
//
//   sigma = 2 mu e + lambda tr(e) I,   e = (grad u + grad u^T) / 2,
//
// with lambda and mu of problems/structure/assembly/solid_element.hpp, without the thickness. For
// members, their axial forces relative to their yield forces.
#pragma once

#include <Eigen/Core>

#include "problems/structure/model/structure.hpp"

namespace kusabi::problems {

/// Rows: sigma_xx, sigma_yy, sigma_zz, sigma_xy, sigma_yz, sigma_xz, force/length^2, positive in
/// tension; one column for each element. In the plane sigma_yz = sigma_xz = 0; sigma_zz is 0 in
/// plane stress and nu (sigma_xx + sigma_yy) in plane strain.
using Stresses = Eigen::Matrix<double, 6, Eigen::Dynamic>;

/// Stresses at the centres of the elements, in their order.
/// @param displacements of all nodes, d x nodes, global axes, length
/// @pre the elements pass `check_structure`
Stresses element_stresses(const Structure& structure, const Eigen::MatrixXd& displacements);

/// Von Mises stresses, sqrt(3/2 s:s) with the deviator s, one for each column.
Eigen::VectorXd von_mises(const Stresses& stresses);

/// True if any member has a yield force.
bool has_yield_forces(const Structure& structure);

/// |q| relative to the yield force of the sign of q, one for each member: 1 at yield, 0 without
/// force, infinite if there is a force but the yield force is zero; NaN without yield force.
/// @param forces q of the members, force, positive in tension
Eigen::VectorXd utilisations(const Structure& structure, const Eigen::VectorXd& forces);

}  // namespace kusabi::problems
