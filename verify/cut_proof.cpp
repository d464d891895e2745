// Dead nodes for which the bounds of single candidates are needed, and the proofs of these bounds:
// nodes with the opposite of the bound as one inequality more.
#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "verify/block_proof.hpp"

namespace kusabi::verify {

using support::IndexSet;

namespace {

constexpr auto too_large = "its numbers are too large to compute with";

bool all_finite_numbers(std::span<const double> numbers) {
  return std::all_of(numbers.begin(), numbers.end(), [](double x) { return std::isfinite(x); });
}

// The least double that is known not to be below a number.
double double_above(const Dyadic& number) {
  if (number.sign() == 0) return 0;
  return std::nextafter(number.nearest(), std::numeric_limits<double>::infinity());
}

}  // namespace

Judgement BlockProof::judge_cut(const IndexSet& contact, const IndexSet& separated,
                                std::span<const double> numbers) const {
  return {refusal_of_combination({.contact = contact,
                                  .separated = separated,
                                  .multipliers = numbers.first(candidates()),
                                  .of_cuts = numbers.subspan(candidates(), candidates()),
                                  .opposite = {}})};
}

std::optional<std::string> BlockProof::take_up(std::size_t candidate, Side side,
                                               const std::optional<double>& most,
                                               std::span<const double> numbers) {
  Combination combination{.contact = {},
                          .separated = {},
                          .multipliers = numbers.first(candidates()),
                          .of_cuts = numbers.subspan(candidates(), candidates()),
                          .opposite = {}};
  (side == Side::contact ? combination.contact : combination.separated)
      .insert(static_cast<int>(candidate));
  if (most) {
    const double theta = numbers.back();
    if (!std::isfinite(*most) || *most <= 0 || !std::isfinite(theta) || theta <= 0) {
      return "a bound and the multiplier of its opposite must be above zero";
    }
    combination.opposite = {candidate, side, Dyadic(theta), Dyadic(theta) * Dyadic(*most)};
  }
  auto refusal = refusal_of_combination(combination);
  if (refusal) return refusal;
  if (most) {
    bounds_.limit(candidate, side, *most);
  } else {
    bounds_.exclude(candidate, side);
  }
  return {};
}

std::optional<std::string> BlockProof::refusal_of_combination(Combination combination) const {
  if (motions() > 0) return "bounds are proved of blocks without motions only";
  const auto y = combination.multipliers;
  const auto eta = combination.of_cuts;
  if (!all_finite_numbers(y) || !all_finite_numbers(eta)) return too_large;
  if (std::any_of(eta.begin(), eta.end(), [](double x) { return x < 0; })) {
    return "a multiplier of a cut is negative";
  }
  combination.contact |= bounds_.in_contact();
  combination.separated |= bounds_.separated();
  if (combination.contact.meets(combination.separated) ||
      combination.separated == IndexSet::below(static_cast<int>(candidates()))) {
    return {};  // no candidate is on both sides, and no wedged configuration has r = 0
  }
  const auto all = first_numbers(block_.dimension * candidates());
  std::vector<double> right(all.size(), 0);
  for (std::size_t k = 0; k < candidates(); ++k) {
    auto& own = right[block_.dimension * k];
    own = y[k];
    // As it was recorded but for rounding, and never less than what u_n >= 0 and the cut give.
    if (!holds(combination.contact, k)) {
      own = std::max(own, double_above(Dyadic() - displacement_share(combination, k)));
    }
  }
  if (!all_finite_numbers(right)) return too_large;
  return held_.front().guess(all, DyadicList(right), [&](const auto& w, const auto& nu) {
    return check_combination(combination, w, nu);
  });
}

// What the inequalities give for u_nk, beside nu_nk.
Dyadic BlockProof::displacement_share(const Combination& combination, std::size_t k) const {
  const auto& opposite = combination.opposite;
  const auto cut = Dyadic(combination.of_cuts[k]) * bounds_.gap_share(k);
  const bool opposed = opposite && opposite->side == Side::separated && opposite->candidate == k;
  return opposed ? cut - opposite->multiplier : cut;
}

// sum_k w~_k'r_k >= sum_k (nu_nk + eta_k A_k - theta [k = i, separated]) u_nk + nu_t'u_t, with
// w~_nk = w_nk + sum_l eta_l - eta_k B_k - theta beta + theta [k = i, in contact].
std::optional<std::string> BlockProof::check_combination(const Combination& combination,
                                                         const DyadicList& w,
                                                         const DyadicList& nu) const {
  const auto d = block_.dimension;
  const auto& opposite = combination.opposite;
  Dyadic everywhere;
  for (const double eta : combination.of_cuts) everywhere = everywhere + Dyadic(eta);
  if (opposite) everywhere = everywhere - opposite->of_sum;
  std::vector<Dyadic> added(w.size());
  Dyadic epsilon_squared;
  for (std::size_t k = 0; k < candidates(); ++k) {
    auto& own = added[d * k];
    own = everywhere - Dyadic(combination.of_cuts[k]) * bounds_.reaction_share(k);
    if (opposite && opposite->side == Side::contact && opposite->candidate == k) {
      own = own + opposite->multiplier;
    }
    epsilon_squared = epsilon_squared + tangential_square(nu, k);
    const auto normal = nu[d * k] + displacement_share(combination, k);
    if (!holds(combination.contact, k) && normal.sign() < 0) {
      epsilon_squared = epsilon_squared + square(normal);
    }
  }
  auto lifted = w;
  lifted += DyadicList(added);
  return check_margins(combination.separated, lifted, {},
                       sqrt_above(epsilon_squared) + held_.front().spread(w));
}

}  // namespace kusabi::verify
