// Proofs for each block, and the blocks of each node.
#include "verify/wedged/proof.hpp"

#include <utility>

#include "verify/structure/projected_stiffness.hpp"

namespace kusabi::verify {

using support::IndexSet;

IndexSet within(const IndexSet& block, const IndexSet& set) {
  IndexSet result;
  int number = 0;
  for (const int candidate : block) {
    if (set.contains(candidate)) result.insert(number);
    ++number;
  }
  return result;
}

ContactBlock contact_block(const Certificate& certificate, const EnclosedMatrix& stiffness,
                           const ContactMotions& motions, const IndexSet& block,
                           const std::vector<EnclosedLoad>& loads) {
  const auto d = certificate.dimension;
  ContactBlock result;
  result.dimension = d;
  std::vector<std::size_t> rows;
  for (const int number : block) {
    const auto candidate = static_cast<std::size_t>(number);
    result.friction.push_back(certificate.friction[candidate]);
    result.names.push_back(certificate.names[candidate]);
    for (std::size_t k = 0; k < d; ++k) rows.push_back(d * candidate + k);
  }
  const auto& [middle, radius] = stiffness;
  result.stiffness.radius = radius;
  result.stiffness.middle.size = rows.size();
  auto& entries = result.stiffness.middle.entries;
  entries.exponent = middle.entries.exponent;
  for (const auto row : rows) {
    for (const auto column : rows) {
      entries.mantissas.push_back(middle.entries.mantissas[middle.size * row + column]);
    }
  }
  result.motions = part_of(motions, rows);
  const auto columns = certificate.motions_of(block);
  for (const auto row : rows) {
    for (const auto k : columns)
      result.recorded_motions.push_back(certificate.motion_values[certificate.motions * row + k]);
  }
  for (const auto& [condensed, work, acts] : loads) {
    auto& own = result.loads.emplace_back();
    own.forces = DyadicList(rows.size());
    own.forces.exponent = condensed.forces.exponent;
    for (std::size_t k = 0; k < rows.size(); ++k)
      own.forces.mantissas[k] = condensed.forces.mantissas[rows[k]];
    own.error = condensed.error;
    for (const auto k : columns_of(motions, rows)) own.work.push_back(work.of_candidates[k]);
  }
  return result;
}

EnclosedMatrix recorded_stiffness(const Certificate& certificate) {
  EnclosedMatrix recorded{{certificate.displacements(), DyadicList(certificate.stiffness)},
                          Dyadic()};
  if (certificate.motions == 0) return recorded;
  return projected(recorded, recorded_motions(certificate.motion_values, certificate.motions));
}

Proof::Proof(const Certificate& certificate)
    : Proof(certificate, recorded_stiffness(certificate),
            recorded_motions(certificate.motion_values, certificate.motions)) {}

Proof::Proof(const Certificate& certificate, const EnclosedMatrix& stiffness,
             const ContactMotions& motions)
    : certificate_(certificate) {
  for (const auto& block : certificate.blocks) {
    auto own_part = contact_block(certificate, stiffness, motions, block);
    if (own_part.motions.count != certificate.motions_of(block).size()) {
      minimum_.reset();
      return;
    }
    blocks_.emplace_back(std::move(own_part));
    const auto& own = blocks_.back().min_eigenvalue();
    if (!own) {
      minimum_.reset();
      return;
    }
    if (!minimum_ || *own < *minimum_) minimum_ = own;
  }
}

std::optional<std::string> Proof::add_bound(const CandidateBound& bound) {
  const auto& block = certificate_.blocks[bound.block];
  if (!block.contains(bound.candidate)) return "its candidate is not in its block";
  const auto own = within(block, support::IndexSet::single(bound.candidate)).lowest();
  return blocks_[bound.block].add_bound(static_cast<std::size_t>(own), bound.side, bound.maximum,
                                        bound.numbers);
}

ProofResult Proof::proof_result(const Record& record) const {
  const auto& block = certificate_.blocks[record.block];
  const auto contact = within(block, record.contact);
  const auto separated = within(block, record.separated);
  const auto& proof = blocks_[record.block];
  switch (record.claim) {
    case Claim::infeasible:
      return proof.prove_infeasible(contact, separated, record.numbers);
    case Claim::cut:
      return proof.prove_by_cuts(contact, separated, record.numbers);
    case Claim::form:
      return proof.prove_by_form(record.numbers);
    case Claim::feasible:
      return {proof.refusal_of_feasible(contact, record.numbers)};
    default:
      return {.unloaded = proof.leaves_a_contact_unloaded(contact, separated)};
  }
}

}  // namespace kusabi::verify
