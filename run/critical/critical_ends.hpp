// The proof of both ends of a bracket of the critical friction coefficient: at each, the tree of
// sign patterns decides every node, and the evidence is put to the verifier's own test. An end
// that does not stand it is moved outwards until it does.
#pragma once

#include "problems/structure/structure.hpp"
#include "problems/wedged/wedged_problem.hpp"
#include "run/critical/critical.hpp"
#include "run/critical/critical_report.hpp"
#include "run/critical/critical_search.hpp"
#include "run/session/session.hpp"

namespace kusabi::run {

/// Proves the ends, or widens the bracket, and writes their certificates if asked to; finds the
/// patterns that live at the upper end unless the findings have patterns already. Says what stays
/// open. On all ranks; the findings count on rank 0.
/// @pre the search was solved
void prove_ends(Session& session, const CriticalOptions& options,
                const problems::Structure& structure, const problems::WedgedProblem& problem,
                const engine::Budget& budget, CriticalFindings& findings);

}  // namespace kusabi::run
