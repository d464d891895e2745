// Rigid-body modes of unconstrained bodies, restricted to contact degrees of freedom: G of
// docs/theory/wedged.md, "Unconstrained bodies".
#pragma once

#include <span>

#include "problems/structure/bodies/rigid_motions.hpp"
#include "problems/structure/model/structure.hpp"
#include "support/numbers/precise.hpp"

namespace kusabi::problems {

struct ContactMotions {
  /// G, dm x p, ordered as in WedgedProblem: independent and orthogonal columns, the largest entry
  /// of each between 1/2 and 1. Modes that displace no candidate are left out.
  numbers::PreciseMatrix matrix;
  double error = 0;  ///< bound of the error of an entry
  /// The work of loads on these motions, loads x p, and on those that displace no candidate.
  numbers::PreciseMatrix work{}, work_on_other_modes{};
};

/// @param bodies those of the structure
/// @param forces loads on the nodes, d nodes x loads, node by node
/// @throws InputError if it is numerically undecided whether a mode displaces candidates, or if a
///   body has no candidates
ContactMotions contact_motions(const Structure& structure,
                               std::span<const UnconstrainedBody> bodies,
                               const Eigen::MatrixXd& forces = {});

/// The same without combinations: a column for each mode of each body, dm x sum of p, zero if it
/// displaces no candidate.
numbers::PreciseMatrix restricted_modes(const Structure& structure,
                                        std::span<const UnconstrainedBody> bodies);

}  // namespace kusabi::problems
