// Half-widths of the parameters of the dead load, from the file or from options.
#pragma once

#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "problems/limit/limit_problem.hpp"

namespace kusabi::problems {

/// Half-widths by the name of a load or a group, force.
using GroupHalfWidths = std::vector<std::pair<std::string, double>>;

/// Requested half-widths of parameters without one in the file, in the unit of force.
struct RequestedHalfWidths {
  std::optional<double> alpha{};  ///< of all parameters without a half-width of their own
  GroupHalfWidths groups{};       ///< by the name of a load or a group, >= 0
};

/// The half-widths of groups without those whose name occurs in other load cases of the structure
/// only, which are admissible and have no effect.
/// @param whole with all load cases of the file
GroupHalfWidths of_cases(GroupHalfWidths groups, std::span<LimitProblem* const> cases,
                         const Structure& whole);

/// The requested half-widths do not fit the file; the message has the expected ones.
class HalfWidthError : public std::invalid_argument {
 public:
  using std::invalid_argument::invalid_argument;
};

/// Sets the half-width of each column of T, equally in all load cases.
/// @return alpha of the search: the requested one, or 1 if columns have half-widths of their own;
///         nothing: neither the options nor the file request a worst case
/// @throws HalfWidthError if a group does not exist, has a half-width in the file, or if a
///         half-width is missing
std::optional<double> set_half_widths(std::span<LimitProblem* const> cases,
                                      const RequestedHalfWidths& asked);

/// Sets half-widths of these groups as if specified by the file.
/// @throws HalfWidthError as above
void fix_half_widths(LimitProblem& problem, std::span<const std::pair<std::string, double>> groups);

/// The common half-width of all columns, 0 if there are none; nothing if they differ.
/// @param alpha of the search
std::optional<double> common_half_width(const LimitProblem& problem, double alpha);

}  // namespace kusabi::problems
