// Feasible leaves: a configuration in the interior of the cone of a sign pattern.
#include <cmath>
#include <utility>

#include "verify/arithmetic/balance.hpp"
#include "verify/wedged/block_proof.hpp"

namespace kusabi::verify {

using support::IndexSet;

namespace {

/// Binary digits of the sum of the normal reactions, where it is requested.
constexpr int sum_digits = 30;

}  // namespace

std::optional<std::string> BlockProof::refusal_of_feasible(const IndexSet& contact,
                                                           const IndexSet& /*separated*/,
                                                           std::span<const double> numbers) const {
  if (contact.empty()) return "the leaf has no candidate in contact";
  return refusal_of_leaf({contact, {}, {}, {}, {}, {}, {}, {}}, numbers);
}

std::optional<std::string> BlockProof::refusal_of_leaf(Leaf leaf,
                                                       std::span<const double> numbers) const {
  const auto& contact = leaf.contact;
  const auto* stiffness = regularised_at_normals(contact);
  if (stiffness == nullptr) {
    auto [springs, sliding] = grounding(contact);
    leaf.sliding = std::move(sliding);
    stiffness = &regularised(springs);
  }
  if (auto why = read_leaf(numbers, leaf)) return why;
  if (!stiffness->min_eigenvalue())
    return "K is not proved to be positive definite if its contacts are fixed along their normals";
  return stiffness->solve(leaf.unknowns, leaf.right,
                          [&](const auto& u, const auto& r, const auto& off) {
                            return check_feasible(*stiffness, leaf, u, r, off);
                          });
}

std::optional<std::string> BlockProof::read_leaf(std::span<const double> numbers,
                                                 Leaf& leaf) const {
  const auto d = block_.dimension;
  const auto size = d * candidates();
  std::vector<double> right(size, 0);
  std::vector<double> room(size, 0);
  auto number = numbers.begin();
  for (std::size_t i = 0; i < candidates(); ++i) {
    const bool contact = contains(leaf.contact, i);
    for (std::size_t k = contact ? 1 : 0; k < d; ++k) {
      leaf.unknowns.push_back(d * i + k);
      if (!contact) continue;
      if (block_.friction[i] == 0 && *number != 0) {
        return block_.names[i] + " has no friction, but a tangential reaction";
      }
      room[d * i + k] = block_.friction[i] == 0 ? 0 : 1;
      right[d * i + k] = *number++;
    }
  }
  leaf.right = DyadicList(right);
  if (motions() > 0) leaf.mean = own_coefficients(numbers.last(motions()));
  if (!leaf.sliding.empty()) {
    if (auto why = balance_sliding(room, leaf)) return why;
  }
  leaf.tangential = leaf.right;
  if (leaf.forces.size() > 0) {
    leaf.right += leaf.forces;
    leaf.right_error = leaf.right_error + leaf.force_error;
  }
  return {};
}

std::optional<std::string> BlockProof::balance_sliding(const std::vector<double>& room,
                                                       Leaf& leaf) const {
  constexpr auto not_balanced = "its tangential reactions are not in equilibrium";
  const auto size = room.size();
  // Modes that displace tangents of U. The other sliding modes must displace nothing on U.
  Elimination unseen(leaf.sliding);
  std::vector<std::size_t> tangents;
  for (std::size_t row = 0; row < size; ++row) {
    if (room[row] != 0) tangents.push_back(row);
  }
  std::vector<std::size_t> chosen;
  demand_largest(tangents, 0, unseen, chosen);
  for (const int i : leaf.contact) {
    const auto normal = block_.dimension * static_cast<std::size_t>(i);
    if (unseen.add_equation(block_.motions.rows[normal])) return not_balanced;
  }
  for (const auto& motion : unseen.basis()) {  // no reaction of U does work on it
    if (!leaf.work.empty() && sgn(dot(leaf.work, motion)) != 0)
      return "its load does work on a rigid-body mode that no contact resists";
  }
  const auto& seen = unseen.removed();
  std::vector<Rationals> rows;
  Rationals forces;
  for (std::size_t row = 0; row < size; ++row) {
    auto& own = rows.emplace_back();
    for (const auto& motion : seen) own.push_back(dot(block_.motions.rows[row], motion));
    forces.emplace_back(leaf.right[row].nearest() / block_.motions.lengths[row].nearest());
  }
  auto own_room = room;
  if (!leaf.work.empty()) {  // the load is one more force, which is not changed
    auto& own = rows.emplace_back();
    for (const auto& motion : seen) own.push_back(dot(leaf.work, motion));
    forces.emplace_back(1);
    own_room.push_back(0);
  }
  auto exact = balanced(rows, std::move(forces), own_room);
  if (!exact) return not_balanced;
  exact->resize(size);
  rows.resize(size);
  auto near = times_lengths(block_.motions, *exact);
  leaf.right = std::move(near.values);
  leaf.right_error = near.error * Dyadic(static_cast<double>(size));
  if (!add_corrections(rows, tangents, seen, leaf)) return not_balanced;
  return {};
}

bool BlockProof::add_corrections(const std::vector<Rationals>& rows,
                                 const std::vector<std::size_t>& tangents,
                                 const std::vector<Rationals>& modes, Leaf& leaf) const {
  const auto size = rows.size();
  const auto motions = modes.size();
  std::vector<Rationals> products(motions, Rationals(motions));
  for (const auto row : tangents) {
    for (std::size_t i = 0; i < motions; ++i) {
      for (std::size_t j = 0; j < motions; ++j) products[i][j] += rows[row][i] * rows[row][j];
    }
  }
  for (std::size_t motion = 0; motion < motions; ++motion) {
    leaf.lift = leaf.lift +
                normal_size(restricted_to_candidates(block_.motions, modes[motion]), leaf.contact);
    Rationals unit(motions);
    unit[motion] = 1;
    const auto shares = solution(products, unit);
    if (!shares) return false;
    Rationals carrying(size);
    for (const auto row : tangents) carrying[row] = dot(rows[row], *shares);
    const auto correction = times_lengths(block_.motions, carrying);
    leaf.correction = leaf.correction + norm_above(correction.values) +
                      correction.error * Dyadic(static_cast<double>(size));
  }
  return true;
}

Dyadic BlockProof::normal_size(const ApproximateList& displacements,
                               const IndexSet& contact) const {
  Dyadic sum;
  for (const int i : contact) {
    const auto row = block_.dimension * static_cast<std::size_t>(i);
    sum = sum + absolute(displacements.values[row]) + displacements.error;
  }
  return sum;
}

std::optional<Dyadic> BlockProof::error_of_lift(const RegularisedStiffness& stiffness,
                                                const Leaf& leaf, const ApproximateList& shift,
                                                const Dyadic& pressures) const {
  const auto& s = *stiffness.min_eigenvalue();
  const auto change = (leaf.lift * leaf.correction).scaled(1);
  if (!(s > change * stiffness.norm())) return {};
  const auto gap = stiffness.norm() * normal_size(shift, leaf.contact).scaled(1);
  return gap + change * (pressures + quotient_above(stiffness.norm() * gap, s));
}

std::optional<std::string> BlockProof::check_feasible(const RegularisedStiffness& stiffness,
                                                      const Leaf& leaf, const DyadicList& u,
                                                      const DyadicList& r,
                                                      const Dyadic& unknown) const {
  const auto d = block_.dimension;
  const auto& s = *stiffness.min_eigenvalue();
  Dyadic rest_squared;
  for (const auto row : leaf.unknowns) {
    rest_squared = rest_squared + square(r[row] - leaf.right[row]);
  }
  auto right_error = leaf.right_error;
  auto rest = sqrt_above(rest_squared) + unknown + right_error;  // s times the error of u
  auto error = stiffness.norm() * rest + s * unknown;            // s times the error of K u
  auto reaction = r;                                             // K u minus the load
  if (leaf.forces.size() > 0) {
    auto forces = leaf.forces;
    for (auto& mantissa : forces.mantissas) mantissa = -mantissa;
    reaction += std::move(forces);
    error = error + s * leaf.force_error;
  }
  auto moved = u;
  Dyadic off;
  if (!leaf.sliding.empty()) {
    auto shift = restricted_to_candidates(block_.motions, missing(leaf.mean, u, leaf.sliding));
    const auto pressures = normal_size({reaction, quotient_above(error, s)}, leaf.contact);
    const auto lifted = error_of_lift(stiffness, leaf, shift, pressures);
    if (!lifted) return "its sliding modes displace the contacts along their normals by too much";
    right_error = right_error + *lifted;
    rest = rest + *lifted;
    error = error + stiffness.norm() * *lifted;
    off = s * shift.error;
    moved += std::move(shift.values);
  }
  Dyadic sum;  // s times the sum of the normal reactions, and its error
  Dyadic spread;
  for (std::size_t i = 0; i < candidates(); ++i) {
    const auto& name = block_.names[i];
    if (!contains(leaf.contact, i)) {
      const auto gap = leaf.gaps.size() > 0 ? moved[d * i] + leaf.gaps[i] : moved[d * i];
      if (!(s * gap > rest + off)) return name + " is not proved to separate";
      continue;
    }
    sum = sum + s * reaction[d * i];
    spread = spread + error;
    const auto pressure = s * reaction[d * i] - error;
    if (pressure.sign() <= 0) return name + " is not pressed against the obstacle";
    if (friction_[i].sign() == 0) continue;  // r_t = 0 is required
    const auto shear = s * (sqrt_above(tangential_square(leaf.tangential, i)) + right_error);
    if (!(friction_[i] * pressure > shear)) return name + " slips, or is at the limit of friction";
  }
  if (leaf.grip != nullptr) {
    if (spread.scaled(sum_digits) > sum) return "the sum of its normal reactions is not known";
    *leaf.grip = {(sum - spread).rational() / s.rational(),
                  (sum + spread).rational() / s.rational()};
  }
  return {};
}

}  // namespace kusabi::verify
