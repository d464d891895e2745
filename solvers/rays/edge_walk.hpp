// Extremal rays of the cone D(Y) of one sign pattern by a walk along its edges (pivoting, as in
// D. Avis and K. Fukuda, Discrete and Computational Geometry 8, 1992, but with a set of the known
// rays).
//
// A ray is simple if it has only the 2m - 1 equalities that a ray needs. Each of those that D(Y)
// does not require everywhere can then be dropped, which gives an edge of D(Y), at whose other end
// is another ray. The rays and edges of D(Y) form a connected graph, so the walk finds all rays if
// all of them are simple. A ray costs microseconds, however many there are; double description
// compares it with many others.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "solvers/rays/null_vector.hpp"
#include "solvers/rays/reaction_cone.hpp"
#include "solvers/rays/zero_set.hpp"

namespace kusabi::rays {

enum class WalkEnd {
  complete,
  not_simple,  ///< some ray is not simple, or this is numerically undecided
  stopped,
};

struct EdgeWalk {
  WalkEnd end = WalkEnd::not_simple;
  std::vector<ZeroSet> rays;  ///< of D(Y), in no particular order; if complete
};

/// Walks on D(Y) = {r in C_r: u_n = 0 on `contact`, r = 0 elsewhere} of constrained bodies; not
/// possible (not_simple) for unconstrained ones.
/// @param inside unknowns of a point of D(Y) whose reactions on `contact` and gaps elsewhere are
///   positive; only its unknowns on `contact` are used
/// @param stop called now and then; true ends the walk. Empty: never
EdgeWalk walk_along_edges(const ReactionCone& cone, Candidates contact, const LongVector& inside,
                          const std::function<bool()>& stop);

}  // namespace kusabi::rays
