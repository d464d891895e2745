// Whether a structure can be computed with: every rule that is about the structure and not about
// the spelling of its file. Reading a file ends with it and `wedged_problem` begins with it, so a
// structure made by a program meets the same rules.
#pragma once

#include <string>

#include "problems/structure/model/structure.hpp"

namespace kusabi::problems {

/// Smallest and largest magnitude of an axial stiffness or a length, in the user's units. Within
/// these, EA / L and its inverse stay within 1e+-100, and their squares within the range of double.
inline constexpr double smallest_magnitude = 1e-50;
inline constexpr double largest_magnitude = 1e50;

/// Most contact candidates of a problem: F and K of more have over 10^8 entries.
inline constexpr int most_contact_candidates = 4096;

/// Smallest and largest friction of a contact candidate relative to the coefficient of a search,
/// but for 0.
inline constexpr double smallest_friction = 1e-6;
inline constexpr double largest_friction = 1e6;

/// A member shorter than this times the largest coordinate of its ends counts as of zero length:
/// the coordinates carry rounding of 1e-16, so its direction would have less than six digits.
inline constexpr double zero_length = 1e-10;

/// Smallest sine of the angle between a wished tangent and the normal. Below it the direction that
/// is left after projection would have lost six of its sixteen digits.
inline constexpr double smallest_tangent_sine = 1e-6;

/// Checks sizes, finiteness, members (ends, length, EA, no two alike), elements (`check_elements`),
/// superelements (`check_superelements`),
/// that every node that can move has a member or an element, the springs, the contact candidates
/// (count, supports, normals, tangents), what is made of others (`check_constraints`), the loads
/// and the uncertain components. Not whether a section is there that only some commands need.
/// @throws InputError at the first fault, in the order of the list above.
void check_structure(const Structure& structure);

/// What is wrong with an EA out of range.
std::string axial_stiffness_fault(double value);

}  // namespace kusabi::problems
