// [[actions]] and [combinations]: combinations of actions by EN 1990, 6.4.3.2, as load cases.
//
// The rules (6.10), (6.10a) and (6.10b) give each permanent action one of two factors, and each
// variable action its factor or zero. The largest load factor is concave, and the least one convex,
// in these factors; so the worst choice is a corner of a box, and one load case with uncertain
// loads stands for all combinations with the same leading action (docs/theory/limit.md).
#pragma once

#include "problems/files/draft/problem_draft.hpp"

namespace kusabi::problems {

/// Adds the load cases of [[actions]] to the structure: dead loads and uncertain loads of fixed
/// half-width, and the reference load. Each section requires the other; both may be absent.
void read_actions(ProblemDraft& draft);

}  // namespace kusabi::problems
