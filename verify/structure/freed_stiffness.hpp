// A stiffness in doubles, made to resist no motion of a loose body.
#pragma once

#include "verify/arithmetic/exact.hpp"
#include "verify/structure/contact_motions.hpp"

namespace kusabi::verify {

/// P'K P with P = I - G (G'G)^-1 G'; of all zeros if the columns of G depend on each other.
/// @param stiffness K, known exactly  @param motions G, with lengths that are exactly one
EnclosedMatrix freed(const EnclosedMatrix& stiffness, const ContactMotions& motions);

}  // namespace kusabi::verify
