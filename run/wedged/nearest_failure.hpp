// Which inequality of a wedged configuration is the nearest to failing: what its margin is of.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "nodes/wedged/tree/sign_pattern.hpp"
#include "problems/wedged/wedged_problem.hpp"

namespace kusabi::run {

/// How much room one inequality has, where the normal reactions sum to one unit of force.
struct Slack {
  int candidate = 0;
  double amount = 0;  ///< mu r_n - |r_t|, force, or u_n, length
  double used = 0;    ///< |r_t| / (mu r_n); 0 of a gap
};

struct NearestFailure {
  std::optional<Slack> contact;  ///< the least mu r_n - |r_t| of those in contact
  std::optional<Slack> gap;      ///< the least u_n of those separated
  bool gap_first = false;        ///< which of the two is the margin t*, in the units of t*
  /// From this coefficient on the configuration is one: the largest |r_t| / (phi r_n). The pattern
  /// may live below with another one.
  double holds_from = 0;
  std::vector<int> slips_there;  ///< the candidates that are on their cones there
};

/// @param coefficient mu_i = coefficient x phi_i
/// @param reaction of the block, force, normal parts that sum to 1  @param displacement likewise,
///        length
NearestFailure nearest_failure(const problems::WedgedProblem& problem, double coefficient,
                               std::uint32_t block, const wedged::SignPattern& pattern,
                               std::span<const double> reaction,
                               std::span<const double> displacement);

/// Sentences: which inequality the margin is of and by how much, which of the other kind is next,
/// and from which coefficient on the configuration holds.
std::string nearest_failure_text(const problems::WedgedProblem& problem,
                                 const NearestFailure& nearest);

}  // namespace kusabi::run
