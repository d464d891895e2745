// Loads of the condensation: unit reactions of the candidates, and forces on the nodes.
#pragma once

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include "problems/structure/model/structure.hpp"
#include "problems/structure/model/truss.hpp"
#include "support/numbers/precise.hpp"

namespace kusabi::problems {

/// B in 104 bits, scaled as the stiffness.
struct Loads {
  Eigen::SparseMatrix<numbers::Precise> matrix;  ///< free displacements x loads
  Eigen::VectorXd errors;                        ///< norm of the rounding errors of each column

  /// Some columns with their zeros.
  [[nodiscard]] numbers::PreciseMatrix dense(Eigen::Index first, Eigen::Index count) const;
};

/// Unit reactions in the directions n, t1[, t2] of all candidates, then the forces.
/// @param forces on the nodes, d nodes x loads, node by node  @param scale D of ScaledStiffness
Loads unit_loads(const Structure& structure, const FreeDegrees& degrees,
                 const Eigen::MatrixXd& forces, const Eigen::VectorXd& scale);

}  // namespace kusabi::problems
