// Bounds as decimal numbers that remain bounds: lower ones rounded down, upper ones up.
#pragma once

#include <string>

namespace kusabi::support {

/// Significant digits in a sentence.
inline constexpr int digits_of_sentence = 5;
/// Minimum number of significant digits in a table.
inline constexpr int digits_of_table = 12;

std::string rounded_down(double number, int digits = digits_of_sentence);
std::string rounded_up(double number, int digits = digits_of_sentence);

struct ShownBracket {
  std::string lower, upper;
};

/// Both bounds with the number of decimal places of the finer one: "0.99999" and "1.00001".
ShownBracket in_sentence(double lower, double upper, int digits = digits_of_sentence);

/// Both ends of a range, rounded inwards, with so many digits that it is not empty.
/// @param digits the least number of them
ShownBracket inside(double low, double high, int digits = digits_of_sentence);

/// Both bounds with so many digits that the printed bracket is at most twice as wide as the exact
/// one; at least 12.
ShownBracket in_table(double lower, double upper);

}  // namespace kusabi::support
