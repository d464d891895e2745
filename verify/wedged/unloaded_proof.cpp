// Motions that fix two candidates, and the work of all others on them.
#include "verify/wedged/unloaded_proof.hpp"

#include <vector>

namespace kusabi::verify {

using support::IndexSet;

namespace {

// True if the reactions of all candidates displaced by a mode do negative work on it or on its
// opposite, and at least one of them is in U.
bool all_work_against(const BlockModel& model, const Rationals& motion,
                      const std::vector<std::size_t>& carrying, const IndexSet& contact) {
  const auto& block = model.block();
  const auto w = restricted_to_candidates(block.motions, motion);
  int sign = 0;
  bool any_in_contact = false;
  for (const auto i : carrying) {
    bool moves = false;
    for (std::size_t k = 0; k < block.dimension; ++k)
      moves = moves || sgn(dot(block.motions.rows[block.dimension * i + k], motion)) != 0;
    if (!moves) continue;
    const auto normal = w.values[block.dimension * i];
    if (sign == 0) sign = normal.sign();
    if (normal.sign() == 0 || normal.sign() != sign) return false;
    if (!(absolute(normal) > model.slip_above(w.values, i, w.error))) return false;
    any_in_contact = any_in_contact || contains(contact, i);
  }
  return any_in_contact;
}

}  // namespace

bool leaves_a_contact_unloaded(const BlockModel& model, const IndexSet& contact,
                               const IndexSet& separated) {
  const auto& block = model.block();
  // Larger sets are not tried: all pairs are examined, and few such nodes have this property.
  constexpr std::size_t max_carrying = 64;
  std::vector<std::size_t> carrying;
  for (std::size_t i = 0; i < model.candidates(); ++i) {
    if (!contains(separated, i)) carrying.push_back(i);
  }
  if (model.motions() == 0 || carrying.size() > max_carrying) return false;
  const auto fixed_at = [&](std::size_t candidate, Elimination motions) {
    for (std::size_t k = 0; k < block.dimension; ++k)
      motions.add_equation(block.motions.rows[block.dimension * candidate + k]);
    return motions;
  };
  for (std::size_t a = 0; a < carrying.size(); ++a) {
    const auto one = fixed_at(carrying[a], Elimination(model.motions()));
    for (std::size_t b = a + 1; b < carrying.size(); ++b) {
      const auto both = fixed_at(carrying[b], one);
      if (both.basis().size() == 1 &&
          all_work_against(model, both.basis().front(), carrying, contact))
        return true;
    }
  }
  return false;
}

}  // namespace kusabi::verify
