// The answers in a sentence, in the same words at the end of a table and at the head of a report.
// Only what is known is claimed: "it cannot" needs a whole search, and a bound is rounded to the
// side on which it stays one.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "support/exact_count.hpp"

namespace kusabi::run {

/// What a search for wedged configurations has found at one friction coefficient.
struct Sticking {
  std::string_view thing = "way";  ///< what is counted
  double friction = 0;
  support::ExactCount count;
  double doubtful = 0;  ///< of which it could not be told; not counted
  bool whole = true;    ///< whether the search came to its end
};

/// "It can stick: 27 ways at friction coefficient 0.65."
std::string sticking_sentence(const Sticking& found);

/// What is not counted. @param doubtful > 0
std::string doubtful_sentence(double doubtful);

/// Of numbers that rounding may have made zero, or not.
std::string unsound_sentence();

/// "It cannot stick below friction coefficient 0.47027; at 0.47028 it can."
/// @param upper nothing: nothing is known to stick at any coefficient of interest
std::string critical_sentence(double lower, std::optional<double> upper);

/// How much of its reference load a truss carries. @param factor nothing: no factor was found
std::string carried_sentence(std::optional<double> factor);

/// The same whatever an uncertain dead load is. @param lower of the least factor; nothing: none is
/// known  @param alpha of all uncertain loads; nothing: each has its own  @param force the unit of
/// alpha; nothing: alpha is a number of times the uncertain loads
std::string always_carried_sentence(std::optional<double> lower, std::optional<double> alpha,
                                    std::optional<std::string_view> force);

/// A dead load is carried at no factor: the given one, or one of those that may be.
std::string not_carried_sentence(bool uncertain);

/// Five digits, of which the last is rounded so that the text is not greater (not smaller) than
/// the number: a bound stays one.
std::string rounded_down(double number);
std::string rounded_up(double number);

}  // namespace kusabi::run
