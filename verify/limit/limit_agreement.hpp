// Whether a certificate of a limit load speaks of a truss in a problem file: its B, its yield
// forces, its loads and what is uncertain of them.
#pragma once

#include <string>
#include <variant>

#include "verify/limit/limit_certificate.hpp"
#include "verify/limit/limit_proof.hpp"
#include "verify/structure/structure.hpp"

namespace kusabi::verify {

/// Direction cosines of the certificate may differ from those of the truss by so much: they are
/// roundings of them. The proof takes the difference into account, whatever it is.
inline constexpr double cosine_tolerance = 0x1p-48;

/// Compares all numbers that describe the truss: yield forces, weights and the
/// half-widths that the structure says must be the same, loads
/// and direction cosines the same but for rounding, by how much is returned. The half-width of each
/// uncertain load of the structure is returned as well.
/// @return a sentence that says where they disagree, if they do
std::variant<LimitTruss, std::string> limit_agreement(const LimitCertificate& certificate,
                                                      const Structure& structure);

/// The truss of claims on least factors: those of the largest ones, with the reference load
/// reversed.
Structure with_reversed_reference(Structure structure);

}  // namespace kusabi::verify
