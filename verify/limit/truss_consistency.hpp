// Consistency of the truss of a certificate with that of a problem file: directions, yield forces,
// loads and uncertain loads.
#pragma once

#include <optional>
#include <string>

#include "verify/limit/truss_certificate.hpp"
#include "verify/structure/structure.hpp"

namespace kusabi::verify {

/// Compares all data of the proof of a theorem. Numbers must be equal, forces in sum; so must names
/// and half-widths of uncertain loads, except half-widths that the file does not specify. A theorem
/// on losses without uncertain loads is about the dead load as given.
/// @return a sentence with the first difference; nothing: there is none
std::optional<std::string> truss_difference(const TrussTheorem& theorem, const Structure& file);

/// The same for the uncertain loads alone.
/// @param recorded with uncertain loads and half-widths
std::optional<std::string> uncertain_difference(const Structure& recorded, const Structure& file);

/// The truss for claims on least factors: that of the largest ones with the opposite reference
/// load.
Structure with_reversed_reference(Structure structure);

/// The truss of the proof of a theorem: at its strength, with the reference load of its claim.
Structure truss_of(const TrussTheorem& theorem);

}  // namespace kusabi::verify
