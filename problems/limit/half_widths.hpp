// How far each parameter of the dead load may go: as the file says, or as is asked.
#pragma once

#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "problems/limit/limit_problem.hpp"

namespace kusabi::problems {

/// What is asked of those that the file leaves open, in the unit of force.
struct AskedHalfWidths {
  std::optional<double> alpha{};                         ///< of all that have none of their own
  std::vector<std::pair<std::string, double>> groups{};  ///< by the name of a load or a group, >= 0
};

/// What is asked does not fit to the file; says what was expected.
class UnfitHalfWidths : public std::invalid_argument {
 public:
  using std::invalid_argument::invalid_argument;
};

/// Gives each column of T its half-width, in all load cases alike.
/// @return the alpha to search with: what is asked, or 1 if columns have half-widths of their own;
///         nothing: no worst case is asked for, neither here nor by the file
/// @throws UnfitHalfWidths if a group does not exist, the file says its half-width, or one is
///         missing
std::optional<double> settle_half_widths(std::span<LimitProblem* const> cases,
                                         const AskedHalfWidths& asked);

/// Gives the columns of these groups half-widths as if the file said them.
/// @throws UnfitHalfWidths as above
void fix_half_widths(LimitProblem& problem, std::span<const std::pair<std::string, double>> groups);

/// The half-width that all columns have alike; nothing: they differ.
/// @param alpha that is searched with
std::optional<double> common_half_width(const LimitProblem& problem, double alpha);

}  // namespace kusabi::problems
