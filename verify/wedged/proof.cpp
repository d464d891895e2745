// Proofs for each block, and the blocks of each node.
#include "verify/wedged/proof.hpp"

#include <algorithm>
#include <utility>

#include "verify/structure/projected_stiffness.hpp"

namespace kusabi::verify {

using support::IndexSet;

namespace {

// A set of candidates in the numbering of a block.
IndexSet within(const IndexSet& block, const IndexSet& set) {
  IndexSet result;
  int number = 0;
  for (const int candidate : block) {
    if (set.contains(candidate)) result.insert(number);
    ++number;
  }
  return result;
}

// The problem of a block.
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
  if (!loads.empty()) {
    for (const int candidate : block)
      result.clearance.push_back(certificate.loads->clearance[static_cast<std::size_t>(candidate)]);
  }
  return result;
}

Proof::Actions actions_on(const IndexSet& block, const Certificate& certificate,
                          const std::vector<EnclosedLoad>& loads) {
  Proof::Actions actions;
  for (const int number : block) {
    const auto candidate = static_cast<std::size_t>(number);
    actions.dead =
        actions.dead || certificate.loads->clearance[candidate] != 0 || loads[0].acts[candidate];
    actions.reference = actions.reference || loads[1].acts[candidate];
  }
  return actions;
}

}  // namespace

EnclosedMatrix recorded_stiffness(const Certificate& certificate) {
  EnclosedMatrix recorded{{certificate.displacements(), DyadicList(certificate.stiffness)},
                          Dyadic()};
  if (certificate.motions == 0) return recorded;
  return projected(recorded, recorded_motions(certificate.motion_values, certificate.motions));
}

std::vector<EnclosedLoad> recorded_loads(const Certificate& certificate) {
  std::vector<EnclosedLoad> loads;
  if (!certificate.loads) return loads;
  const auto d = certificate.dimension;
  for (const auto* const forces : {&certificate.loads->dead, &certificate.loads->reference}) {
    EnclosedLoad load{{DyadicList(*forces), Dyadic()}, {}, {}};
    load.work.of_candidates.resize(certificate.motions);
    load.acts.resize(certificate.candidates());
    for (std::size_t row = 0; row < forces->size(); ++row) {
      for (std::size_t k = 0; k < certificate.motions; ++k)
        load.work.of_candidates[k] +=
            mpq_class((*forces)[row]) *
            mpq_class(certificate.motion_values[certificate.motions * row + k]);
    }
    for (const auto& block : certificate.blocks) {
      const bool acts = std::ranges::any_of(block, [&](int candidate) {
        const auto first = d * static_cast<std::size_t>(candidate);
        return std::any_of(forces->begin() + static_cast<std::ptrdiff_t>(first),
                           forces->begin() + static_cast<std::ptrdiff_t>(first + d),
                           [](double force) { return force != 0; });
      });
      for (const int candidate : block) load.acts[static_cast<std::size_t>(candidate)] = acts;
    }
    loads.push_back(std::move(load));
  }
  return loads;
}

Proof::Proof(const Certificate& certificate)
    : Proof(certificate, recorded_stiffness(certificate),
            recorded_motions(certificate.motion_values, certificate.motions),
            recorded_loads(certificate)) {}

Proof::Proof(const Certificate& certificate, const EnclosedMatrix& stiffness,
             const ContactMotions& motions, const std::vector<EnclosedLoad>& loads)
    : certificate_(certificate) {
  for (const auto& load : loads) work_.push_back(load.work);
  for (const auto& block : certificate.blocks) {
    auto own_part = contact_block(certificate, stiffness, motions, block, loads);
    if (own_part.motions.count != certificate.motions_of(block).size()) {
      minimum_.reset();
      return;
    }
    if (!loads.empty()) {
      actions_.push_back(actions_on(block, certificate, loads));
      actions_.back().unconstrained = own_part.motions.count > 0;
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
  const auto& theorem = certificate_.theorems[bound.theorem];
  const auto& block = certificate_.blocks[theorem.block];
  if (!block.contains(bound.candidate)) return "its candidate is not in its block";
  const auto own = within(block, support::IndexSet::single(bound.candidate)).lowest();
  const auto& proof = blocks_[theorem.block];
  const auto place = bounds_.try_emplace(bound.theorem, proof.no_bounds());
  return proof.add_bound(theorem, bound, static_cast<std::size_t>(own), place.first->second);
}

ProofResult Proof::proof_result(const Node& node) const {
  const auto& theorem = certificate_.theorems[node.theorem];
  const auto& block = certificate_.blocks[theorem.block];
  const auto contact = within(block, node.contact);
  const auto separated = within(block, node.separated);
  const auto& proof = blocks_[theorem.block];
  const auto bounds = bounds_.find(node.theorem);
  switch (node.claim) {
    case Claim::infeasible:
      return proof.prove_infeasible(theorem, contact, separated, node.numbers);
    case Claim::cut:
      return proof.prove_by_cuts(theorem,
                                 bounds != bounds_.end() ? bounds->second : proof.no_bounds(),
                                 contact, separated, node.numbers);
    case Claim::form:
      return proof.prove_by_form(node.numbers);
    case Claim::none:
      break;
  }
  return {.unloaded =
              theorem.about_wedged() && proof.leaves_a_contact_unloaded(contact, separated)};
}

bool Proof::is_unbalanced(LoadShare share) const {
  const auto& dead = work_[0].others;
  const auto& reference = work_[1].others;
  for (std::size_t mode = 0; mode < dead.size(); ++mode) {
    const mpq_class work =
        mpq_class(share.dead) * dead[mode] + mpq_class(share.reference) * reference[mode];
    if (sgn(work) != 0) return true;
  }
  return false;
}

std::optional<std::string> Proof::refusal(const State& state, Grip* grip) const {
  const auto contact = within(certificate_.blocks[state.block], state.contact);
  const auto& proof = blocks_[state.block];
  if (!state.share) return proof.refusal_of_feasible(contact, state.numbers);
  if (is_unbalanced(*state.share))
    return "its load does work on a motion that displaces no candidate";
  return proof.refusal_of_held_state(contact, *state.share, state.numbers, grip);
}

bool Proof::closes_gaps(std::size_t block, const IndexSet& contact) const {
  return blocks_[block].closes_gaps(within(certificate_.blocks[block], contact));
}

bool Proof::holds_every_load(const State& state) const {
  return !state.share && blocks_[state.block].resists_all_motions(
                             within(certificate_.blocks[state.block], state.contact));
}

}  // namespace kusabi::verify
