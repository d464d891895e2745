// Checks of a structure before computations: all rules that concern the structure instead of the
// syntax of its file. The constructor of `CheckedStructure` is the only caller, so structures of
// files and of programs obey the same rules.
#pragma once

#include <string>

#include "problems/structure/model/structure.hpp"

namespace kusabi::problems {

/// Smallest and largest magnitude of an axial stiffness or a length, in the user's units. Within
/// these limits EA / L and its inverse are within 1e+-100, and their squares within the range of
/// double.
inline constexpr double smallest_magnitude = 1e-50;
inline constexpr double largest_magnitude = 1e50;

/// Maximum number of contact candidates of a problem: F and K of more would have over 10^8 entries.
inline constexpr int max_contact_candidates = 4096;

/// Smallest and largest friction of a contact candidate relative to the coefficient of a search; 0
/// is also allowed.
inline constexpr double smallest_friction = 1e-6;
inline constexpr double largest_friction = 1e6;

/// A member shorter than this times the largest coordinate of its ends counts as of zero length:
/// the coordinates have rounding errors of 1e-16, so its direction would have less than six digits.
inline constexpr double zero_length = 1e-10;

/// Smallest sine of the angle between a given tangent and the normal. Below it the projected
/// direction would have lost six of its sixteen digits.
inline constexpr double smallest_tangent_sine = 1e-6;

/// Checks sizes, finiteness, members (ends, length, EA, no duplicates), elements
/// (`check_elements`), superelements (`check_superelements`), that every free node has a member or
/// an element, the springs, the contact candidates (count, supports, normals, tangents), dependent
/// displacements (`check_constraints`), the loads and the uncertain components. Sections that only
/// some commands require may be missing.
/// @throws InputError at the first fault, in the order of the list above.
void check_structure(const Structure& structure);

/// Message for an EA out of range.
std::string axial_stiffness_fault(double value);

}  // namespace kusabi::problems
