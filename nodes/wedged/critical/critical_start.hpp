// The bracket before there is a tree: the root relaxation bounds the smallest coefficient from
// below, single leaves that need no search from above. Where something wedges with all candidates
// in contact, both are the same.
#pragma once

#include "engine/analysis/analysis.hpp"
#include "nodes/wedged/critical/critical_bracket.hpp"
#include "nodes/wedged/critical/critical_findings.hpp"
#include "problems/wedged/wedged_problem.hpp"

namespace kusabi::wedged {

/// Smaller problems have trees that are searched as soon.
inline constexpr int fewest_to_start = 24;

/// Narrows the bracket by them: of each block the root, the leaf with all in contact, and those
/// with one candidate in contact, whose coefficients have a closed form. On all ranks.
/// @return programs solved
std::uint64_t start_bracket(engine::Analysis& analysis, const problems::WedgedProblem& problem,
                            const CriticalGrid& grid, CriticalBracket& bracket);

/// Candidates whose leaf with them alone in contact is feasible in closed form, and from which
/// factor of the candidates' own coefficients on: mu_i = F_nn,ii / |F_nt,ii| where no other
/// candidate closes. By their coefficient; none of loose bodies.
/// @param block a problem of one block
struct SingleContact {
  double factor = 0;
  int candidate = 0;
};
std::vector<SingleContact> single_contacts(const problems::WedgedProblem& block);

/// The leaf of a block of so many candidates with these in contact.
SignPattern leaf_with(const support::IndexSet& contact, int candidates);

}  // namespace kusabi::wedged
