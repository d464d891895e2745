// Feasible leaves: a configuration in the interior of the cone of a sign pattern.
#include <cmath>
#include <utility>

#include "verify/arithmetic/balance.hpp"
#include "verify/wedged/block_proof.hpp"

namespace kusabi::verify {

using support::IndexSet;

std::optional<std::string> BlockProof::refusal_of_feasible(const IndexSet& contact,
                                                           const IndexSet& /*separated*/,
                                                           std::span<const double> numbers) const {
  if (contact.empty()) return "no candidate is in contact";
  Leaf leaf{contact, {}, {}, {}, {}, {}, {}, {}};
  const auto* stiffness = held_at_normals(contact);
  if (stiffness == nullptr) {
    auto [springs, sliding] = hold(contact);
    leaf.sliding = std::move(sliding);
    stiffness = &held(springs);
  }
  if (auto why = read_leaf(numbers, leaf)) return why;
  if (!stiffness->least_eigenvalue())
    return "K is not proved to be definite with its contacts fixed";
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
    const bool contact = holds(leaf.contact, i);
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
  if (leaf.sliding.empty()) return {};
  return balance_sliding(room, leaf);
}

std::optional<std::string> BlockProof::balance_sliding(const std::vector<double>& room,
                                                       Leaf& leaf) const {
  constexpr auto not_balanced = "its tangential reactions are not in equilibrium";
  const auto size = room.size();
  const Dyadic entries(static_cast<double>(size));
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
    if (unseen.demand(block_.motions.rows[normal])) return not_balanced;
  }
  const auto& seen = unseen.taken();
  const auto motions = seen.size();
  std::vector<Rationals> rows;
  Rationals forces;
  for (std::size_t row = 0; row < size; ++row) {
    auto& own = rows.emplace_back();
    for (const auto& motion : seen) own.push_back(dot(block_.motions.rows[row], motion));
    forces.emplace_back(leaf.right[row].nearest() / block_.motions.lengths[row].nearest());
  }
  const auto exact = balanced(rows, std::move(forces), room);
  if (!exact) return not_balanced;
  auto near = times_lengths(block_.motions, *exact);
  leaf.right = std::move(near.values);
  leaf.right_error = near.error * entries;
  // Tangential reactions with unit work on each of the sliding modes.
  std::vector<Rationals> products(motions, Rationals(motions));
  for (const auto row : tangents) {
    for (std::size_t i = 0; i < motions; ++i) {
      for (std::size_t j = 0; j < motions; ++j) products[i][j] += rows[row][i] * rows[row][j];
    }
  }
  for (std::size_t motion = 0; motion < motions; ++motion) {
    leaf.lift = leaf.lift + normal_size(seen_of(block_.motions, seen[motion]), leaf.contact);
    Rationals unit(motions);
    unit[motion] = 1;
    const auto shares = solution(products, unit);
    if (!shares) return not_balanced;
    Rationals carrying(size);
    for (const auto row : tangents) carrying[row] = dot(rows[row], *shares);
    const auto correction = times_lengths(block_.motions, carrying);
    leaf.correction = leaf.correction + norm_above(correction.values) + correction.error * entries;
  }
  return {};
}

Dyadic BlockProof::normal_size(const NearList& displacements, const IndexSet& contact) const {
  Dyadic sum;
  for (const int i : contact) {
    const auto row = block_.dimension * static_cast<std::size_t>(i);
    sum = sum + absolute(displacements.values[row]) + displacements.error;
  }
  return sum;
}

std::optional<Dyadic> BlockProof::error_of_lift(const RegularisedStiffness& held, const Leaf& leaf,
                                                const NearList& shift,
                                                const Dyadic& pressures) const {
  const auto& s = *held.least_eigenvalue();
  const auto change = (leaf.lift * leaf.correction).scaled(1);
  if (!(s > change * held.size())) return {};
  const auto gap = held.size() * normal_size(shift, leaf.contact).scaled(1);
  return gap + change * (pressures + quotient_above(held.size() * gap, s));
}

std::optional<std::string> BlockProof::check_feasible(const RegularisedStiffness& held,
                                                      const Leaf& leaf, const DyadicList& u,
                                                      const DyadicList& r,
                                                      const Dyadic& unknown) const {
  const auto d = block_.dimension;
  const auto& s = *held.least_eigenvalue();
  Dyadic rest_squared;
  for (const auto row : leaf.unknowns) {
    rest_squared = rest_squared + square(r[row] - leaf.right[row]);
  }
  auto right_error = leaf.right_error;
  auto rest = sqrt_above(rest_squared) + unknown + right_error;  // s times the error of u
  auto error = held.size() * rest + s * unknown;                 // s times the error of r_n
  auto moved = u;
  Dyadic off;
  if (!leaf.sliding.empty()) {
    auto shift = seen_of(block_.motions, missing(leaf.mean, u, leaf.sliding));
    const auto pressures = normal_size({r, quotient_above(error, s)}, leaf.contact);
    const auto lifted = error_of_lift(held, leaf, shift, pressures);
    if (!lifted) return "its sliding modes displace the contacts along their normals by too much";
    right_error = right_error + *lifted;
    rest = rest + *lifted;
    error = error + held.size() * *lifted;
    off = s * shift.error;
    moved += std::move(shift.values);
  }
  for (std::size_t i = 0; i < candidates(); ++i) {
    const auto& name = block_.names[i];
    if (!holds(leaf.contact, i)) {
      if (!(s * moved[d * i] > rest + off)) return name + " does not separate";
      continue;
    }
    const auto pressure = s * r[d * i] - error;
    if (pressure.sign() <= 0) return name + " is not pressed against the obstacle";
    if (friction_[i].sign() == 0) continue;  // r_t = 0 is required
    const auto shear = s * (sqrt_above(tangential_square(leaf.right, i)) + right_error);
    if (!(friction_[i] * pressure > shear)) return name + " slips, or is about to";
  }
  return {};
}

}  // namespace kusabi::verify
