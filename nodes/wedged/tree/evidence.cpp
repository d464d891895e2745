// Counts of accepted and refused claims.
#include "nodes/wedged/tree/evidence.hpp"

namespace kusabi::wedged {

bool EvidenceGate::passes(const Evidence& claim, SignPatternTally& tally) const {
  const bool accepted = !test_ || test_(claim);
  if (!accepted) {
    ++tally.refused;
    if (binding_) return false;
    if (claim.kind != Evidence::Kind::feasible) ++tally.closed_unproved;
  } else if (claim.kind == Evidence::Kind::feasible) {
    ++tally.proved;
  }
  if (recorder_) recorder_(claim);
  return true;
}

void EvidenceGate::pass_open(const Evidence& node, SignPatternTally& tally) const {
  if (!test_ || !test_(node)) ++tally.unproved;
  if (recorder_) recorder_(node);
}

}  // namespace kusabi::wedged
