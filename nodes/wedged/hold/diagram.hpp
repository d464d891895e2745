// Diagram of two reference loads: the pairs of factors that can be held with the dead load, as
// convex pieces with their sign patterns (docs/theory/loads.md, "Diagram of two loads"). That of a
// peg in a hole is the jamming diagram (Whitney 1982). Pieces of several decoupled subproblems are
// intersections of a piece of each.
#pragma once

#include <vector>

#include "engine/analysis/analysis.hpp"
#include "nodes/wedged/hold/diagram_piece.hpp"
#include "nodes/wedged/hold/hold_search.hpp"

namespace kusabi::wedged {

struct Diagram {
  engine::Status status = engine::Status::solved;
  /// Of the claim that no other sign pattern holds a pair of factors, except for pairs on lines.
  support::Standing outside{};
  bool unresolved = false;  ///< patterns are undecided: pieces may be missing
  std::vector<DiagramPiece> pieces{};
  std::vector<HoldCost> costs{};
};

/// Pairs of factors of both reference loads that are held at one coefficient. Every rank makes the
/// same call and gets the same result. At a limit `status` names it, and the result has what is
/// known.
/// @param loaded with two reference loads
/// @param mu friction coefficient, which multiplies the own one of each candidate
Diagram diagram_of(engine::Analysis& analysis, const LoadedProblem& loaded, double mu,
                   Precision precision = Precision::escalating);

}  // namespace kusabi::wedged
