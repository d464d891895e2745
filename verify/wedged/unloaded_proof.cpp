// Contacts whose reaction is zero by equilibrium: for an unconstrained body in space with reactions
// at two points, they act along the line between them, and a third point whose friction cone does
// not contain a direction in a plane through this line has none.
#include "verify/wedged/block_proof.hpp"

namespace kusabi::verify {

using support::IndexSet;

bool BlockProof::leaves_a_contact_unloaded(const IndexSet& contact,
                                           const IndexSet& separated) const {
  // Larger sets are not tried: all pairs are examined, and few such nodes have this property.
  constexpr std::size_t max_carrying = 64;
  std::vector<std::size_t> carrying;
  for (std::size_t i = 0; i < candidates(); ++i) {
    if (!contains(separated, i)) carrying.push_back(i);
  }
  if (motions() == 0 || carrying.size() > max_carrying) return false;
  const auto fixed_at = [&](std::size_t candidate, Elimination motions) {
    for (std::size_t k = 0; k < block_.dimension; ++k)
      motions.add_equation(block_.motions.rows[block_.dimension * candidate + k]);
    return motions;
  };
  for (std::size_t a = 0; a < carrying.size(); ++a) {
    const auto one = fixed_at(carrying[a], Elimination(motions()));
    for (std::size_t b = a + 1; b < carrying.size(); ++b) {
      const auto both = fixed_at(carrying[b], one);
      if (both.basis().size() == 1 && all_work_against(both.basis().front(), carrying, contact))
        return true;
    }
  }
  return false;
}

bool BlockProof::all_work_against(const Rationals& motion, const std::vector<std::size_t>& carrying,
                                  const IndexSet& contact) const {
  const auto w = restricted_to_candidates(block_.motions, motion);
  int sign = 0;
  bool any_in_contact = false;
  for (const auto i : carrying) {
    bool moves = false;
    for (std::size_t k = 0; k < block_.dimension; ++k)
      moves = moves || sgn(dot(block_.motions.rows[block_.dimension * i + k], motion)) != 0;
    if (!moves) continue;
    const auto normal = w.values[block_.dimension * i];
    if (sign == 0) sign = normal.sign();
    if (normal.sign() == 0 || normal.sign() != sign) return false;
    if (!(absolute(normal) > slip_above(w.values, i, w.error))) return false;
    any_in_contact = any_in_contact || contains(contact, i);
  }
  return any_in_contact;
}

}  // namespace kusabi::verify
