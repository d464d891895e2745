// Compliance F = K^-1 of the contact candidates in more than double precision, with an error bound.
//
// Sign patterns and extremal rays depend on sums of its entries that vanish exactly or almost;
// where stiff and soft bars are combined, an F computed in doubles is wrong in the decisive digits.
// F is therefore computed from the structure in 104 bits, with a proved error bound
// (docs/theory/wedged.md, "F and its error").
#pragma once

#include <Eigen/Core>

#include "problems/structure/model/structure.hpp"
#include "problems/structure/model/truss.hpp"
#include "support/numbers/precise.hpp"
#include "support/stop.hpp"

namespace kusabi::problems {

struct WedgedProblem;

/// F in 104 bits with its error bound.
struct EnclosedCompliance {
  /// F~, dm x dm, ordered as in WedgedProblem, length/force; exactly symmetric.
  numbers::PreciseMatrix matrix;
  /// |F~_ij - F_ij| <= error sqrt(F_ii F_jj) for all i, j, where F is the compliance of the
  /// structure with exact numbers; infinity if no bound was proved. About 1e-22 for a condition
  /// number of 1e6. The bound also holds for the rows and columns of any subset of the candidates.
  double error = 0;
  /// The displacements of the whole structure under a unit reaction in each direction of each
  /// candidate: free displacements x dm, length/force. F~ is its restriction to contact degrees of
  /// freedom.
  numbers::PreciseMatrix response{};
};

/// F of a structure. The stiffness is scaled to a unit diagonal and factorised in doubles or long
/// doubles; F follows from the displacements under unit loads and their residuals in 104 bits. The
/// error bound is quadratic in the residuals, divided by the least eigenvalue, which a Cholesky
/// factorisation proves.
/// @param degrees of the structure; grounding springs do not change them
/// @pre the structure passes `check_structure` and is no mechanism
/// @throws support::Stopped if the program is asked to stop: between factorisations and groups of
///         columns
EnclosedCompliance enclosed_compliance(const Structure& structure, const FreeDegrees& degrees,
                                       const support::LongWork& work = {});

/// The same with loads, each one more row and column after those of the candidates: w = C'K^-1 f,
/// and the work f_j'K^-1 f_k between them. The error bound holds for them likewise.
/// @param forces on the nodes, d nodes x loads, node by node; none of the loads acts on supported
///        displacements alone
EnclosedCompliance enclosed_compliance(const Structure& structure, const FreeDegrees& degrees,
                                       const Eigen::MatrixXd& forces,
                                       const support::LongWork& work = {});

/// True if all forces act on supported displacements. @param force on the nodes, d nodes
bool acts_on_supports_only(const FreeDegrees& degrees, const Eigen::VectorXd& force);

/// K = F^-1, force/length, from an F in 104 bits.
/// @return NaN if F is not positive definite
/// @throws support::Stopped if the program is asked to stop
numbers::PreciseMatrix stiffness_of(const numbers::PreciseMatrix& compliance,
                                    const support::LongWork& work = {});

/// F of the problem in long double precision, length/force. Entries that are not distinguishable
/// from zero, or only by the rounding of directions in the file, are exactly zero. Unconstrained
/// bodies have their grounding springs.
Eigen::Matrix<long double, Eigen::Dynamic, Eigen::Dynamic> precise_compliance(
    const WedgedProblem& problem);

}  // namespace kusabi::problems
