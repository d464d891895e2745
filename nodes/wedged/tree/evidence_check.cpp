// A certificate without nodes, and single records.
#include "nodes/wedged/tree/evidence_check.hpp"

#include "nodes/evidence/verified_structure.hpp"
#include "problems/wedged/problem_block.hpp"

namespace kusabi::wedged {

std::variant<verify::EnclosedProblem, std::string> enclosed_stiffness(
    const problems::Structure& structure, const support::LongWork& work) {
  if (structure.coordinates.size() > max_enclosed_displacements)
    return "the structure is too large to enclose its stiffness on the way; verify does it";
  return enclosed_stiffness_without_limit(structure, work);
}

std::variant<verify::EnclosedProblem, std::string> enclosed_stiffness_without_limit(
    const problems::Structure& structure, const support::LongWork& work) {
  return verify::enclosed_problem(evidence::verified_structure(structure), work);
}

verify::Certificate header_of(const problems::WedgedProblem& problem) {
  verify::Certificate header;
  header.dimension = static_cast<std::size_t>(problem.dimension);
  header.names = problem.contact_names;
  header.blocks = problems::blocks_of(problem);
  for (std::size_t block = 0; block < header.blocks.size(); ++block)
    header.theorems.push_back({.block = block});
  header.motions = static_cast<std::size_t>(problem.modes.matrix.cols());
  for (const auto& row : problem.modes.matrix.rowwise())
    header.motion_values.insert(header.motion_values.end(), row.begin(), row.end());
  return header;
}

verify::CandidateBound verified(const ProvedBound& bound, std::size_t theorem) {
  const std::optional maximum(bound.maximum);
  return {.theorem = theorem,
          .candidate = bound.candidate,
          .side = bound.side == Side::contact ? verify::Side::contact : verify::Side::separated,
          .maximum = bound.excludes_side() ? std::nullopt : maximum,
          .numbers = bound.numbers};
}

EvidenceCheck::EvidenceCheck(const problems::WedgedProblem& problem,
                             const verify::EnclosedProblem& enclosed,
                             std::span<const double> friction, std::span<const ProvedBound> bounds,
                             LargeDisplacements large_displacements)
    : large_displacements_(large_displacements), certificate_(header_of(problem)) {
  certificate_.friction = {friction.begin(), friction.end()};
  proof_.emplace(certificate_, enclosed.stiffness, enclosed.motions);
  if (!proof_->min_eigenvalue()) return;
  for (const auto& bound : bounds)  // later ones may depend on one that is refused
    if (proof_->add_bound(verified(bound, bound.theorem))) return;
  proves_bounds_ = true;
}

namespace {

verify::Claim claim_of(Evidence::Kind kind) {
  switch (kind) {
    case Evidence::Kind::infeasible:
      return verify::Claim::infeasible;
    case Evidence::Kind::cut:
      return verify::Claim::cut;
    case Evidence::Kind::form:
      return verify::Claim::form;
    case Evidence::Kind::feasible:
    case Evidence::Kind::no_claim:
      break;
  }
  return verify::Claim::none;
}

}  // namespace

NodeProof EvidenceCheck::proof(const Evidence& evidence) const {
  if (!proof_->min_eigenvalue()) return NodeProof::refused;
  const auto& node = evidence.node;
  const std::vector numbers(evidence.numbers.begin(), evidence.numbers.end());
  if (evidence.kind == Evidence::Kind::feasible) {
    const auto refusal = proof_->refusal({.block = evidence.block,
                                          .contact = node.contact,
                                          .separated = node.separated,
                                          .numbers = numbers});
    return refusal ? NodeProof::refused : NodeProof::complete;
  }
  const auto proof_result = proof_->proof_result({.claim = claim_of(evidence.kind),
                                                  .theorem = evidence.block,
                                                  .contact = node.contact,
                                                  .separated = node.separated,
                                                  .numbers = numbers});
  if (evidence.kind == Evidence::Kind::no_claim)
    return proof_result.unloaded ? NodeProof::complete : NodeProof::refused;
  if (proof_result.refusal) return NodeProof::refused;
  if (!proof_result.except_large_displacements) return NodeProof::complete;
  return large_displacements_ == LargeDisplacements::left_out
             ? NodeProof::except_large_displacements
             : NodeProof::refused;
}

}  // namespace kusabi::wedged
