// Forces on the nodes of bodies without contact: weight, and forces equivalent to imposed strains.
//
//   weight            f_a = sum_g w_g |det J_g| t rho N_a g; half the mass of a bar at each end
//   temperature T     f_a = sum_g w_g |det J_g| t s grad N_a,  s = E alpha T / (1 - 2 nu), in plane
//                     stress E alpha T / (1 - nu); EA alpha T at the ends of a bar
//   displaced nodes   f = -K d, where d is zero at the other nodes
#pragma once

#include <map>

#include <Eigen/Core>

#include "problems/structure/model/structure.hpp"

namespace kusabi::problems {

/// d x nodes, force. @param gravity acceleration, d
/// @pre the elements have valid shapes
Eigen::MatrixXd weight(const Structure& structure, const Eigen::VectorXd& gravity);

/// d x nodes, force: those that cause the displacements of a free structure of which the
/// temperature rises by `rise`, uniformly. @pre as above
Eigen::MatrixXd forces_of_temperature(const Structure& structure, double rise);

/// d x nodes, force.
/// @param displaced displacements of supported nodes, d each; not of nodes of superelements or
///   masters of dependent nodes
/// @pre as above
Eigen::MatrixXd forces_of_displaced(const Structure& structure,
                                    const std::map<int, Eigen::VectorXd>& displaced);

}  // namespace kusabi::problems
