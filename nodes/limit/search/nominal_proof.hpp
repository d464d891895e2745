// Proof of the factors that carry the nominal dead load: the worst case for alpha = 0. Both ends,
// the largest and the least factor, are proved as those of an uncertain load are, by a stress state
// and a motion each.
#pragma once

#include <vector>

#include "nodes/limit/root/limit_answer.hpp"
#include "nodes/limit/root/root_search.hpp"
#include "verify/limit/truss_certificate.hpp"
#include "verify/structure/structure.hpp"

namespace kusabi::limit {

struct NominalProof {
  NominalFactors factors;  ///< on every rank
  LimitCollapse collapse;  ///< at the largest factor, with its least one
  /// The proved theorems on rank 0: none on the least factor without one on the largest.
  std::vector<verify::TrussTheorem> theorems;
};

/// Every rank makes the same call. @pre search.is_set_up(), and is again
/// unless it was stopped
NominalProof prove_nominal(RootSearch& search, const verify::Structure& truss);

}  // namespace kusabi::limit
