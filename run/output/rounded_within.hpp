// Numbers as text that remain within a range when they are rounded, where neither direction alone
// is safe: the ends of an interval that is held, the factor of a state inside of it.
#pragma once

#include <string>

namespace kusabi::run {

/// A number with as few significant digits as keep it within a range, at least so many; all digits
/// if the range is the number alone. @param low, high may be infinite @pre low <= number <= high
std::string rounded_within(double number, double low, double high, int digits);

/// True if reactions need all of the friction, up to rounding.
bool is_all_friction(double needed, double friction);

/// A friction coefficient that reactions need, rounded up, though not beyond that at which they are
/// in their friction cones up to rounding.
std::string needed_friction_text(double needed, double friction, int digits);

/// Ends of an interval of load factors.
struct ShownEnds {
  std::string low, high;
};

/// Both rounded to the inside, so that what is shown is held, and not empty; "no end" for one at
/// infinity.
ShownEnds shown_ends(double low, double high, int digits);

}  // namespace kusabi::run
