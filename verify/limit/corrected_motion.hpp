// Collapse motion of a limit-load certificate, corrected for its proof.
#pragma once

#include <vector>

#include "verify/arithmetic/exact.hpp"
#include "verify/limit/limit_certificate.hpp"
#include "verify/limit/limit_truss.hpp"

namespace kusabi::verify {

/// The recorded motion, corrected so that members that are rigid in the intended motion are rigid
/// exactly and, if requested, the reference load does no work. A large yield force, which stands
/// for an unlimited one, would multiply rounding errors. The correction need not be accurate: its
/// bound is computed exactly.
/// @param without_work the reference load does no work
std::vector<Dyadic> corrected_motion(const LimitCertificate& certificate, const LimitTruss& truss,
                                     bool without_work);

}  // namespace kusabi::verify
