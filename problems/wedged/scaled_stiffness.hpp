// Stiffness of a structure over its free displacements in 104 bits, scaled to a diagonal of about
// one, with a bound of the rounding errors of its assembly (docs/theory/wedged.md, "F and its
// error").
#pragma once

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include "problems/structure/model/structure.hpp"
#include "problems/structure/model/truss.hpp"
#include "support/numbers/precise.hpp"

namespace kusabi::problems {

/// D K D with D = diag(scale) of powers of two, which make the diagonal about one.
struct ScaledStiffness {
  Eigen::SparseMatrix<numbers::Precise> matrix;  ///< both triangles
  Eigen::VectorXd scale;                         ///< D
  double error = 0;    ///< bound of the norm of the rounding errors of the assembly
  double row_sum = 0;  ///< bound of the largest row sum of absolute values
};

/// @pre the structure passes `check_structure`
ScaledStiffness scaled_stiffness(const Structure& structure, const FreeDegrees& degrees);

}  // namespace kusabi::problems
