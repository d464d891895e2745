// Whether a certificate speaks of a structure: its candidates, its friction, its blocks and its K.
#pragma once

#include <string>
#include <variant>

#include "verify/arithmetic/exact.hpp"
#include "verify/structure/contact_motions.hpp"
#include "verify/structure/structure.hpp"
#include "verify/wedged/certificate.hpp"

namespace kusabi::verify {

/// K of the certificate may differ from that of the structure by so much of the largest diagonal
/// entries of the two candidates: a K from double precision carries rounding of 1e-16 times the
/// condition of the whole stiffness. Nothing is proved from K of the certificate, so what is
/// smaller than this does no harm.
inline constexpr double stiffness_tolerance = 1e-6;

/// The same for the motions of loose bodies, relative to the largest entry of each.
inline constexpr double motion_tolerance = 1e-6;

/// What a certificate and a structure have in common.
struct Agreement {
  EnclosedMatrix stiffness;  ///< of the structure
  ContactMotions motions;    ///< of its bodies that nothing holds
  double friction = 0;       ///< the coefficient that those of the candidates are relative to
};

/// Computes K of the structure anew and compares.
/// @return a sentence that says where they disagree, if they do
std::variant<Agreement, std::string> agreement(const Certificate& certificate,
                                               const Structure& structure);

/// A name as a line of a certificate holds it: control characters as \x0a.
std::string on_one_line(const std::string& name);

}  // namespace kusabi::verify
