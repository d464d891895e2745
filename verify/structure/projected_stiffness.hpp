// Projection of a stiffness such that it has given rigid-body modes exactly.
#pragma once

#include "verify/arithmetic/exact.hpp"
#include "verify/structure/contact_motions.hpp"

namespace kusabi::verify {

/// P'K P with P = I - G (G'G)^-1 G'; zero if the columns of G are dependent.
/// @param stiffness K, exact  @param motions G, with lengths that are exactly one
EnclosedMatrix projected(const EnclosedMatrix& stiffness, const ContactMotions& motions);

}  // namespace kusabi::verify
