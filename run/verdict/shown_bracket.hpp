// Bounds as decimal numbers that are bounds, too: lower ones rounded down, upper ones up.
#pragma once

#include <string>

namespace kusabi::run {

/// Five significant digits of a sentence.
inline constexpr int digits_of_sentence = 5;
/// At least so many of a table.
inline constexpr int digits_of_table = 12;

std::string rounded_down(double number, int digits = digits_of_sentence);
std::string rounded_up(double number, int digits = digits_of_sentence);

struct ShownBracket {
  std::string lower, upper;
};

/// Both to the same decimal place, that of the finer one: "0.99999" and "1.00001".
ShownBracket in_sentence(double lower, double upper);

/// To so many digits that what is shown is at most twice as wide as the bracket; 12 at least.
ShownBracket in_table(double lower, double upper);

}  // namespace kusabi::run
