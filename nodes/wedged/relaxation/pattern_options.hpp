// Options of trees of sign patterns.
#pragma once

#include "nodes/wedged/relaxation/branching.hpp"
#include "nodes/wedged/relaxation/contact_solver.hpp"
#include "solvers/conic/answer.hpp"

namespace kusabi::wedged {

/// Bounding of candidates before the tree is searched (candidate_bounds.hpp).
enum class Tightening {
  automatic,  ///< if the tree is large, as decided by find_patterns
  never,      ///< no bounds
  always,     ///< for trees of any size
};

/// Options of the search. The patterns do not depend on them.
struct SignPatternOptions {
  conic::Tolerances tolerances;
  Branching branching = Branching::automatic;     ///< without sampling; find_patterns samples
  Tightening tightening = Tightening::automatic;  ///< likewise
  /// Number of candidates for strong branching, the best by the branching rule: both children of
  /// each are solved, and the node is split by one with an infeasible child or by the one whose
  /// children are smallest. 0: none. Not used with polyhedral cones.
  int probes = 0;
  /// 0: nodes are bounded with the friction cones themselves (Algorithm 5.1). Otherwise, in space,
  /// the number of facets of circumscribed polyhedral cones; leaves feasible with these are tested
  /// with the cones themselves (Algorithm 5.8).
  int facets = 0;
  /// True if redundant degenerate nodes are also branched: then each sign pattern below them is
  /// decided by itself, which a certificate needs. Up to 2^k times as many nodes for k inactive
  /// candidates.
  bool thorough = false;
  Precision precision = Precision::escalating;
};

/// Largest |t*| that the rounding of a file's coordinates and directions to sixteen digits can make
/// of a t* = 0. Above it the sign of t* decides, even if t* is degenerate by the tolerance.
inline constexpr double rounding_of_files = 1e-14;

/// Tolerances that resolve signs down to `resolution`, unless a larger tolerance is requested.
inline conic::Tolerances resolving(conic::Tolerances tolerances, double resolution) {
  if (tolerances.sign <= conic::Tolerances{}.sign) tolerances.resolution = resolution;
  return tolerances;
}

}  // namespace kusabi::wedged
