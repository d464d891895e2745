// Collapse motion of a theorem on a truss, corrected for its proof.
#pragma once

#include <vector>

#include "verify/arithmetic/exact.hpp"
#include "verify/limit/limit_truss.hpp"
#include "verify/limit/truss_certificate.hpp"

namespace kusabi::verify {

/// The recorded motion, corrected so that members that are rigid in the intended motion are rigid
/// exactly and, if requested, the reference load does no work. A large yield force, which stands
/// for an unlimited one, would multiply rounding errors. The correction need not be accurate: its
/// bound is computed exactly.
/// Yield forces of lost members are zero.
/// @param without_work the reference load does no work
std::vector<Dyadic> corrected_motion(const CollapseMotion& collapse, const LimitTruss& truss,
                                     bool without_work);

}  // namespace kusabi::verify
