// The compliance F = K^-1 of the contact candidates with more digits than a double has, and how far
// it can be trusted.
//
// Which sign patterns and extremal rays there are depends on sums of its entries that vanish
// exactly, or only almost; where stiff bars stand beside soft ones, an F computed in doubles is
// wrong in the digits that decide. So F is computed from the structure itself with 104 bits, and
// with a bound of its error that holds (docs/theory/wedged.md, "F and its error").
#pragma once

#include <Eigen/Core>

#include "problems/structure/model/structure.hpp"
#include "support/numbers/precise.hpp"
#include "support/stop.hpp"

namespace kusabi::problems {

/// F with 104 bits.
struct EnclosedCompliance {
  /// F~, dm x dm, ordered as in WedgedProblem, length/force; exactly symmetric.
  numbers::PreciseMatrix matrix;
  /// |F~_ij - F_ij| <= error sqrt(F_ii F_jj) for all i, j, where F is that of the structure with
  /// its numbers meant exactly; infinity if no bound could be proved. About 1e-26 for a condition
  /// of 1e6. The rows and columns of F that belong to a subset of the candidates have the same
  /// bound.
  double error = 0;
  /// The displacements of the whole structure under a unit reaction in each direction of each
  /// candidate: free displacements x dm, length/force. F~ is what the candidates see of it.
  numbers::PreciseMatrix response{};
};

/// F of a structure. The stiffness is scaled to a unit diagonal and factorised in doubles or long
/// doubles; the displacements under unit loads are refined with residuals in 104 bits, and the
/// last of these residuals, with the least eigenvalue that a Cholesky factorisation proves, is the
/// bound.
/// @pre the structure passes `check_structure` and is no mechanism
/// @throws support::Stopped if an end is asked for: between factorisations and groups of columns
EnclosedCompliance enclosed_compliance(const Structure& structure,
                                       const support::LongWork& work = {});

/// K = F^-1, force/length, from an F with 104 bits.
/// @return nothing of use (NaN) if F is not positive definite
/// @throws support::Stopped if an end is asked for
numbers::PreciseMatrix stiffness_of(const numbers::PreciseMatrix& compliance,
                                    const support::LongWork& work = {});

/// `enclosed_compliance` in long double precision, length/force. Zero exactly where an entry is not
/// known to be anything else, or is no more than the rounding of the directions in the file. Of
/// loose bodies with their temporary springs.
/// @pre `wedged_problem` accepts the structure
Eigen::Matrix<long double, Eigen::Dynamic, Eigen::Dynamic> precise_compliance(
    const Structure& structure);

}  // namespace kusabi::problems
