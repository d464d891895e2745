// Parts of program files that are no mixed zero-one linear program: refused by their names, so that
// nobody takes them for errors in the file.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace kusabi::linear {

/// The name of the feature that a section of an MPS file holds ("special ordered sets" of SOS1);
/// empty if the section is of no known feature.
std::string_view unsupported_feature(std::string_view section);

/// @throws support::InputError `FILE:LINE: ...`
[[noreturn]] void refuse_unsupported(const std::string& file, std::size_t line,
                                     std::string_view what, std::string_view feature);

/// Sets, semi-continuous columns, indicator constraints, quadratic terms, and constants, ranges and
/// empty objectives, which GLPK does not read, of a file in CPLEX LP format.
/// @throws support::InputError `FILE:LINE: ...` of the first
void refuse_unsupported_lp(std::string_view text, const std::string& file);

}  // namespace kusabi::linear
