// Multipliers of the certificate, corrected to equilibrium for unconstrained bodies, and the
// margins that remain after all errors.
#include "verify/wedged/infeasibility_proof.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <tuple>
#include <utility>

namespace kusabi::verify {

using support::IndexSet;

namespace {

// Multipliers below this share of the largest may be positive only because of the barrier of the
// interior-point method.
constexpr double small_multiplier = 1e-6;

// Share of the largest by which a nonnegative multiplier is raised if equilibrium depends on the
// last digits of directions; larger shares are tried if necessary.
constexpr double spare = 0x1p-40;

// Displacements by the recorded motion, relative to the largest, below which a candidate is to be
// at rest: by the sixteen digits of the recorded numbers, and more, where other candidates do not
// move as little.
constexpr double at_rest_by_rounding = 1e-13;
constexpr double nearly_at_rest = 1e-9;

constexpr auto not_in_equilibrium =
    "its multipliers are not in equilibrium, or some are negative where u_n >= 0";

// A double that is not below a number.
double not_below(const Dyadic& number) {
  if (number.sign() == 0) return 0;
  return std::nextafter(number.nearest(), std::numeric_limits<double>::infinity());
}

// Work of a load on a motion, relative to that of a motion whose coefficients are all as large as
// its largest: the recorded motion is converted to other modes, so each of them may have a rounding
// error of the largest.
double work_size(const ActingLoad& load, const std::vector<double>& motion) {
  double sum = 0, size = 0, largest = 0;
  for (std::size_t mode = 0; mode < motion.size(); ++mode) {
    sum += load.work[mode].get_d() * motion[mode];
    size += std::abs(load.work[mode].get_d());
    largest = std::max(largest, std::abs(motion[mode]));
  }
  return size == 0 ? 0 : std::abs(sum) / (size * largest);
}

}  // namespace

InfeasibilityProof::InfeasibilityProof(const BlockModel& model, const ProvedBounds& bounds,
                                       Combination combination)
    : model_(model), block_(model.block()), bounds_(bounds), combination_(std::move(combination)) {
  for (std::size_t k = 0; k < model_.candidates(); ++k) shares_.push_back(displacement_share(k));
}

ProofResult InfeasibilityProof::result() const {
  const bool unloaded =
      combination_.separated == IndexSet::below(static_cast<int>(model_.candidates()));
  if (unloaded && combination_.loads.empty()) return {};  // r = 0 is the only solution
  if (const auto& grip = combination_.grip;
      grip && !(std::isfinite(grip->multiplier) &&
                (grip->kind != GripBound::Kind::above || grip->multiplier >= 0) &&
                (grip->kind != GripBound::Kind::below || grip->multiplier <= 0)))
    return {"the multiplier of the sum has the wrong sign"};
  return model_.motions() == 0 ? ProofResult{refusal_of_constrained()} : prove_unconstrained();
}

ProofResult InfeasibilityProof::prove_unconstrained() const {
  const auto mean = model_.own_coefficients(combination_.mean);
  const EquilibriumMultipliers equilibrium(model_, combination_.contact, combination_.multipliers,
                                           shares_);
  const auto refusal = [&](const std::optional<Multipliers>& y) -> std::optional<std::string> {
    if (!y) return not_in_equilibrium;
    const auto all = first_numbers(block_.dimension * model_.candidates());
    return model_.first_regularised().solve(all, y->near.values,
                                            [&](const auto& w, const auto& nu, const auto& off) {
                                              return check_unconstrained(*y, mean, w, nu, off);
                                            });
  };
  std::optional<std::string> first;
  const auto except_large_displacements = [&] {
    return std::ranges::any_of(std::array{0.0, small_multiplier},
                               [&](double small) { return !refusal(equilibrium.nearly(small)); });
  };
  // If a bound leaves out large displacements, so does this proof, which is tried first then.
  if (!combination_.of_cuts.empty() && bounds_.except_large_displacements() &&
      except_large_displacements())
    return {{}, true};
  // The attempts: all multipliers; without those that are positive only by the barrier; the
  // rigid-body mode alone; with some nonnegative ones raised.
  for (const auto& [small, raised] :
       {std::pair{0.0, 0.0}, {small_multiplier, 0.0}, {2.0, 0.0}, {small_multiplier, spare}}) {
    auto why = refusal(equilibrium.exact(small, raised));
    if (!why) return {};
    if (!first) first = std::move(why);
  }
  for (const double small : {at_rest_by_rounding, nearly_at_rest})
    if (!refusal_of_rigid_motion(mean, small)) return {};
  if (except_large_displacements()) return {{}, true};
  return {first};
}

// The candidates hardly displaced by the recorded motion are those of wedged configurations: w is
// zero there in rational numbers, and their reactions, of any size, do no work on it.
std::optional<std::string> InfeasibilityProof::refusal_of_rigid_motion(
    const std::vector<double>& mean, double small) const {
  if (combination_.loads.empty() || !combination_.of_cuts.empty())
    return "a rigid motion alone excludes loads only, and without cuts";
  if (combination_.grip && combination_.grip->multiplier != 0)
    return "the sum of the reactions has a multiplier";
  Combination rest = combination_;
  const auto d = block_.dimension;
  const auto moved = model_.displacements_by(mean);
  const auto directions = [&](std::size_t i) { return block_.friction[i] == 0 ? 1 : d; };
  std::vector<double> sizes(model_.candidates(), 0);
  for (std::size_t i = 0; i < sizes.size(); ++i)
    for (std::size_t row = d * i; row < d * i + directions(i); ++row)
      sizes[i] = std::max(sizes[i], std::abs(moved[row]));
  const double largest = *std::ranges::max_element(sizes);
  Elimination at_rest(model_.motions());
  for (std::size_t i = 0; i < sizes.size(); ++i) {
    if (contains(rest.separated, i) || sizes[i] > small * largest) continue;
    for (std::size_t row = d * i; row < d * i + directions(i); ++row)
      at_rest.add_equation(block_.motions.rows[row]);
    rest.separated.insert(static_cast<int>(i));  // nothing is left to be ruled out there
  }
  // Loads without the dead one, and the dead one if it does not count alone, may have any amount, if
  // they do no work.
  const auto may_act = [&](const ActingLoad& load) {
    return (load.dead.sign() == 0 || load.excepted) && work_size(load, mean) <= small;
  };
  for (const auto& load : rest.loads)
    if (may_act(load)) at_rest.add_equation(load.work);
  std::erase_if(rest.loads, may_act);
  if (rest.loads.empty()) return "no load is left that would have to act";
  const DyadicList zero(std::vector<Dyadic>(d * sizes.size()));
  const auto motion = model_.missing_motion(mean, zero, at_rest.basis());
  const auto w = restricted_to_candidates(block_.motions, motion);
  // The work of the loads themselves: that of the condensed forces differs by the work on modes that
  // displace no candidate, which only the sum of the loads of a state need not do.
  std::vector<Dyadic> works;
  for (const auto& load : rest.loads) {
    const double work = rounded_up(dot(load.work, motion));
    if (!std::isfinite(work)) return "its numbers are too large to compute with";
    works.emplace_back(work);
  }
  const InfeasibilityProof proof(model_, bounds_, std::move(rest));
  return proof.check_margins(w.values, w.error, {}, works);
}

std::optional<std::string> InfeasibilityProof::refusal_of_constrained() const {
  const auto all = first_numbers(block_.dimension * model_.candidates());
  std::vector<double> y(all.size(), 0);
  for (std::size_t k = 0; k < model_.candidates(); ++k) {
    auto& own = y[block_.dimension * k];
    own = combination_.multipliers[k];
    // The recorded value up to rounding, and at least the coefficient of u_n >= 0 and the cut.
    if (!combination_.of_cuts.empty() && !contains(combination_.contact, k)) {
      own = std::max(own, not_below(Dyadic() - shares_[k]));
    }
    if (!std::isfinite(own)) return "its numbers are too large to compute with";
  }
  return model_.first_regularised().solve(all, DyadicList(y),
                                          [&](const auto& w, const auto& nu, const auto& off) {
                                            return check_constrained(w, nu, off);
                                          });
}

// w with K w = nu close to y, plus a rigid-body mode, which does no work in equilibrium.
std::optional<std::string> InfeasibilityProof::check_unconstrained(const Multipliers& y,
                                                                   const std::vector<double>& mean,
                                                                   const DyadicList& w,
                                                                   const DyadicList& nu,
                                                                   const Dyadic& off) const {
  std::vector<Rationals> motions_of_block = Elimination(model_.motions()).basis();
  const auto shift =
      restricted_to_candidates(block_.motions, model_.missing_motion(mean, w, motions_of_block));
  auto moved = w;
  moved += shift.values;
  std::vector<Dyadic> forces;
  for (std::size_t k = 0; k < model_.candidates(); ++k)
    forces.push_back(y.near.values[block_.dimension * k]);
  const auto works = works_above(moved, shift.error, forces, y.near.error);
  moved += reaction_shares();
  const Dyadic count(static_cast<double>(w.size()));
  Dyadic square_sum;
  for (std::size_t k = 0; k < w.size(); ++k)
    square_sum = square_sum + square(nu[k] - y.near.values[k]);
  const auto epsilon = sqrt_above(square_sum) + count * y.near.error + off +
                       Dyadic(largest_displacement_ratio) * y.carried;
  return check_margins(moved, shift.error, epsilon, works);
}

// sum_k w~_k'r_k + sum_j L_j tau_j >= sum_k (nu_nk + eta_k A_k - theta [k = i, separated]) u_nk +
// nu_t'u_t. A coefficient that is negative by rounding belongs to epsilon.
std::optional<std::string> InfeasibilityProof::check_constrained(const DyadicList& w,
                                                                 const DyadicList& nu,
                                                                 const Dyadic& off) const {
  Dyadic epsilon_squared;
  std::vector<Dyadic> forces;
  for (std::size_t k = 0; k < model_.candidates(); ++k) {
    epsilon_squared = epsilon_squared + model_.tangential_square(nu, k);
    auto normal = nu[block_.dimension * k] + shares_[k];
    const bool negative = !contains(combination_.contact, k) && normal.sign() < 0;
    if (negative) epsilon_squared = epsilon_squared + square(normal);
    forces.push_back((negative ? Dyadic() : std::move(normal)) - shares_[k]);
  }
  const auto works = works_above(w, {}, forces, {});
  auto lifted = w;
  lifted += reaction_shares();
  return check_margins(lifted, {}, sqrt_above(epsilon_squared) + off, works);
}

// w'r + sum_j L_j tau_j >= -epsilon |u|, where each number of w has an error up to `error`, and
// |u| <= (|r| + sum_j |f_j| tau_j) / s.
std::optional<std::string> InfeasibilityProof::check_margins(
    const DyadicList& w, const Dyadic& error, const Dyadic& epsilon,
    const std::vector<Dyadic>& works) const {
  const auto d = block_.dimension;
  constexpr auto too_little = "the margin of its multipliers is within the rounding errors";
  std::optional<Dyadic> delta;
  for (std::size_t i = 0; i < model_.candidates(); ++i) {
    if (contains(combination_.separated, i)) continue;
    const auto margin = Dyadic{} - w[d * i] - model_.slip_above(w, i, error);
    if (margin.sign() <= 0) {
      return "its multipliers do not rule out a reaction at " + block_.names[i];
    }
    if (!delta || margin < *delta) delta = margin;
  }
  if (delta && !(*delta * *model_.min_eigenvalue() > epsilon * model_.steepest()))
    return too_little;
  for (std::size_t j = 0; j < works.size(); ++j) {
    if (works[j].sign() >= 0) return "its multipliers do not rule out the load";
    const auto& load = combination_.loads[j];
    const auto size = norm_above(load.forces) + load.error;
    if (!((Dyadic() - works[j]) * *model_.min_eigenvalue() > epsilon * size)) return too_little;
  }
  return {};
}

// L_j = w'f_j + sum_k y_k g_jk + c_j (sum_l eta_l - theta beta), minus the share of the grip.
std::vector<Dyadic> InfeasibilityProof::works_above(const DyadicList& w, const Dyadic& w_error,
                                                    const std::vector<Dyadic>& y,
                                                    const Dyadic& y_error) const {
  std::vector<Dyadic> works;
  if (combination_.loads.empty()) return works;
  const auto w_size = norm_above(w) + w_error * Dyadic(static_cast<double>(w.size()));
  const auto of_sum = sum_share();
  for (const auto& load : combination_.loads) {
    auto sum = w_size * load.error + of_sum * load.weight;
    for (std::size_t k = 0; k < w.size(); ++k)
      sum = sum + w[k] * load.forces[k] + w_error * absolute(load.forces[k]);
    for (std::size_t k = 0; k < model_.candidates(); ++k)
      sum = sum + y[k] * load.gaps[k] + y_error * absolute(load.gaps[k]);
    if (combination_.grip) {
      sum = sum -
            Dyadic(combination_.grip->multiplier) * Dyadic(combination_.grip->total) * load.dead;
    }
    works.push_back(std::move(sum));
  }
  return works;
}

// Coefficient of v_nk in the inequalities, beside nu_nk.
Dyadic InfeasibilityProof::displacement_share(std::size_t k) const {
  if (combination_.of_cuts.empty()) return {};
  const auto& opposite = combination_.opposite;
  const auto cut = Dyadic(combination_.of_cuts[k]) * bounds_.gap_share(k);
  const bool opposed = opposite && opposite->side == Side::separated && opposite->candidate == k;
  return opposed ? cut - opposite->multiplier : cut;
}

// sum_l eta_l - theta beta.
Dyadic InfeasibilityProof::sum_share() const {
  Dyadic sum;
  for (const double eta : combination_.of_cuts) sum = sum + Dyadic(eta);
  return combination_.opposite ? sum - combination_.opposite->of_sum : sum;
}

// w~ - w: the shares of s and of the grip, - eta_k B_k + theta [k = i, in contact] at the normals.
DyadicList InfeasibilityProof::reaction_shares() const {
  const auto d = block_.dimension;
  const auto& [of_cuts, opposite, grip] =
      std::tie(combination_.of_cuts, combination_.opposite, combination_.grip);
  auto everywhere = sum_share();
  if (grip) everywhere = everywhere + Dyadic(grip->multiplier);
  std::vector<Dyadic> shares(d * model_.candidates());
  for (std::size_t k = 0; k < model_.candidates(); ++k) {
    auto& own = shares[d * k];
    own = everywhere;
    if (!of_cuts.empty()) own = own - Dyadic(of_cuts[k]) * bounds_.reaction_share(k);
    if (opposite && opposite->side == Side::contact && opposite->candidate == k)
      own = own + opposite->multiplier;
  }
  return DyadicList(shares);
}

}  // namespace kusabi::verify
