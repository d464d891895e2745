// Initial bracket without a tree: the root relaxation is a lower bound of the smallest coefficient,
// single leaves are upper bounds. Both coincide if the pattern with all candidates in contact has
// the smallest coefficient.
#pragma once

#include "engine/analysis/analysis.hpp"
#include "nodes/wedged/critical/critical_findings.hpp"
#include "nodes/wedged/critical/narrowing_bracket.hpp"
#include "problems/wedged/wedged_problem.hpp"

namespace kusabi::wedged {

/// Trees of smaller problems take no longer than the initial bracket.
inline constexpr int min_candidates_for_start = 24;

/// Narrows the bracket for each block by the root, the leaf with all candidates in contact, and the
/// leaves with a single candidate in contact, whose coefficients have a closed form. Called on all
/// ranks.
/// @return programs solved
std::uint64_t start_bracket(engine::Analysis& analysis, const problems::WedgedProblem& problem,
                            const CriticalGrid& grid, NarrowingBracket& bracket);

/// Leaf with a single candidate i in contact. If all others separate, its critical coefficient has
/// the closed form mu_i = F_nn,ii / |F_nt,ii|.
struct SingleContact {
  double factor = 0;  ///< this coefficient in units of the candidate's own
  int candidate = 0;
};

/// The leaves of all candidates. @param block a problem of one block
/// @return sorted by factor; empty for unconstrained bodies
std::vector<SingleContact> single_contacts(const problems::WedgedProblem& block);

/// The leaf of a block of this many candidates with the given ones in contact.
SignPattern leaf_with(const support::IndexSet& contact, int candidates);

}  // namespace kusabi::wedged
