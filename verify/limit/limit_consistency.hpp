// Consistency of a limit-load certificate with a truss in a problem file: B, yield forces, loads
// and uncertain loads.
#pragma once

#include <string>
#include <variant>

#include "verify/limit/limit_certificate.hpp"
#include "verify/limit/limit_proof.hpp"
#include "verify/structure/structure.hpp"

namespace kusabi::verify {

/// Tolerance of the recorded direction cosines, which are roundings of the exact ones. The proof
/// includes the difference whatever its size.
inline constexpr double cosine_tolerance = 0x1p-48;

/// Compares all data of the truss. Yield forces, weights and specified half-widths must be equal,
/// loads and direction cosines equal up to rounding; the differences and the half-width of each
/// uncertain load are returned.
/// @return otherwise a sentence with the first difference
std::variant<LimitTruss, std::string> limit_consistency(const LimitCertificate& certificate,
                                                        const Structure& structure);

/// The truss for claims on least factors: that of the largest ones with the opposite reference
/// load.
Structure with_reversed_reference(Structure structure);

}  // namespace kusabi::verify
