// Counts of accepted and refused claims.
#include "nodes/wedged/tree/evidence.hpp"

namespace kusabi::wedged {

bool EvidenceGate::passes(const Evidence& claim, SignPatternTally& tally) const {
  const auto proof = test_ ? test_(claim) : NodeProof::complete;
  if (proof == NodeProof::except_large_displacements) ++tally.except_large_displacements;
  if (proof == NodeProof::refused) {
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
  if (!test_ || test_(node) == NodeProof::refused) ++tally.unproved;
  if (recorder_) recorder_(node);
}

}  // namespace kusabi::wedged
