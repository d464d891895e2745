// A certificate without nodes, and one record at a time.
#include "nodes/wedged/evidence_check.hpp"

#include "nodes/evidence/verified_structure.hpp"
#include "problems/wedged/problem_block.hpp"
#include "verify/condensation.hpp"

namespace kusabi::wedged {

std::variant<verify::EnclosedMatrix, std::string> enclosed_stiffness(
    const problems::Structure& structure) {
  if (structure.coordinates.size() > most_enclosed_displacements)
    return "the structure is too large to enclose its stiffness on the way; verify does it";
  return verify::condensed_stiffness(evidence::verified_structure(structure));
}

EvidenceCheck::EvidenceCheck(const problems::WedgedProblem& problem,
                             const verify::EnclosedMatrix& stiffness,
                             std::span<const double> friction) {
  certificate_.dimension = static_cast<std::size_t>(problem.dimension);
  certificate_.names = problem.contact_names;
  certificate_.friction = {friction.begin(), friction.end()};
  certificate_.blocks = problems::blocks_of(problem);
  proof_.emplace(certificate_, stiffness);
}

bool EvidenceCheck::holds(const Evidence& evidence) const {
  if (evidence.kind == Evidence::Kind::marginal || !proof_->least_eigenvalue()) return false;
  verify::Record record;
  record.claim = evidence.kind == Evidence::Kind::dead ? verify::Claim::dead : verify::Claim::alive;
  record.block = evidence.block;
  record.contact = evidence.node.contact;
  record.separated = evidence.node.separated;
  record.numbers = {evidence.numbers.begin(), evidence.numbers.end()};
  return !proof_->refusal(record);
}

}  // namespace kusabi::wedged
