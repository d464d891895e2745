// NearestFailure: the inequality of a wedged configuration with the least margin.
#pragma once

#include <optional>
#include <span>
#include <string>

#include "nodes/wedged/relaxation/sign_pattern.hpp"
#include "problems/wedged/wedged_problem.hpp"
#include "run/wedged/contact_words.hpp"

namespace kusabi::run {

/// Slack of one inequality, with normal reactions that sum to one unit of force.
struct Slack {
  int candidate = 0;
  double amount = 0;  ///< mu r_n - |r_t|, or r_n without friction, force; or u_n, length
  double used = 0;    ///< |r_t| / (mu r_n); 0 for a gap
};

struct NearestFailure {
  std::optional<Slack> contact;  ///< least mu r_n - |r_t| of the candidates in contact
  std::optional<Slack> gap;      ///< least u_n of the separated candidates
  bool gap_first = false;        ///< true if the gap is the margin t*, in the units of t*
  FrictionNeed need;             ///< the pattern may be feasible below with another configuration
};

/// @param coefficient mu_i = coefficient x phi_i
/// @param reaction of the block, force, normal parts that sum to 1
/// @param displacement likewise, length
NearestFailure nearest_failure(const problems::WedgedProblem& problem, double coefficient,
                               std::uint32_t block, const wedged::SignPattern& pattern,
                               std::span<const double> reaction,
                               std::span<const double> displacement);

/// " If the normal reactions sum to 1 kN, …": the inequality with the least margin and its slack,
/// and the nearest inequality of the other kind.
std::string nearest_failure_text(const problems::WedgedProblem& problem,
                                 const NearestFailure& nearest);

}  // namespace kusabi::run
